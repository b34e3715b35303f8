#pragma once

#include "device/device.h"

#include <memory>

namespace zonegrid::device {

/// What a backend lists; `index` of each device is its place. May throw: then the backend is
/// missing.
[[nodiscard]] DeviceList list_opencl_devices();
[[nodiscard]] DeviceList list_vulkan_devices();

/// Opens the device that `info`, from the list above, describes and does not refuse.
[[nodiscard]] std::unique_ptr<Device> open_opencl_device(const DeviceInfo& info,
                                                         const DeviceOptions& options);
[[nodiscard]] std::unique_ptr<Device> open_vulkan_device(const DeviceInfo& info,
                                                         const DeviceOptions& options);

} // namespace zonegrid::device
