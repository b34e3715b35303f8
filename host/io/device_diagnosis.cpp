#include "io/device_diagnosis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace zonegrid {
namespace {

using Problems = std::vector<DeviceProblem>;

/// What Debian and Ubuntu call the packages of a backend.
struct Packages {
    const char* loader;
    const char* driver;
};

Packages packages_of(const std::string& backend) {
    return backend == "opencl" ? Packages{"ocl-icd-libopencl1", "pocl-opencl-icd"}
                               : Packages{"libvulkan1", "mesa-vulkan-drivers"};
}

void add_loader_problem(const DriverLoader& loader, Problems& problems) {
    if (loader.problem.empty()) {
        return;
    }
    const std::string remedy =
        loader.variable.empty()
            ? fmt::format("sudo apt install {}", packages_of(loader.backend).loader)
            : fmt::format("unset {}, or name a library that exists", loader.variable);
    problems.push_back({fmt::format("{}: the loader {} cannot be loaded ({})", loader.backend,
                                    loader.library, loader.problem),
                        remedy});
}

void add_driver_problems(const InstalledDrivers& drivers, Problems& problems) {
    const auto& backend = drivers.loader.backend;
    for (const DriverFile& driver : drivers.files) {
        if (driver.problem.empty() || driver.foreign) {
            continue;
        }
        const std::string file = driver.file.string();
        if (driver.library.empty()) {
            problems.push_back({fmt::format("{}: {}: {}", backend, file, driver.problem),
                                fmt::format("check that {} exists, is readable by everyone and "
                                            "comes from the driver's package",
                                            file)});
        } else {
            problems.push_back(
                {fmt::format("{}: {} names {}, which cannot be loaded ({})", backend, file,
                             driver.library, driver.problem),
                 fmt::format("reinstall the package that {} belongs to (dpkg -S {}), or remove it",
                             file, file)});
        }
    }
    if (drivers.files.empty() && drivers.loader.problem.empty()) {
        problems.push_back(
            {fmt::format("{}: no driver is installed", backend),
             fmt::format("install the driver of your GPU, or, for the processor: sudo apt install "
                         "{}",
                         packages_of(backend).driver)});
    }
}

std::string remedy_for(const DeviceFile& file) {
    // Group root would give away more than the device.
    if (file.group_may && file.group != "root") {
        return fmt::format("sudo usermod -aG {} $USER, then log in again", file.group);
    }
    return fmt::format(
        "it belongs to user {} and group {}: allow it to a group such as render "
        "(udev rule), or hand the device to the container",
        file.owner, file.group);
}

void add_file_problems(const std::vector<DeviceFile>& files, Problems& problems) {
    for (const DeviceFile& file : files) {
        if (!file.usable()) {
            problems.push_back({fmt::format("{}: this user cannot {} it", file.file.string(),
                                            file.readable ? "write" : "read"),
                                remedy_for(file)});
        }
    }
}

/// What the backend itself complains of, unless its cause was found above.
void add_missing(const std::string& sentence, Problems& problems) {
    const std::string backend = sentence.substr(0, sentence.find(':') + 1);
    const bool explained = std::ranges::any_of(
        problems, [&](const DeviceProblem& known) { return known.problem.starts_with(backend); });
    if (!explained) {
        const std::size_t end = sentence.find("; ");
        problems.push_back({sentence.substr(0, end), end == std::string::npos
                                                         ? "see docs/backends.md"
                                                         : sentence.substr(end + 2)});
    }
}

void add_device_problem(const ExaminedDevice& examined, Problems& problems) {
    const auto& info = examined.info;
    if (examined.refused()) {
        problems.push_back(
            {fmt::format("{} ({}) is refused: {}", info.id(), info.name, info.refusal),
             fmt::format("use another device, or a newer driver than {}", info.driver)});
    } else if (examined.failed()) {
        problems.push_back(
            {fmt::format("{} ({}) fails its self-test: {}", info.id(), info.name,
                         examined.test.problem),
             fmt::format("do not map with it; try another driver than {}, and report this with "
                         "what zonegrid check --generated 1 --device {} says",
                         info.driver, info.id())});
    }
}

} // namespace

std::vector<DeviceProblem> find_problems(const DeviceDiagnosis& diagnosis) {
    Problems problems;
    for (const InstalledDrivers& drivers : diagnosis.drivers) {
        add_loader_problem(drivers.loader, problems);
        add_driver_problems(drivers, problems);
    }
    add_file_problems(diagnosis.files, problems);
    for (const std::string& sentence : diagnosis.missing) {
        add_missing(sentence, problems);
    }
    for (const ExaminedDevice& examined : diagnosis.devices) {
        add_device_problem(examined, problems);
    }
    return problems;
}

std::string verdict_on(const DeviceDiagnosis& diagnosis) {
    std::vector<std::string> passed;
    std::vector<std::string> failed;
    for (const ExaminedDevice& examined : diagnosis.devices) {
        if (examined.passed()) {
            passed.push_back(examined.info.id());
        } else if (examined.failed()) {
            failed.push_back(examined.info.id());
        }
    }
    if (!failed.empty()) {
        return fmt::format("{}: not the reference's map; do not map with {}",
                           fmt::join(failed, ", "), failed.size() == 1 ? "it" : "them");
    }
    if (passed.empty()) {
        return "no device can be used; maps are still made by the reference backend, which needs "
               "none";
    }
    return fmt::format("{}: the reference's map, bit for bit", fmt::join(passed, ", "));
}

} // namespace zonegrid
