#pragma once

#include "device/device.h"
#include "device/opencl_api.h"

#include <string>
#include <vector>

namespace zonegrid::device {

struct OpenClDevices {
    std::vector<cl_device_id> devices; ///< in the order of `list.devices`
    DeviceList list;
};

/// The devices of all platforms.
[[nodiscard]] OpenClDevices find_opencl_devices(const OpenClApi& api);

/// All texts that tell a device and its driver from others; a compiled kernel is for these alone.
[[nodiscard]] std::vector<std::string> opencl_identity(const OpenClApi& api, cl_device_id device);

} // namespace zonegrid::device
