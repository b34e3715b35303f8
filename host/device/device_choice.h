#pragma once

#include "device/device.h"

#include <string>
#include <string_view>
#include <vector>

namespace zonegrid::device {

/// The devices of one backend, "opencl" or "vulkan"; the other's library is not looked for.
[[nodiscard]] DeviceList list_devices(std::string_view backend);

/// What was found, for a message: id, name and driver of each device, and what is missing.
[[nodiscard]] std::string describe_devices(const DeviceList& list);

/// The device that `open_device` opens by this name. Throws UsageError if it is no such name, and
/// DeviceError, saying what was found, if there is none or if it is refused.
[[nodiscard]] DeviceInfo find_device(std::string_view name);

/// The device of `list` that `wanted` names: its number within `backend`, its id ("opencl:1"), or a
/// part of its name in small or capital letters, which only one usable device may have; a name that
/// is `wanted` as a whole comes first. `backend` is "opencl" or "vulkan", or empty for both.
/// Throws DeviceError if there is none or it is refused, and UsageError if several are meant or a
/// number comes without a backend, saying what was found.
[[nodiscard]] DeviceInfo choose_device(const DeviceList& list, std::string_view backend,
                                       std::string_view wanted);

/// The devices that are not refused, as one would try them: discrete GPUs, other GPUs, the rest;
/// among equals in the list's order.
[[nodiscard]] std::vector<DeviceInfo> usable_devices(const DeviceList& list);

} // namespace zonegrid::device
