#include "pipeline/map_history.h"

#include "pipeline/wall_flight.h"
#include "support/case_count.h"
#include "support/each_device.h"
#include "support/oracle_random.h"
#include "support/oracle_scenes.h"
#include "support/scenes.h"
#include "zonegrid/mapper.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>
#include <string>

// What is known of every cell ever in the window: against one that looks at the whole window after
// every image.

namespace zonegrid {
namespace {

using oracle::Random;

struct CellHistory {
    int value = 0;
    std::optional<std::uint32_t> first_image;
    std::optional<std::uint32_t> since_image;
    friend bool operator==(const CellHistory&, const CellHistory&) = default;
};

using Cells = std::map<CellIndex, CellHistory>;

/// Compares whole windows, image by image. Sees no zone but by its cells.
class PlainHistory {
public:
    explicit PlainHistory(const MapperOptions& options) : options_(options) {}

    void look(const Mapper& mapper, std::uint32_t image) {
        const auto values = scenes::values_of(mapper);
        const auto window = mapper.statistics();
        for (auto& [zone, cells] : zones_) {
            if (!holds(window, zone)) {
                present_.erase(zone);
            }
        }
        for (const auto& [cell, value] : values) {
            present_.insert(zone_of(cell, options_.zone));
        }
        for (const auto& zone : present_) {
            for (auto& [cell, history] : zones_[zone]) {
                if (!values.contains(cell)) {
                    set(history, 0, image);
                }
            }
        }
        for (const auto& [cell, value] : values) {
            set(zones_[zone_of(cell, options_.zone)][cell], value, image);
        }
    }

    [[nodiscard]] Cells cells() const {
        Cells all;
        for (const auto& [zone, cells] : zones_) {
            for (const auto& [cell, history] : cells) {
                if (history != CellHistory{}) {
                    all.emplace(cell, history);
                }
            }
        }
        return all;
    }

private:
    [[nodiscard]] bool holds(const MapStatistics& window, const ZoneIndex& zone) const {
        const CellIndex cell = first_cell_of(zone, options_.zone);
        const auto inside = [&](std::int32_t c, std::int32_t first) {
            return c >= first && c < first + window.window_cells;
        };
        return inside(cell.x, window.window_first_cell.x) &&
               inside(cell.y, window.window_first_cell.y) &&
               inside(cell.z, window.window_first_cell.z);
    }

    void set(CellHistory& cell, int value, std::uint32_t image) const {
        cell.value = value;
        if (value < options_.threshold) {
            cell.since_image.reset();
            return;
        }
        cell.first_image = cell.first_image.value_or(image);
        cell.since_image = cell.since_image.value_or(image);
    }

