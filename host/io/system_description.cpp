#include "io/system_description.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <thread>

namespace zonegrid {
namespace {

/// The value of the first line of `file` that starts with `name`; empty if there is none.
std::string value_in(const char* file, std::string_view name, char separator) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const std::size_t at = line.find(separator);
        if (!line.starts_with(name) || at == std::string::npos) {
            continue;
        }
        std::string value = line.substr(at + 1);
        std::erase(value, '"');
        value.erase(0, std::min(value.find_first_not_of(" \t"), value.size()));
        return value;
    }
    return "";
}

std::string describe_processor(const std::string& machine) {
    // x86 calls it "model name"; ARM boards have "Model" or "Hardware", or nothing.
    for (const char* const name : {"model name", "Model", "Hardware"}) {
        std::string value = value_in("/proc/cpuinfo", name, ':');
        if (!value.empty()) {
            return value;
        }
    }
    return machine;
}

std::vector<std::pair<std::string, std::string>> driver_variables() {
    constexpr std::array<std::string_view, 8> prefixes{
        "ZONEGRID_", "OCL_ICD_", "OPENCL_", "VK_", "POCL_", "RUSTICL_", "MESA_", "LD_LIBRARY_PATH"};
    std::vector<std::pair<std::string, std::string>> variables;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text = *entry;
        const std::size_t at = text.find('=');
        const bool wanted = std::ranges::any_of(
            prefixes, [text](std::string_view prefix) { return text.starts_with(prefix); });
        if (wanted && at != std::string_view::npos) {
            variables.emplace_back(text.substr(0, at), text.substr(at + 1));
        }
    }
    std::ranges::sort(variables);
    return variables;
}

} // namespace

SystemDescription describe_system() {
    SystemDescription description;
    description.system = value_in("/etc/os-release", "PRETTY_NAME", '=');
    if (description.system.empty()) {
        description.system = "a system without /etc/os-release";
    }
    utsname names{};
    if (::uname(&names) == 0) {
        description.kernel =
            fmt::format("{} {} {}", &names.sysname[0], &names.release[0], &names.machine[0]);
    }
    description.processor = describe_processor(&names.machine[0]);
    description.processors = std::thread::hardware_concurrency();
    description.variables = driver_variables();
    return description;
}

} // namespace zonegrid
