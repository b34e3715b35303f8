#pragma once

#include "io/replay.h"
#include "zonegrid/options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

/// What a map was after so many images.
struct MapStep {
    std::uint64_t cells_changed = 0; ///< summed over the images so far
    std::uint64_t zones_entered = 0;
    std::uint64_t zones_left = 0;
    std::string digest; ///< of cells, objects and profile; empty where it was not taken
    friend bool operator==(const MapStep&, const MapStep&) = default;
};

/// Where two maps of one recording part.
struct MapDifference {
    std::size_t images = 0; ///< after so many images of the span; equal after one fewer
    std::string frame;      ///< file of the last of them
    std::string what;       ///< "cells", "objects", "height profile" or "counts"
    std::string detail;     ///< for a person: the first place, both values, how many differ
};

/// Steps of a map, from 0 images to all of `span`; a digest after every `every`-th image and after
/// the last. Throws what the replay and the observer throw.
[[nodiscard]] std::vector<MapStep> take_steps(const Recording& recording, const FrameSpan& span,
                                              const MapperOptions& options, std::size_t every,
                                              const ReplayObserver& observer);

/// The first image after which a map made with `options` differs from the one made with
/// `expected_options`, whose steps are `expected`; nothing if there is none. Where digests
/// differ, both maps are made again to find image and cell.
[[nodiscard]] std::optional<MapDifference> find_difference(
    const Recording& recording, const FrameSpan& span, const MapperOptions& expected_options,
    const std::vector<MapStep>& expected, const MapperOptions& options, std::size_t every,
    const ReplayObserver& observer);

} // namespace zonegrid
