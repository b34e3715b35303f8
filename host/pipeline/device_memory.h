#pragma once

#include "model/window.h"

#include <cstdint>
#include <optional>

namespace zonegrid {

/// Bytes of a device's buffers that hold all that it says of one zone's objects, however many:
/// labels, measures, trees.
[[nodiscard]] std::uint64_t object_bytes_at_most(std::int32_t zone_edge);

/// Bytes of a device's buffers that hold a map whatever is seen: every zone of the window, a local
/// map of all of them, the objects of one, and an image of so many pixels. Maps take a fraction of
/// it as a rule.
[[nodiscard]] std::uint64_t device_bytes_at_most(const Window& window, std::uint64_t pixels);

/// Longest range, metres, with which a map with the other options surely fits into so many bytes;
/// nothing if none does.
[[nodiscard]] std::optional<double> longest_range_m(const MapperOptions& options,
                                                    const std::optional<Camera>& camera,
                                                    std::uint64_t bytes);

} // namespace zonegrid
