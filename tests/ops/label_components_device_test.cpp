#include "ops/label_components.h"

#include "reference/label_components.h"
#include "support/case_count.h"
#include "support/each_device.h"
#include "support/labelled_zones.h"
#include "zonegrid/errors.h"

#include <gtest/gtest.h>

// Every device numbers the pieces of zones as the reference orders them, cell by cell.

namespace zonegrid {
namespace {

using device::Device;
using ops::LabelComponents;
using oracle::Random;

class LabelComponentsOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, LabelComponentsOn, testing::Values("opencl", "vulkan"),
                         backend_name);

std::vector<std::uint32_t> numbers_of(const reference::ZonePieces& pieces, std::size_t cells) {
    std::vector<std::uint32_t> numbers(cells);
    for (std::size_t piece = 0; piece < pieces.pieces.size(); ++piece) {
        for (const auto index : pieces.pieces[piece]) {
            numbers[index] = static_cast<std::uint32_t>(piece) + 1;
        }
    }
    return numbers;
}

std::vector<std::uint16_t> numbers_of(const BorderLayer& layer, std::int32_t zone_edge) {
    std::vector<std::uint16_t> numbers(static_cast<std::size_t>(zone_edge * zone_edge));
    for (const auto& cell : layer) {
        numbers.at(cell.place) = cell.piece;
    }
    return numbers;
}

TEST_P(LabelComponentsOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        std::size_t pieces = 0;
        const std::uint64_t count = case_count(60);
        for (std::uint64_t seed = 1; seed <= count; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const std::int32_t edge = 8 << random.pick(0, 2);
            LabelComponents operation(*device, edge, random.chance(0.5) ? 128 : 32);
            const auto zones = nasty_zones(random, edge);
            label(*device, zones, operation);

            const auto zone_cells = operation.layout().zone_cells;
            std::vector<std::uint32_t> numbers(zones.size() * zone_cells);
            device->download(operation.number_buffer(), 0,
                             std::as_writable_bytes(std::span(numbers)));
            const auto layers = operation.layers();
            auto layer = layers.begin();
            for (std::size_t i = 0; i < zones.size(); ++i) {
                const auto expected = reference::label_zone(zones[i], edge);
                pieces += expected.pieces.size();
                ASSERT_EQ(operation.zones()[i].pieces, expected.pieces.size()) << "zone " << i;
                const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(i * zone_cells);
                ASSERT_EQ(std::vector(first, first + zone_cells), numbers_of(expected, zone_cells))
                    << "zone " << i;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    for (const auto* side :
                         {&expected.first_layer[axis], &expected.last_layer[axis]}) {
                        const auto end = layer + edge * edge;
                        ASSERT_EQ(std::vector(layer, end), numbers_of(*side, edge))
                            << "zone " << i << " axis " << axis;
                        layer = end;
                    }
                }
            }
        }
        EXPECT_TRUE(pieces > 20000U || count < 60) << pieces;
    });
}

TEST_P(LabelComponentsOn, RefusesMoreZonesThanItHasMemoryFor) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        LabelComponents operation(*device, 8);
        const auto planes = device->make_buffer(1024);
        const std::vector<std::uint32_t> slots(LabelComponents::most_zones + 1);
        EXPECT_THROW(operation.dispatch(planes, slots), UsageError);
    });
}

} // namespace
} // namespace zonegrid
