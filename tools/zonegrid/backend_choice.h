#pragma once

#include "device/device.h"
#include "map_settings.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace zonegrid {

/// What --backend and --device come to on this machine.
struct BackendChoice {
    std::string asked;                        ///< as the user gave it
    std::string backend = "reference";        ///< for MapperOptions: "reference" or a device's id
    std::optional<device::DeviceInfo> device; ///< absent: the reference
    std::string reason;                       ///< of --backend auto: why this one; else empty
};

/// Looks for the devices that the settings name. With --backend auto each usable device, GPUs
/// first, makes a small map until one makes the reference's; if none does, the reference is chosen.
/// Throws UsageError if the two contradict each other or name several devices, DeviceError if there
/// is none.
[[nodiscard]] BackendChoice choose_backend(const MapSettings& settings);

/// What report.json says of it.
[[nodiscard]] nlohmann::ordered_json backend_json(const BackendChoice& choice);

} // namespace zonegrid
