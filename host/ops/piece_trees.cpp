#include "ops/piece_trees.h"

#include "kernels/params/zone_pieces.h"

#include <array>
#include <bit>

namespace zonegrid::ops {

namespace {

using params::ZonePiecesParams;

struct TreePlace {
    std::uint32_t first_word = 0;
    std::uint32_t nodes = 0;
};
static_assert(sizeof(TreePlace) == 8); // the kernels write two words

} // namespace

PieceTrees::PieceTrees(device::Device& device, const std::string& operation,
                       std::uint32_t node_bytes, std::uint32_t group_items)
    : device_(device),
      kernel_(device.make_kernel({operation, operation, 6, sizeof(ZonePiecesParams), group_items})),
      node_bytes_(node_bytes),
      used_(device),
      places_(device),
      nodes_(device) {}

void PieceTrees::reserve(std::size_t pieces, std::uint64_t cells, std::int32_t zone_edge) {
    // A cell lies in one node of each level; each tree begins with a new word.
    const auto levels =
        static_cast<std::uint64_t>(std::countr_zero(static_cast<std::uint32_t>(zone_edge)));
    used_.reserve(sizeof(std::uint32_t));
    places_.reserve(pieces * sizeof(TreePlace));
    nodes_.reserve(pieces * sizeof(std::uint32_t) + cells * levels * node_bytes_);
}

void PieceTrees::dispatch(const LabelComponents& labels, const MeasureObjects& measures) {
    piece_count_ = labels.pieces().size();
    std::uint64_t cells = 0;
    for (const auto& zone : labels.zones()) {
        cells += zone.cells;
    }
    reserve(piece_count_, cells, labels.zone_edge());
    device_.fill(used_.reserve(0), 0, sizeof(std::uint32_t), 0);
    const std::array<const device::Buffer*, 6> bindings{
        &labels.number_buffer(), &labels.piece_buffer(), &measures.measure_buffer(), &used_.get(),
        &places_.get(),          &nodes_.get()};
    const ZonePiecesParams params{static_cast<std::uint32_t>(piece_count_),
                                  std::countr_zero(static_cast<std::uint32_t>(labels.zone_edge()))};
    if (piece_count_ > 0) {
        device_.dispatch(kernel_, bindings, std::as_bytes(std::span(&params, 1)), params.items);
    }
}

std::vector<std::vector<std::uint8_t>> PieceTrees::trees() const {
    std::array<std::uint32_t, 1> used{};
    used_.download(std::span<std::uint32_t>(used));
    std::vector<TreePlace> places(piece_count_);
    places_.download(std::span(places));
    std::vector<std::uint8_t> nodes(used[0] * sizeof(std::uint32_t));
    nodes_.download(std::span(nodes));
    std::vector<std::vector<std::uint8_t>> trees;
    trees.reserve(piece_count_);
    for (const auto& place : places) {
        const auto first =
            nodes.begin() + static_cast<std::ptrdiff_t>(place.first_word * sizeof(std::uint32_t));
        trees.emplace_back(first, first + static_cast<std::ptrdiff_t>(place.nodes * node_bytes_));
    }
    return trees;
}

} // namespace zonegrid::ops
