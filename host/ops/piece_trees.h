#pragma once

#include "ops/measure_objects.h"

#include <cstdint>
#include <string>
#include <vector>

namespace zonegrid::ops {

/// What encode_octree and encode_prism have in common: a kernel writes a tree of nodes for each
/// piece of labelled zones, wherever there is room.
class PieceTrees {
public:
    /// `device` lives longer. `operation`: its kernel; `node_bytes`: 1 or 2.
    PieceTrees(device::Device& device, const std::string& operation, std::uint32_t node_bytes,
               std::uint32_t group_items);

    /// Takes memory for the trees of so many pieces with so many cells in all, in zones of that
    /// edge. Throws CapacityError if there is none.
    void reserve(std::size_t pieces, std::uint64_t cells, std::int32_t zone_edge);

    /// Encodes all pieces of `labels`, which `measures` has measured, without waiting.
    void dispatch(const LabelComponents& labels, const MeasureObjects& measures);

    /// Waits; one tree a piece, in the order of LabelComponents::pieces.
    [[nodiscard]] std::vector<std::vector<std::uint8_t>> trees() const;

private:
    device::Device& device_;
    device::Kernel kernel_;
    std::uint32_t node_bytes_;
    GrowingBuffer used_;
    GrowingBuffer places_;
    GrowingBuffer nodes_;
    std::size_t piece_count_ = 0;
};

} // namespace zonegrid::ops
