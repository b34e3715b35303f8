#include "ops/draw_objects.h"

#include "model/zone_bits.h"
#include "ops/device_grid.h"
#include "reference/draw_objects.h"
#include "support/case_count.h"
#include "support/each_device.h"
#include "support/oracle_random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

// Every device draws remembered cells as the reference does, values and occupancies.

namespace zonegrid {
namespace {

using device::Device;
using oracle::Random;

class DrawObjectsOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, DrawObjectsOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(DrawObjectsOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        const std::uint64_t count = case_count(60);
        for (std::uint64_t seed = 1; seed <= count; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const std::int32_t edge = 8 << random.pick(0, 2);
            MapperOptions options;
            options.limit = random.chance(0.3) ? 127 : random.pick(2, 12);
            options.threshold = random.pick(1, options.limit);
            const FusionRule rule(options);
            const ops::ZoneLayout layout(edge);
            const ZoneIndex zone{random.pick(-99, 99), random.pick(-99, 99), random.pick(-99, 99)};
            const double share = random.chance(0.2) ? 1.0 : random.real(0.0, 0.3);
            std::vector<CellIndex> cells;
            for (std::uint32_t i = 0; i < layout.zone_cells; ++i) {
                if (random.chance(share)) {
                    cells.push_back(cell_at(zone, i, edge));
                }
            }
            std::vector<std::int8_t> expected(layout.zone_cells);
            reference::draw_objects(cells, rule, edge, expected);

            ops::DeviceGrid grid(*device, edge);
            ops::DrawObjects operation(*device, edge, rule);
            const auto before = grid.take();
            const auto slot = grid.take();
            const auto after = grid.take();
            auto& chunk = grid.chunk(slot.chunk);
            operation.dispatch(cells, slot.index, chunk.cells, chunk.occupied_planes);
            std::vector<std::int8_t> values(layout.zone_cells, 99);
            ZoneBits occupied(edge);
            grid.download_values(slot, values);
            grid.download_occupied(slot, occupied.words());
            ASSERT_EQ(values, expected);
            ASSERT_EQ(occupied, occupied_bits(expected, rule.threshold, edge));
            for (const auto& beside : {before, after}) {
                grid.download_values(beside, values);
                ASSERT_EQ(std::ranges::count(values, 0), layout.zone_cells);
            }
        }
    });
}

} // namespace
} // namespace zonegrid
