#pragma once

#include "io/map_comparison.h"
#include "zonegrid/mapper.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid {

struct CellValue {
    CellIndex cell;
    std::int32_t value = 0;
    friend auto operator<=>(const CellValue&, const CellValue&) = default;
};

/// Every cell in the window with a value other than 0, by x, then y, then z.
[[nodiscard]] std::vector<CellValue> cells_of(const Mapper& mapper);

/// Every cell of which the last image says something: 1 occupied, -1 free; by x, then y, then z.
[[nodiscard]] std::vector<CellValue> statements_of(const Mapper& mapper);

/// The image with which two maps parted.
struct LastImage {
    const Mapper& before;         ///< either map before it
    bool zones_entered = false;   ///< zones came back with it
    std::string_view integration; ///< the operation that draws what the sensor says
};

/// What differs between two maps that were equal before the last image: what that image says, else
/// cells, else objects, else the height profile. `what` is empty if nothing does. Fills all but
/// image and frame.
[[nodiscard]] MapDifference difference_of_maps(const LastImage& last, Mapper& expected,
                                               Mapper& actual);

/// The first object that differs, and in what; `what` is empty if none does.
[[nodiscard]] MapDifference difference_of_objects(std::span<const Object> expected,
                                                  std::span<const Object> actual);

} // namespace zonegrid
