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

void PieceTrees::dispatch(const LabelComponents& labels, const MeasureObjects& measures) {
    piece_count_ = labels.pieces().size();
    const auto zone_bits = std::countr_zero(static_cast<std::uint32_t>(labels.zone_edge()));
    // A cell lies in one node of each level; each tree begins with a new word.
    std::uint64_t most_bytes = piece_count_ * sizeof(std::uint32_t);
    for (const auto& zone : labels.zones()) {
        most_bytes +=
            std::uint64_t{zone.cells} * static_cast<std::uint64_t>(zone_bits) * node_bytes_;
    }
    auto& used = used_.reserve(sizeof(std::uint32_t));
    device_.fill(used, 0, sizeof(std::uint32_t), 0);
    const std::array<const device::Buffer*, 6> bindings{
        &labels.number_buffer(),
        &labels.piece_buffer(),
        &measures.measure_buffer(),
        &used,
        &places_.reserve(piece_count_ * sizeof(TreePlace)),
        &nodes_.reserve(most_bytes)};
    const ZonePiecesParams params{static_cast<std::uint32_t>(piece_count_), zone_bits};
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
