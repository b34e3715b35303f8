#include "ops/measure_objects.h"

#include "kernels/params/zone_pieces.h"

#include <bit>

namespace zonegrid::ops {

namespace {

using params::ZonePiecesParams;

using Words = std::array<std::uint32_t, ZG_MEASURE_WORDS>;

} // namespace

MeasureObjects::MeasureObjects(device::Device& device, std::uint32_t group_items)
    : device_(device),
      kernel_(device.make_kernel(
          {"measure_objects", "measure_objects", 3, sizeof(ZonePiecesParams), group_items})),
      first_pieces_(device),
      measures_(device) {}

void MeasureObjects::reserve(std::size_t zones, std::size_t pieces) {
    first_pieces_.reserve(zones * sizeof(std::uint32_t));
    measures_.reserve(pieces * sizeof(Words));
}

void MeasureObjects::dispatch(const LabelComponents& labels) {
    zone_edge_ = labels.zone_edge();
    piece_count_ = labels.pieces().size();
    auto& measures = measures_.reserve(piece_count_ * sizeof(Words));
    if (piece_count_ == 0) {
        return;
    }
    std::vector<std::uint32_t> first_pieces;
    std::uint32_t pieces = 0;
    for (const auto& zone : labels.zones()) {
        first_pieces.push_back(pieces);
        pieces += zone.pieces;
    }
    device_.fill(measures, 0, piece_count_ * sizeof(Words), 0);
    const std::array<const device::Buffer*, 3> bindings{
        &labels.number_buffer(),
        &first_pieces_.upload(std::span<const std::uint32_t>(first_pieces)), &measures};
    const ZonePiecesParams params{static_cast<std::uint32_t>(labels.zones().size()),
                                  std::countr_zero(static_cast<std::uint32_t>(zone_edge_))};
    device_.dispatch(kernel_, bindings, std::as_bytes(std::span(&params, 1)), params.items);
}

std::vector<PieceMeasure> MeasureObjects::measures() const {
    std::vector<Words> words(piece_count_);
    measures_.download(std::span(words));
    const auto bits =
        static_cast<std::uint32_t>(std::countr_zero(static_cast<std::uint32_t>(zone_edge_)));
    const auto last = static_cast<std::uint32_t>(zone_edge_) - 1;
    const auto place = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return CellIndex{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                         static_cast<std::int32_t>(z)};
    };
    std::vector<PieceMeasure> measures;
    measures.reserve(piece_count_);
    for (const auto& piece : words) {
        const std::uint32_t least = ~piece[10];
        measures.push_back({piece[0],
                            place(least >> (2 * bits), least >> bits & last, least & last),
                            place(last - piece[1], last - piece[2], last - piece[3]),
                            place(piece[4], piece[5], piece[6]),
                            {piece[7], piece[8], piece[9]}});
    }
    return measures;
}

} // namespace zonegrid::ops
