#include "io/map_comparison.h"

#include "io/map_difference.h"
#include "io/sha256.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <type_traits>

namespace zonegrid {
namespace {

template <class Element>
void add_bytes(Sha256& sum, std::span<const Element> elements) {
    static_assert(std::has_unique_object_representations_v<Element>);
    const auto bytes = std::as_bytes(elements);
    sum.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::string digest_of(Mapper& mapper) {
    Sha256 sum;
    const auto statements = statements_of(mapper);
    add_bytes(sum, std::span(statements));
    const auto cells = cells_of(mapper);
    add_bytes(sum, std::span(cells));
    for (const Object& object : mapper.objects()) {
        add_bytes(sum, std::span(&object.id, 1));
        add_bytes(sum, std::span(&object.cell_count, 1));
        add_bytes(sum, std::span(&object.box_min, 1));
        add_bytes(sum, std::span(&object.box_max, 1));
        add_bytes(sum, std::span<const std::int64_t>(object.cell_sum));
        sum.add(std::span(object.octree));
        sum.add(std::span(object.prism));
    }
    const auto columns = mapper.height_profile().columns;
    add_bytes(sum, std::span(columns));
    return sum.finish_hex();
}

MapStep step_of(const ReplaySummary& summary) {
    return {summary.cells_changed, summary.zones_entered, summary.zones_left, ""};
}

/// Makes both maps again from the first `images` images, and looks at all they hold.
MapDifference explain(const Recording& recording, const FrameSpan& span, std::size_t images,
                      const MapRecipe& expected_recipe, const MapRecipe& actual_recipe,
                      const ReplayObserver& observer) {
    const auto replayed = [&](std::size_t count, Mapper& mapper) {
        return step_of(replay(recording, {span.first, span.first + count}, mapper, observer));
    };
    Mapper before = expected_recipe.make(recording.camera());
    const MapStep previous = replayed(images > 0 ? images - 1 : 0, before);
    Mapper expected = expected_recipe.make(recording.camera());
    const MapStep right = replayed(images, expected);
    Mapper actual = actual_recipe.make(recording.camera());
    const MapStep wrong = replayed(images, actual);
    const LastImage last{before, right.zones_entered != previous.zones_entered,
                         recording.camera() ? "integrate_image" : "integrate_scan"};
    MapDifference difference = difference_of_maps(last, expected, actual);
    difference.images = images;
    if (images > 0) {
        difference.frame = recording.frames()[span.first + images - 1].file.string();
    }
    if (difference.what.empty() && right == wrong) {
        difference.what = "two runs";
        difference.operation = "any";
        difference.detail =
            "the maps are equal when they are made again: the device does not always give the same";
    } else if (difference.what.empty()) {
        difference.what = "counts";
        difference.operation =
            wrong.cells_changed != right.cells_changed ? "fuse_local_map" : "the window's moves";
        difference.detail = fmt::format(
            "cells changed so far {}, expected {}; zones entered {}, expected {}; zones left {}, "
            "expected {}",
            wrong.cells_changed, right.cells_changed, wrong.zones_entered, right.zones_entered,
            wrong.zones_left, right.zones_left);
    }
    return difference;
}

/// Number of the first step that differs; the number of steps if none does.
std::size_t first_difference(const std::vector<MapStep>& expected,
                             const std::vector<MapStep>& actual) {
    return static_cast<std::size_t>(std::ranges::mismatch(expected, actual).in1 - expected.begin());
}

} // namespace

Mapper MapRecipe::make(const std::optional<Camera>& camera) const {
    return engine ? Mapper(options, camera, engine) : Mapper(options, camera);
}

std::vector<MapStep> take_steps(const Recording& recording, const FrameSpan& span,
                                const MapRecipe& recipe, std::size_t every,
                                const ReplayObserver& observer) {
    Mapper mapper = recipe.make(recording.camera());
    std::vector<MapStep> steps;
    const auto summary = replay(recording, span, mapper, [&](const ReplaySummary& so_far) {
        observer(so_far);
        steps.push_back(step_of(so_far));
        if (so_far.images % every == 0) {
            steps.back().digest = digest_of(mapper);
        }
    });
    steps.back().digest = digest_of(mapper);
    return steps;
}

std::optional<MapDifference> find_difference(const Recording& recording, const FrameSpan& span,
                                             const MapRecipe& expected,
                                             const std::vector<MapStep>& steps,
                                             const MapRecipe& actual, std::size_t every,
                                             const ReplayObserver& observer) {
    std::size_t images =
        first_difference(steps, take_steps(recording, span, actual, every, observer));
    if (images == steps.size()) {
        return std::nullopt;
    }
    // Counts tell of every image, digests only of some: look at each image up to here.
    const FrameSpan part{span.first, span.first + images};
    images = std::min(images, first_difference(take_steps(recording, part, expected, 1, observer),
                                               take_steps(recording, part, actual, 1, observer)));
    return explain(recording, span, images, expected, actual, observer);
}

} // namespace zonegrid
