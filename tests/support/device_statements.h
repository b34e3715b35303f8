#pragma once

#include "ops/device_local_map.h"
#include "support/oracle_compare.h"

#include <cstdint>
#include <span>

namespace zonegrid {

/// What a device's local map says, as `statements_of` tells it of the reference's. `places`: the
/// zones that were reserved in it.
[[nodiscard]] oracle::CellValues statements_of(const ops::DeviceLocalMap& local_map,
                                               std::span<const std::uint32_t> places,
                                               const Window& window);

} // namespace zonegrid
