#include "io/map_difference.h"

#include "model/lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>

namespace zonegrid {
namespace {

std::string text_of(const CellIndex& cell) {
    return fmt::format("({}, {}, {})", cell.x, cell.y, cell.z);
}

bool holds(const MapStatistics& map, const CellIndex& cell) {
    const auto inside = [&](std::int32_t at, std::int32_t first) {
        return at >= first && at - first < map.window_cells;
    };
    return inside(cell.x, map.window_first_cell.x) && inside(cell.y, map.window_first_cell.y) &&
           inside(cell.z, map.window_first_cell.z);
}

/// Which operation gave a cell its wrong value, where the image says the same of all cells. In a
/// zone that may have come back with this image it may have been drawn wrongly.
std::string operation_of(const LastImage& last, const CellIndex& cell) {
    const bool drawn = last.zones_entered && !holds(last.before.statistics(), cell);
    return drawn ? "draw_objects or fuse_local_map" : "fuse_local_map";
}

/// The cells in which two sorted lists differ, each once.
std::vector<CellIndex> differing_cells(const std::vector<CellValue>& expected,
                                       const std::vector<CellValue>& actual) {
    std::vector<CellValue> entries;
    std::ranges::set_symmetric_difference(expected, actual, std::back_inserter(entries));
    std::vector<CellIndex> cells;
    std::ranges::transform(entries, std::back_inserter(cells), &CellValue::cell);
    const auto repeated = std::ranges::unique(cells);
    cells.erase(repeated.begin(), repeated.end());
    return cells;
}

std::int32_t value_in(const std::vector<CellValue>& values, const CellIndex& cell) {
    const auto found = std::ranges::lower_bound(values, cell, {}, &CellValue::cell);
    return found != values.end() && found->cell == cell ? found->value : 0;
}

/// The first cell in which two sorted lists differ, and how many do; no cell if none does.
struct DifferingCells {
    std::optional<CellIndex> first;
    std::string detail;
};

DifferingCells compare_cells(const std::vector<CellValue>& expected,
                             const std::vector<CellValue>& actual, std::int32_t zone_edge,
                             const std::function<std::string(std::int32_t)>& name_of_value) {
    const auto cells = differing_cells(expected, actual);
    if (cells.empty()) {
        return {};
    }
    const CellIndex& first = cells.front();
    const ZoneIndex zone = zone_of(first, zone_edge);
    return {
        first,
        fmt::format("first cell {} in zone ({}, {}, {}): {}, expected {}; {} cells differ",
                    text_of(first), zone.x, zone.y, zone.z, name_of_value(value_in(actual, first)),
                    name_of_value(value_in(expected, first)), cells.size())};
}

MapDifference difference_of_local_maps(const LastImage& last, const Mapper& expected,
                                       const Mapper& actual) {
    const auto found =
        compare_cells(statements_of(expected), statements_of(actual), expected.options().zone,
                      [](std::int32_t statement) -> std::string {
                          return statement == 0 ? "nothing" : statement > 0 ? "occupied" : "free";
                      });
    MapDifference difference;
    if (found.first) {
        difference.what = "local map";
        difference.operation = last.integration;
        difference.detail = found.detail;
    }
    return difference;
}

MapDifference difference_of_cells(const LastImage& last, const Mapper& expected,
                                  const Mapper& actual) {
    const auto found =
        compare_cells(cells_of(expected), cells_of(actual), expected.options().zone,
                      [](std::int32_t value) { return fmt::format("value {}", value); });
    MapDifference difference;
    if (found.first) {
        difference.what = "cells";
        difference.operation = operation_of(last, *found.first);
        difference.detail = found.detail;
    }
    return difference;
}

MapDifference difference_of_profiles(const Mapper& expected, const Mapper& actual) {
    const auto before = expected.height_profile().columns;
    const auto after = actual.height_profile().columns;
    const auto [one, other] = std::ranges::mismatch(before, after);
    if (one == before.end() && other == after.end()) {
        return {};
    }
    const auto name = [](const auto& place, const auto& list) {
        return place == list.end() ? std::string("none")
                                   : fmt::format("({}, {}, {})", place->x, place->y, place->z);
    };
    MapDifference difference;
    difference.what = "height profile";
    difference.operation = "profile_heights";
    difference.detail =
        fmt::format("column {} of {}: {}, expected {} of {}", one - before.begin(), after.size(),
                    name(other, after), name(one, before), before.size());
    return difference;
}

/// Objects come from the occupied bits that fusion keeps beside the values: where the cells are
/// equal, these may still be wrong.
std::string occupancy_or(const char* operation) {
    return fmt::format("{} or the occupied bits of fuse_local_map", operation);
}

/// How two objects of one identifier differ.
MapDifference difference_of_object(const Object& expected, const Object& actual) {
    MapDifference difference;
    difference.what = "objects";
    const auto box = [](const Object& object) {
        return text_of(object.box_min) + " to " + text_of(object.box_max);
    };
    const auto bytes = [](const char* name, const std::vector<std::uint8_t>& before,
                          const std::vector<std::uint8_t>& after) {
        const auto place = std::ranges::mismatch(before, after).in1 - before.begin();
        return fmt::format("{} of {} bytes, expected {}; they part at byte {}", name, after.size(),
                           before.size(), place);
    };
    if (actual.cell_count != expected.cell_count || box(actual) != box(expected) ||
        actual.cell_sum != expected.cell_sum) {
        difference.operation = occupancy_or("measure_objects");
        difference.detail = fmt::format(
            "{} cells, box {}, sums ({}, {}, {}), expected {} cells, box {}, sums ({}, {}, {})",
            actual.cell_count, box(actual), actual.cell_sum[0], actual.cell_sum[1],
            actual.cell_sum[2], expected.cell_count, box(expected), expected.cell_sum[0],
            expected.cell_sum[1], expected.cell_sum[2]);
    } else if (actual.octree != expected.octree) {
        difference.operation = "encode_octree";
        difference.detail = bytes("octree", expected.octree, actual.octree);
    } else {
        difference.operation = "encode_prism";
        difference.detail = bytes("prism", expected.prism, actual.prism);
    }
    return difference;
}

} // namespace

std::vector<CellValue> cells_of(const Mapper& mapper) {
    std::vector<CellValue> cells;
    mapper.for_each_cell([&](const CellIndex& cell, int value) { cells.push_back({cell, value}); });
    return cells;
}

std::vector<CellValue> statements_of(const Mapper& mapper) {
    std::vector<CellValue> statements;
    mapper.for_each_statement([&](const CellIndex& cell, bool occupied) {
        statements.push_back({cell, occupied ? 1 : -1});
    });
    std::ranges::sort(statements);
    return statements;
}

MapDifference difference_of_objects(std::span<const Object> expected,
                                    std::span<const Object> actual) {
    const auto [one, other] = std::ranges::mismatch(expected, actual);
    if (one == expected.end() && other == actual.end()) {
        return {};
    }
    MapDifference difference;
    const auto number = one - expected.begin();
    if (one != expected.end() && other != actual.end() && one->id == other->id) {
        difference = difference_of_object(*one, *other);
        difference.detail =
            fmt::format("object {} at {}: {}", number, text_of(one->id), difference.detail);
        return difference;
    }
    const auto name = [](const auto& place, const auto& list) {
        return place == list.end() ? std::string("none") : text_of(place->id);
    };
    difference.what = "objects";
    difference.operation = occupancy_or("label_components");
    difference.detail = fmt::format("object {} of {}: {}, expected {} of {}", number, actual.size(),
                                    name(other, actual), name(one, expected), expected.size());
    return difference;
}

MapDifference difference_of_maps(const LastImage& last, Mapper& expected, Mapper& actual) {
    MapDifference difference = difference_of_local_maps(last, expected, actual);
    if (difference.what.empty()) {
        difference = difference_of_cells(last, expected, actual);
    }
    if (difference.what.empty()) {
        difference = difference_of_objects(expected.objects(), actual.objects());
    }
    if (difference.what.empty()) {
        difference = difference_of_profiles(expected, actual);
    }
    return difference;
}

} // namespace zonegrid
