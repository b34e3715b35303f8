#pragma once

#include "io/replay.h"
#include "zonegrid/mapper.h"
#include "zonegrid/options.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zonegrid {

/// How to make a map: with which options, and on which engine if it is none of the library's.
struct MapRecipe {
    MapperOptions options;
    GridEngineMaker engine{};

    /// A map without cells. Throws what the Mapper throws.
    [[nodiscard]] Mapper make(const std::optional<Camera>& camera) const;
};

/// What a map was after so many images.
struct MapStep {
    std::uint64_t cells_changed = 0; ///< summed over the images so far
    std::uint64_t zones_entered = 0;
    std::uint64_t zones_left = 0;
    std::string digest; ///< of local map, cells, objects and profile; empty where it was not taken
    friend bool operator==(const MapStep&, const MapStep&) = default;
};

/// Where two maps of one recording part.
struct MapDifference {
    std::size_t images = 0; ///< after so many images of the span; equal after one fewer
    std::string frame;      ///< file of the last of them
    std::string what;       ///< "local map", "cells", "objects", "height profile", "counts" or
                            ///< "two runs"
    std::string operation;  ///< whose work it is, as far as the values tell (docs/model.md)
    std::string detail;     ///< for a person: the first place, both values, how many differ
};

/// Steps of a map, from 0 images to all of `span`; a digest after every `every`-th image and after
/// the last. Throws what the replay and the observer throw.
[[nodiscard]] std::vector<MapStep> take_steps(const Recording& recording, const FrameSpan& span,
                                              const MapRecipe& recipe, std::size_t every,
                                              const ReplayObserver& observer);

/// The first image after which a map made by `actual` differs from the one made by `expected`,
/// whose steps are `steps`; nothing if there is none. Where digests differ, both maps are made
/// again to find image and cell.
[[nodiscard]] std::optional<MapDifference> find_difference(
    const Recording& recording, const FrameSpan& span, const MapRecipe& expected,
    const std::vector<MapStep>& steps, const MapRecipe& actual, std::size_t every,
    const ReplayObserver& observer);

} // namespace zonegrid
