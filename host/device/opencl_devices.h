#pragma once

#include "device/device.h"
#include "device/opencl_api.h"

#include <vector>

namespace zonegrid::device {

struct OpenClDevices {
    std::vector<cl_device_id> devices; ///< in the order of `list.devices`
    DeviceList list;
};

/// The devices of all platforms.
[[nodiscard]] OpenClDevices find_opencl_devices(const OpenClApi& api);

} // namespace zonegrid::device
