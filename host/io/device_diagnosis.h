#pragma once

#include "device/device.h"
#include "io/device_check.h"
#include "io/device_files.h"
#include "io/installed_drivers.h"

#include <string>
#include <vector>

namespace zonegrid {

/// A device that was found, and what its self-test said; a refused one is not tested.
struct ExaminedDevice {
    device::DeviceInfo info;
    SelfTest test;

    [[nodiscard]] bool refused() const { return !info.refusal.empty(); }
    [[nodiscard]] bool passed() const { return !refused() && test.passed(); }
    [[nodiscard]] bool failed() const { return !refused() && !test.passed(); }
};

/// Everything between zonegrid and the devices of a machine.
struct DeviceDiagnosis {
    std::vector<InstalledDrivers> drivers; ///< OpenCL's, Vulkan's
    std::vector<DeviceFile> files;
    std::vector<std::string> missing; ///< as `list_devices` gives it
    std::vector<ExaminedDevice> devices;
};

/// Something that is wrong, and what to do about it.
struct DeviceProblem {
    std::string problem;
    std::string remedy;
};

/// All that keeps devices from being used or trusted, each with its remedy.
[[nodiscard]] std::vector<DeviceProblem> find_problems(const DeviceDiagnosis& diagnosis);

/// The outcome in one sentence.
[[nodiscard]] std::string verdict_on(const DeviceDiagnosis& diagnosis);

} // namespace zonegrid