    MapperOptions options_;
    std::map<ZoneIndex, Cells> zones_;
    std::set<ZoneIndex> present_; ///< zones that hold cells now
};

Cells cells_of(const MapHistory& history) {
    const auto image_of = [](std::uint32_t image) {
        return image == CellStamp::never ? std::nullopt : std::optional(image);
    };
    const std::int32_t edge = history.options().zone;
    Cells cells;
    for (const auto& [zone, known] : history.zones()) {
        for (std::size_t place = 0; place < known.values.size(); ++place) {
            if (known.values[place] != 0) {
                cells[cell_at(zone, static_cast<std::uint32_t>(place), edge)].value =
                    known.values[place];
            }
        }
        for (const auto& stamp : known.stamps) {
            CellHistory& cell = cells[cell_at(zone, stamp.place, edge)];
            cell.first_image = image_of(stamp.first_image);
            cell.since_image = image_of(stamp.since_image);
        }
    }
    return cells;
}

std::string text_of(const CellHistory& cell) {
    return "value " + std::to_string(cell.value) + ", first " +
           std::to_string(static_cast<int>(cell.first_image.value_or(CellStamp::never))) +
           ", since " +
           std::to_string(static_cast<int>(cell.since_image.value_or(CellStamp::never)));
}

/// Empty if equal; else the first cell that differs.
std::string difference(const Cells& expected, const Cells& actual) {
    for (const auto* cells : {&expected, &actual}) {
        for (const auto& [cell, history] : *cells) {
            const auto left = expected.find(cell);
            const auto right = actual.find(cell);
            const CellHistory want = left == expected.end() ? CellHistory{} : left->second;
            const CellHistory have = right == actual.end() ? CellHistory{} : right->second;
            if (!(want == have)) {
                return "cell " + std::to_string(cell.x) + " " + std::to_string(cell.y) + " " +
                       std::to_string(cell.z) + ": expected " + text_of(want) + "; is " +
                       text_of(have);
            }
        }
    }
    return "";
}

/// What the flights went through; a flight that meets nothing tests nothing.
struct Seen {
    std::size_t cells = 0;
    std::size_t cleared = 0; ///< occupied once, not at the end
    std::size_t again = 0;   ///< occupied at the end, but not without a break
    std::uint64_t entered = 0;
    std::uint64_t left = 0;
};

/// Out and back again, so that zones leave and return; compares after every image.
void fly(std::uint64_t seed, const std::string& backend, Seen& seen) {
    Random random(seed);
    const Camera camera = scenes::forward_camera(random.pick(3, 12), random.pick(2, 9), 8.0);
    MapperOptions options;
    options.range_m = random.real(6.0, 14.0);
    options.zone = 8;
    options.hit = random.pick(1, 3);
    options.limit = random.pick(3, 5);
    options.threshold = random.pick(1, 3);
    options.backend = backend;
    Mapper mapper(options, camera);
    MapHistory history(options);
    mapper.observe_zones([&](const CellIndex& first, std::span<const std::int8_t> values) {
        history.take(first, values);
    });
    PlainHistory plain(options);
    double x_m = 0.0;
    for (std::uint32_t image = 3; image < 17; ++image) {
        if (random.chance(0.6)) {
            x_m += (image < 10 ? 1.0 : -1.0) * random.real(0.0, 20.0);
        }
        const auto depth_m = oracle::random_depths(random, camera, options, oracle::Picture::step);
        history.begin_image(image);
        const auto result = scenes::show(mapper, 0.1 * image, {x_m, random.real(-1.0, 1.0), -3.0},
                                         depth_m, random.real(-0.2, 0.2));
        seen.entered += result.zones_entered;
        seen.left += result.zones_left;
        plain.look(mapper, image);
        ASSERT_EQ(difference(plain.cells(), cells_of(history)), "") << "image " << image;
    }
    for (const auto& [cell, known] : plain.cells()) {
        ++seen.cells;
        seen.cleared += known.first_image && !known.since_image ? 1U : 0U;
        seen.again += known.since_image && known.since_image != known.first_image ? 1U : 0U;
    }
}

void fly_many(const std::string& backend) {
    Seen seen;
    const std::uint64_t count = case_count(20);
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        SCOPED_TRACE(backend + ", seed " + std::to_string(seed));
        fly(seed, backend, seen);
        ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
    if (count >= 20) {
        EXPECT_GT(seen.cells, 10000U);
        EXPECT_GT(seen.cleared, 50U);
        EXPECT_GT(seen.again, 10U);
        EXPECT_GT(seen.entered, 20U);
        EXPECT_GT(seen.left, 100U);
    }
}

TEST(MapHistory, KnowsWhatAPlainComparisonOfEveryImageKnows) {
    fly_many("reference");
}

class MapHistoryOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, MapHistoryOn, testing::Values("opencl", "vulkan"), backend_name);

TEST_P(MapHistoryOn, KnowsWhatAPlainComparisonOfEveryImageKnows) {
    for (const auto& info : devices()) {
        fly_many(info.id());
    }
}

TEST(MapHistory, KeepsStampsOfAWallThatLeavesAndReturns) {
    WallFlight flight;
    MapHistory history(WallFlight::options());
    flight.mapper().observe_zones([&](const CellIndex& first, std::span<const std::int8_t> values) {
        history.take(first, values);
    });
    history.begin_image(7);
    flight.see_wall(); // one hit makes 2, the threshold
    history.begin_image(8);
    flight.fly_to(WallFlight::far_away_m);
    const CellIndex wall{10, 0, 0};
    const CellIndex before{9, 0, 0};
    EXPECT_EQ(flight.mapper().value(wall), 0);
    EXPECT_EQ(cells_of(history).at(wall), (CellHistory{2, 7, 7}));
    EXPECT_EQ(cells_of(history).at(before), (CellHistory{-1, {}, {}}));
    history.begin_image(9);
    flight.fly_to(WallFlight::home_m); // drawn back with (2 + 8 + 1) / 2
    EXPECT_EQ(cells_of(history).at(wall), (CellHistory{5, 7, 7}));
    // Its zone was drawn anew; a zone without obstacles keeps what was known.
    EXPECT_FALSE(cells_of(history).contains(before));
    EXPECT_EQ(cells_of(history).at({7, 0, 0}), (CellHistory{-1, {}, {}}));
    for (std::uint32_t image = 10; image < 14; ++image) {
        history.begin_image(image);
        flight.see_sky(WallFlight::home_m); // 5 - 4 = 1 is below the threshold
    }
    EXPECT_EQ(cells_of(history).at(wall), (CellHistory{1, 7, {}}));
    history.begin_image(14);
    flight.see_wall();
    EXPECT_EQ(cells_of(history).at(wall), (CellHistory{3, 7, 14}));
}

TEST(MapHistory, IsToldOfNothingAfterAnEmptyObserver) {
    WallFlight flight;
    int calls = 0;
    flight.mapper().observe_zones([&](const CellIndex&, std::span<const std::int8_t>) { ++calls; });
    flight.see_wall();
    EXPECT_GT(calls, 0);
    const int before = calls;
    flight.mapper().observe_zones({});
    flight.see_wall();
    EXPECT_EQ(calls, before);
}

} // namespace
} // namespace zonegrid
