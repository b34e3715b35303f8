#include "io/installed_drivers.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

namespace zonegrid {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> variable_of(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>(value);
}

/// Where a library was found, or why it was not.
struct FoundLibrary {
    std::string file;
    std::string problem;
};

FoundLibrary find_library(const std::string& library) {
    // Drivers start threads and register exit handlers: their code must stay in memory.
    const std::unique_ptr<void, int (*)(void*)> handle(
        dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE), &dlclose);
    if (!handle) {
        const char* const reason = dlerror();
        return {"", reason == nullptr ? "no reason given" : reason};
    }
    const link_map* map = nullptr;
    const bool known = dlinfo(handle.get(), RTLD_DI_LINKMAP, static_cast<void*>(&map)) == 0;
    return {known && map != nullptr ? map->l_name : library, ""};
}

DriverLoader find_loader(std::string backend, const char* variable, const char* library) {
    DriverLoader loader;
    loader.backend = std::move(backend);
    const auto chosen = variable_of(variable);
    loader.variable = chosen ? variable : "";
    loader.library = chosen.value_or(library);
    const FoundLibrary found = find_library(loader.library);
    loader.file = found.file;
    loader.problem = found.problem;
    return loader;
}

/// The files in a folder whose names end so, sorted; a file is taken as it is.
std::vector<fs::path> files_in(const fs::path& place, std::string_view ending) {
    std::error_code error;
    if (!fs::is_directory(place, error)) {
        return fs::exists(place, error) ? std::vector<fs::path>{place} : std::vector<fs::path>{};
    }
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(place, error); !error && entry != fs::directory_iterator{};
         entry.increment(error)) {
        if (entry->path().extension() == ending) {
            files.push_back(entry->path());
        }
    }
    std::ranges::sort(files);
    return files;
}

std::vector<fs::path> split_at_colons(std::string_view text) {
    std::vector<fs::path> places;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(':'), text.size());
        if (length > 0) {
            places.emplace_back(text.substr(0, length));
        }
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return places;
}

std::optional<std::string> text_in(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return std::nullopt;
    }
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

void try_library(DriverFile& driver) {
    driver.problem = find_library(driver.library).problem;
    driver.foreign = driver.problem.find("wrong ELF class") != std::string::npos;
}

DriverFile read_icd(const fs::path& file) {
    DriverFile driver{"opencl", file, "", "", false};
    const auto text = text_in(file);
    if (!text) {
        driver.problem = "it cannot be read";
        return driver;
    }
    driver.library = text->substr(0, text->find_first_of("\r\n"));
    if (driver.library.empty()) {
        driver.problem = "it names no library";
        return driver;
    }
    try_library(driver);
    return driver;
}

DriverFile read_manifest(const fs::path& file) {
    DriverFile driver{"vulkan", file, "", "", false};
    const auto text = text_in(file);
    if (!text) {
        driver.problem = "it cannot be read";
        return driver;
    }
    const auto json = nlohmann::json::parse(*text, nullptr, false);
    if (!json.is_object() || !json.contains("ICD") || !json["ICD"].is_object() ||
        !json["ICD"].contains("library_path") || !json["ICD"]["library_path"].is_string()) {
        driver.problem = "it is no JSON that names ICD.library_path";
        return driver;
    }
    driver.library = json["ICD"]["library_path"].get<std::string>();
    // A name without a slash is looked for by the system, a path from the manifest's folder.
    if (driver.library.find('/') != std::string::npos) {
        driver.library = (file.parent_path() / driver.library).string();
    }
    try_library(driver);
    return driver;
}

} // namespace

InstalledDrivers find_opencl_drivers() {
    InstalledDrivers drivers;
    drivers.loader = find_loader("opencl", "ZONEGRID_OPENCL_LIBRARY", "libOpenCL.so.1");
    drivers.places = {variable_of("OCL_ICD_VENDORS").value_or("/etc/OpenCL/vendors")};
    for (const fs::path& file : files_in(drivers.places.front(), ".icd")) {
        drivers.files.push_back(read_icd(file));
    }
    return drivers;
}

InstalledDrivers find_vulkan_drivers() {
    InstalledDrivers drivers;
    drivers.loader = find_loader("vulkan", "ZONEGRID_VULKAN_LIBRARY", "libvulkan.so.1");
    auto chosen = variable_of("VK_DRIVER_FILES");
    chosen = chosen ? chosen : variable_of("VK_ICD_FILENAMES");
    if (chosen) {
        drivers.places = split_at_colons(*chosen);
    } else {
        drivers.places = {"/etc/vulkan/icd.d", "/usr/local/share/vulkan/icd.d",
                          "/usr/share/vulkan/icd.d"};
    }
    for (const fs::path& place : drivers.places) {
        std::error_code error;
        if (chosen && !fs::exists(place, error)) {
            drivers.files.push_back({"vulkan", place, "", "there is no such file", false});
        }
        for (const fs::path& file : files_in(place, ".json")) {
            drivers.files.push_back(read_manifest(file));
        }
    }
    return drivers;
}

} // namespace zonegrid
