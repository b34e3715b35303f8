#pragma once

#include "ops/label_components.h"
#include "zonegrid/objects.h"

#include <array>
#include <cstdint>
#include <vector>

namespace zonegrid::ops {

/// Numbers of a piece (docs/model.md, section 8.3); places are within its zone.
struct PieceMeasure {
    std::uint32_t cell_count = 0;
    CellIndex least; ///< by x, then y, then z
    CellIndex box_min;
    CellIndex box_max;                       ///< inclusive
    std::array<std::uint32_t, 3> cell_sum{}; ///< of x, y and z
};

/// Measures the pieces of labelled zones on a device: equal to reference::measure_object.
class MeasureObjects {
public:
    /// `device` lives longer.
    explicit MeasureObjects(device::Device& device,
                            std::uint32_t group_items = device::default_group_items);

    /// Takes memory for so many zones and pieces. Throws CapacityError if there is none.
    void reserve(std::size_t zones, std::size_t pieces);

    /// Measures all pieces of `labels`, without waiting.
    void dispatch(const LabelComponents& labels);

    /// Waits; one entry a piece, in the order of LabelComponents::pieces.
    [[nodiscard]] std::vector<PieceMeasure> measures() const;

    /// On the device, as the kernel leaves them.
    [[nodiscard]] const device::Buffer& measure_buffer() const { return measures_.get(); }

private:
    device::Device& device_;
    device::Kernel kernel_;
    GrowingBuffer first_pieces_;
    GrowingBuffer measures_;
    std::size_t piece_count_ = 0;
    std::int32_t zone_edge_ = 0;
};

} // namespace zonegrid::ops
