#include "ops/label_components.h"

#include "kernels/params/zone_pieces.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <array>
#include <bit>

namespace zonegrid::ops {

namespace {

using params::ZonePiecesParams;

// The kernels read and write these as two words.
static_assert(sizeof(LabelledZone) == 8 && sizeof(LabelledPiece) == 8);

std::uint64_t layer_bytes(std::int32_t zone_edge) {
    return 6 * static_cast<std::uint64_t>(zone_edge) * static_cast<std::uint64_t>(zone_edge) *
           sizeof(std::uint16_t);
}

} // namespace

LabelComponents::LabelComponents(device::Device& device, std::int32_t zone_edge,
                                 std::uint32_t group_items)
    : device_(device),
      zone_edge_(zone_edge),
      layout_(zone_edge),
      kernel_(device.make_kernel(
          {"label_components", "label_components", 6, sizeof(ZonePiecesParams), group_items})),
      slots_(device),
      parents_(device),
      numbers_(device),
      layers_(device),
      counts_(device),
      piece_buffer_(device) {}

void LabelComponents::reserve(std::size_t zones) {
    const std::uint64_t cells = zones * std::uint64_t{layout_.zone_cells};
    slots_.reserve(zones * sizeof(std::uint32_t));
    parents_.reserve(cells * sizeof(std::uint32_t));
    numbers_.reserve(cells * sizeof(std::uint32_t));
    layers_.reserve(zones * layer_bytes(zone_edge_));
    counts_.reserve(zones * sizeof(LabelledZone));
    piece_buffer_.reserve(cells / 2 * sizeof(LabelledPiece)); // no more than on a checkerboard
}

void LabelComponents::dispatch(const device::Buffer& occupied_planes,
                               std::span<const std::uint32_t> slots) {
    if (slots.size() > most_zones) {
        throw UsageError(fmt::format("{} zones to label: hand over at most {} at once",
                                     slots.size(), most_zones));
    }
    zones_.resize(slots.size());
    pieces_.clear();
    const std::uint64_t word_bytes =
        slots.size() * std::uint64_t{layout_.zone_cells} * sizeof(std::uint32_t);
    const std::array<const device::Buffer*, 6> bindings{
        &occupied_planes,
        &slots_.upload(slots),
        &parents_.reserve(word_bytes),
        &numbers_.reserve(word_bytes),
        &layers_.reserve(slots.size() * layer_bytes(zone_edge_)),
        &counts_.reserve(slots.size() * sizeof(LabelledZone))};
    const ZonePiecesParams params{static_cast<std::uint32_t>(slots.size()),
                                  std::countr_zero(static_cast<std::uint32_t>(zone_edge_))};
    if (!slots.empty()) {
        device_.dispatch(kernel_, bindings, std::as_bytes(std::span(&params, 1)), params.items);
    }
    counts_.download(std::span(zones_));
    for (std::uint32_t zone = 0; zone < zones_.size(); ++zone) {
        for (std::uint32_t number = 1; number <= zones_[zone].pieces; ++number) {
            pieces_.push_back({zone, number});
        }
    }
    piece_buffer_.upload(std::span<const LabelledPiece>(pieces_));
}

std::vector<std::uint16_t> LabelComponents::layers() const {
    std::vector<std::uint16_t> layers(zones_.size() * layer_bytes(zone_edge_) /
                                      sizeof(std::uint16_t));
    layers_.download(std::span(layers));
    return layers;
}

} // namespace zonegrid::ops
