#include "io/map_comparison.h"

#include "io/sha256.h"
#include "model/lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

namespace zonegrid {
namespace {

struct CellValue {
    CellIndex cell;
    std::int32_t value = 0;
    friend auto operator<=>(const CellValue&, const CellValue&) = default;
};

std::vector<CellValue> cells_of(const Mapper& mapper) {
    std::vector<CellValue> cells;
    mapper.for_each_cell([&](const CellIndex& cell, int value) { cells.push_back({cell, value}); });
    return cells;
}

template <class Element>
void add_bytes(Sha256& sum, std::span<const Element> elements) {
    static_assert(std::has_unique_object_representations_v<Element>);
    const auto bytes = std::as_bytes(elements);
    sum.add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::string digest_of(Mapper& mapper) {
    Sha256 sum;
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

std::string text_of(const CellIndex& cell) {
    return fmt::format("({}, {}, {})", cell.x, cell.y, cell.z);
}

/// Empty if both hold the same cells.
std::string difference_of_cells(const Mapper& expected, const Mapper& actual) {
    const auto before = cells_of(expected);
    const auto after = cells_of(actual);
    std::vector<CellValue> missing;
    std::vector<CellValue> surplus;
    std::ranges::set_difference(before, after, std::back_inserter(missing));
    std::ranges::set_difference(after, before, std::back_inserter(surplus));
    if (missing.empty() && surplus.empty()) {
        return "";
    }
    CellIndex first = missing.empty() ? surplus.front().cell : missing.front().cell;
    if (!surplus.empty()) {
        first = std::min(first, surplus.front().cell);
    }
    std::vector<CellIndex> cells;
    for (const auto* const list : {&missing, &surplus}) {
        for (const auto& entry : *list) {
            cells.push_back(entry.cell);
        }
    }
    std::ranges::sort(cells);
    const auto repeated = std::ranges::unique(cells);
    cells.erase(repeated.begin(), repeated.end());
    const ZoneIndex zone = zone_of(first, expected.options().zone);
    return fmt::format("first cell {} in zone ({}, {}, {}): value {}, expected {}; {} cells differ",
                       text_of(first), zone.x, zone.y, zone.z, actual.value(first),
                       expected.value(first), cells.size());
}

std::string difference_of_objects(Mapper& expected, Mapper& actual) {
    const auto before = expected.objects();
    const auto after = actual.objects();
    const auto [one, other] = std::ranges::mismatch(before, after);
    if (one == before.end() && other == after.end()) {
        return "";
    }
    const auto name = [](const auto& place, const auto& list) {
        return place == list.end() ? std::string("none") : text_of(place->id);
    };
    return fmt::format("object {} of {}: {}, expected {} of {}", one - before.begin(), after.size(),
                       name(other, after), name(one, before), before.size());
}

std::string difference_of_profiles(const Mapper& expected, const Mapper& actual) {
    const auto before = expected.height_profile().columns;
    const auto after = actual.height_profile().columns;
    const auto [one, other] = std::ranges::mismatch(before, after);
    if (one == before.end() && other == after.end()) {
        return "";
    }
    const auto name = [](const auto& place, const auto& list) {
        return place == list.end() ? std::string("none")
                                   : fmt::format("({}, {}, {})", place->x, place->y, place->z);
    };
    return fmt::format("column {}: {}, expected {}", one - before.begin(), name(other, after),
                       name(one, before));
}

/// Makes both maps again from the first `images` images, and looks at all they hold.
MapDifference explain(const Recording& recording, const FrameSpan& span, std::size_t images,
                      const MapperOptions& expected_options, const MapperOptions& options,
                      const ReplayObserver& observer) {
    const FrameSpan part{span.first, span.first + images};
    Mapper expected(expected_options, recording.camera());
    const auto before = step_of(replay(recording, part, expected, observer));
    Mapper actual(options, recording.camera());
    const auto after = step_of(replay(recording, part, actual, observer));
    MapDifference difference;
    difference.images = images;
    if (images > 0) {
        difference.frame = recording.frames()[part.last - 1].file.string();
    }
    const std::pair<const char*, std::string> found[] = {
        {"cells", difference_of_cells(expected, actual)},
        {"objects", difference_of_objects(expected, actual)},
        {"height profile", difference_of_profiles(expected, actual)}};
    for (const auto& [what, detail] : found) {
        if (!detail.empty()) {
            difference.what = what;
            difference.detail = detail;
            return difference;
        }
    }
    difference.what = "counts";
    difference.detail = fmt::format(
        "cells changed so far {}, expected {}; zones entered {}, expected {}; zones left {}, "
        "expected {}",
        after.cells_changed, before.cells_changed, after.zones_entered, before.zones_entered,
        after.zones_left, before.zones_left);
    return difference;
}

/// Number of the first step that differs; the number of steps if none does.
std::size_t first_difference(const std::vector<MapStep>& expected,
                             const std::vector<MapStep>& actual) {
    return static_cast<std::size_t>(std::ranges::mismatch(expected, actual).in1 - expected.begin());
}

} // namespace

std::vector<MapStep> take_steps(const Recording& recording, const FrameSpan& span,
                                const MapperOptions& options, std::size_t every,
                                const ReplayObserver& observer) {
    Mapper mapper(options, recording.camera());
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
                                             const MapperOptions& expected_options,
                                             const std::vector<MapStep>& expected,
                                             const MapperOptions& options, std::size_t every,
                                             const ReplayObserver& observer) {
    const auto actual = take_steps(recording, span, options, every, observer);
    std::size_t images = first_difference(expected, actual);
    if (images == expected.size()) {
        return std::nullopt;
    }
    // Counts tell of every image, digests only of some: look at each image up to here.
    const FrameSpan part{span.first, span.first + images};
    images = std::min(images,
                      first_difference(take_steps(recording, part, expected_options, 1, observer),
                                       take_steps(recording, part, options, 1, observer)));
    return explain(recording, span, images, expected_options, options, observer);
}

} // namespace zonegrid
