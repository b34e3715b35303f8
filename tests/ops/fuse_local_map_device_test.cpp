#include "ops/fuse_local_map.h"

#include "model/zone_bits.h"
#include "reference/fuse_local_map.h"
#include "support/each_device.h"
#include "support/oracle_random.h"
#include "support/statements.h"
#include "zonegrid/errors.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

// Every device equals the reference: values, occupancies and what is said to have changed.

namespace zonegrid {
namespace {

using device::Buffer;
using device::Device;
using ops::FuseLocalMap;

using ops::ZoneLayout;
using ops::ZonePair;

using Words = std::vector<std::uint32_t>;

void set_bit(std::span<std::uint32_t> plane, std::size_t cell) {
    plane[cell / 32] |= 1U << (cell % 32);
}

/// 0 .. count - 1 in random order.
Words shuffled(oracle::Random& random, std::size_t count) {
    Words order(count);
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t i = count; i > 1; --i) {
        std::swap(
            order[i - 1],
            order[static_cast<std::size_t>(random.whole(0, static_cast<std::int64_t>(i) - 1))]);
    }
    return order;
}

MapperOptions random_rule(oracle::Random& random) {
    MapperOptions options;
    options.limit = random.chance(0.3) ? 127 : random.pick(1, 12);
    options.hit = random.pick(1, options.limit);
    options.miss = random.pick(1, options.limit);
    options.threshold = random.pick(1, options.limit);
    return options;
}

/// What the cases were made of, so that none of them is missed unnoticed.
struct Coverage {
    std::uint64_t zones = 0;
    std::uint64_t said_nothing = 0;
    std::uint64_t said_free = 0;
    std::uint64_t said_occupied = 0;
    std::uint64_t said_both = 0;
    std::uint64_t held_at_upper_limit = 0;
    std::uint64_t held_at_lower_limit = 0;
    std::uint64_t occupancy_changes = 0;
    std::uint64_t denied = 0;      ///< obstacles stated free and seen whole
    std::uint64_t partly_seen = 0; ///< obstacles stated free and not seen whole
};

/// Half of space, from a centre in a cube of cells, where corners of cells lie just on the bounds:
/// in front by the margin of 3, or at the distance that the radius allows.
View exact_view(oracle::Random& random, std::int32_t window_cells) {
    View view;
    view.bounded = true;
    std::array<std::int32_t, 3> normal{};
    normal[static_cast<std::size_t>(random.pick(0, 2))] = random.chance(0.5) ? 16384 : -16384;
    view.sides.fill({normal[0], normal[1], normal[2]});
    const auto place = [&](std::int32_t beyond) {
        return ZG_VIEW_PER_CELL * random.pick(0, window_cells - 1) + beyond;
    };
    if (random.chance(0.5)) {
        view.centre = {place(0), place(0), place(0)};
        view.radius = 3 + ZG_VIEW_PER_CELL * 7; // 7 cells are 2, 3 and 6 on the axes
    } else {
        const std::int32_t beyond = random.chance(0.5) ? 13 : 3;
        view.centre = {place(beyond), place(beyond), place(beyond)};
        view.radius = 2 * ZG_VIEW_PER_CELL * window_cells;
    }
    return view;
}

/// A view from in or near a cube of cells: every side is its own, or as of a camera.
View random_view(oracle::Random& random, std::int32_t window_cells) {
    View view;
    view.bounded = random.chance(0.9);
    const auto axis = [&random] { return random.real(-1.0, 1.0); };
    const Eigen::Vector3d ahead(axis(), axis(), axis());
    const double slope = random.real(0.05, 3.0);
    for (auto& side : view.sides) {
        Eigen::Vector3d normal(axis(), axis(), axis());
        if (random.chance(0.9)) {
            normal = (normal.cross(ahead) + slope * ahead).eval();
        }
        normal *= (1 << ZG_VIEW_NORMAL_BITS) / normal.norm();
        side = {static_cast<std::int32_t>(std::lround(normal.x())),
                static_cast<std::int32_t>(std::lround(normal.y())),
                static_cast<std::int32_t>(std::lround(normal.z()))};
    }
    const std::int32_t most = ZG_VIEW_PER_CELL * window_cells;
    const auto place = [&] {
        return random.chance(0.1) ? (random.chance(0.5) ? 0 : most - 1) : random.pick(0, most - 1);
    };
    view.centre = {place(), place(), place()};
    view.radius = random.chance(0.1) ? random.pick(0, 40) : random.pick(0, 2 * most);
    return view;
}

/// A grid that the reference and a device fuse the same images into, zones lying in slots at
/// random.
class FusionPair {
public:
    FusionPair(Device& device, std::int32_t zone_edge, std::uint32_t group_items,
               std::uint64_t seed)
        : device_(device),
          random_(seed),
          rule_(random_rule(random_)),
          window_(placed_window(zone_edge)),
          layout_(zone_edge),
          grid_(window_),
          slots_(shuffled(random_, window_.zone_count())),
          local_planes_(device.make_buffer(zones_per_image * layout_.local_bytes())),
          grid_cells_(device.make_buffer(window_.zone_count() * layout_.grid_bytes())),
          occupied_planes_(device.make_buffer(window_.zone_count() * layout_.plane_bytes())),
          fuse_(device, zone_edge, rule_, group_items) {
        fill_grids();
    }

    /// Fuses one image both ways and compares everything.
    void fuse_and_compare(Coverage& coverage) {
        LocalMap local_map(window_);
        const auto pairs = make_image(local_map, coverage);
        const auto before = copy_values();
        const auto edge_cells = window_.edge_cells();
        const View view = random_.chance(0.3) ? exact_view(random_, edge_cells)
                                              : random_view(random_, edge_cells);
        const auto result = reference::fuse_local_map(local_map, view, rule_, grid_);
        count_denials(local_map, before, coverage);
        fuse_.dispatch({local_planes_, grid_cells_, occupied_planes_}, view, pairs);
        compare_changes(before, result);
        compare_grids();
        coverage.zones += pairs.size();
        coverage.occupancy_changes += result.occupancy_changed.size();
    }

private:
    static constexpr std::size_t zones_per_image = 9;

    static Window placed_window(std::int32_t zone_edge) {
        Window window(zone_edge, 3, zone_edge);
        window.move_to({0, 0, 0});
        return window;
    }

    void fill_grids() {
        for (std::uint32_t place = 0; place < window_.zone_count(); ++place) {
            for (auto& value : grid_.touch(place)) {
                value = static_cast<std::int8_t>(random_.pick(-rule_.limit, rule_.limit));
            }
            const auto values = grid_.find(place);
            device_.upload(grid_cells_, slots_[place] * layout_.grid_bytes(),
                           std::as_bytes(values));
            const auto occupied = occupied_bits(values, rule_.threshold, window_.zone_edge());
            device_.upload(occupied_planes_, slots_[place] * layout_.plane_bytes(),
                           std::as_bytes(occupied.words()));
        }
    }

    /// Random statements for random zones, also as planes on the device.
    std::vector<ZonePair> make_image(LocalMap& local_map, Coverage& coverage) {
        places_ = shuffled(random_, window_.zone_count());
        places_.resize(zones_per_image);
        const auto local_slots = shuffled(random_, zones_per_image);
        std::vector<ZonePair> pairs;
        stated_.clear();
        for (std::size_t i = 0; i < zones_per_image; ++i) {
            const Words planes = make_zone(local_map, places_[i], coverage);
            device_.upload(local_planes_, local_slots[i] * layout_.local_bytes(),
                           std::as_bytes(std::span(planes)));
            const auto words = std::span(planes).first(layout_.plane_words());
            const auto occupied = std::span(planes).last(layout_.plane_words());
            stated_.push_back(count_either(words, occupied));
            pairs.push_back(
                {local_slots[i], slots_[places_[i]], ops::zone_in_window(window_, places_[i])});
        }
        return pairs;
    }

    static std::uint32_t count_either(std::span<const std::uint32_t> one,
                                      std::span<const std::uint32_t> other) {
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < one.size(); ++i) {
            count += static_cast<std::uint32_t>(std::popcount(one[i] | other[i]));
        }
        return count;
    }

    Words make_zone(LocalMap& local_map, std::uint32_t place, Coverage& coverage) {
        const auto values = grid_.find(place);
        Words planes(2 * std::size_t{layout_.plane_words()});
        const auto free = std::span(planes).first(layout_.plane_words());
        const auto occupied = std::span(planes).last(layout_.plane_words());
        const double share_stated = random_.chance(0.3) ? 0.01 : random_.real(0.0, 1.0);
        const double share_occupied = random_.real(0.0, 1.0);
        for (std::uint32_t cell = 0; cell < values.size(); ++cell) {
            if (!random_.chance(share_stated)) {
                ++coverage.said_nothing;
            } else if (random_.chance(share_occupied)) {
                say_in_zone(local_map, place, cell, ZG_STATEMENT_OCCUPIED);
                set_bit(occupied, cell);
                ++coverage.said_occupied;
                coverage.held_at_upper_limit += values[cell] == rule_.limit ? 1U : 0U;
                if (random_.chance(0.5)) {
                    set_bit(free, cell); // another ray passed: occupied beats it
                    ++coverage.said_both;
                }
            } else {
                say_in_zone(local_map, place, cell, ZG_STATEMENT_FREE);
                set_bit(free, cell);
                ++coverage.said_free;
                coverage.held_at_lower_limit += values[cell] == -rule_.limit ? 1U : 0U;
            }
        }
        return planes;
    }

    std::vector<std::vector<std::int8_t>> copy_values() const {
        std::vector<std::vector<std::int8_t>> copies;
        for (const auto place : places_) {
            const auto values = grid_.find(place);
            copies.emplace_back(values.begin(), values.end());
        }
        return copies;
    }

    void count_denials(const LocalMap& local_map,
                       const std::vector<std::vector<std::int8_t>>& before, Coverage& coverage) {
        std::vector<std::uint8_t> statements(layout_.zone_cells);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            local_map.copy_zone(places_[i], statements);
            const auto after = grid_.find(places_[i]);
            for (std::size_t cell = 0; cell < statements.size(); ++cell) {
                if (statements[cell] == ZG_STATEMENT_FREE && before[i][cell] >= rule_.threshold) {
                    ++(after[cell] == before[i][cell] ? coverage.partly_seen : coverage.denied);
                }
            }
        }
    }

    void compare_changes(const std::vector<std::vector<std::int8_t>>& before,
                         const FusionResult& result) {
        const auto changes = fuse_.changes();
        ASSERT_EQ(changes.size(), places_.size());
        std::uint64_t values_changed = 0;
        std::vector<std::uint32_t> occupancy_changed;
        for (std::size_t i = 0; i < changes.size(); ++i) {
            const auto place = places_[i];
            values_changed += changes[i].values_changed;
            if (changes[i].occupancies_changed != 0) {
                occupancy_changed.push_back(place);
            }
            EXPECT_EQ(changes[i].occupancies_changed, count_flips(before[i], grid_.find(place)))
                << "zone at place " << place;
            EXPECT_EQ(changes[i].cells_stated, stated_[i]) << "zone at place " << place;
        }
        std::ranges::sort(occupancy_changed);
        EXPECT_EQ(values_changed, result.cells_changed);
        EXPECT_EQ(occupancy_changed, result.occupancy_changed);
    }

    std::uint32_t count_flips(std::span<const std::int8_t> before,
                              std::span<const std::int8_t> after) const {
        std::uint32_t flips = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            flips += (before[i] >= rule_.threshold) != (after[i] >= rule_.threshold) ? 1U : 0U;
        }
        return flips;
    }

    void compare_grids() {
        std::vector<std::int8_t> values(window_.zone_count() * layout_.grid_bytes());
        Words planes(window_.zone_count() * layout_.plane_words());
        device_.download(grid_cells_, 0, std::as_writable_bytes(std::span(values)));
        device_.download(occupied_planes_, 0, std::as_writable_bytes(std::span(planes)));
        std::size_t differing = 0;
        std::string first;
        for (std::uint32_t place = 0; place < window_.zone_count(); ++place) {
            const auto expected = grid_.find(place);
            const auto actual =
                std::span(values).subspan(slots_[place] * layout_.zone_cells, layout_.zone_cells);
            for (std::size_t cell = 0; cell < expected.size(); ++cell) {
                if (expected[cell] != actual[cell] && differing++ == 0) {
                    first = "cell " + std::to_string(cell) + " of the zone at place " +
                            std::to_string(place) + " (slot " + std::to_string(slots_[place]) +
                            ") is " + std::to_string(actual[cell]) + ", reference " +
                            std::to_string(expected[cell]);
                }
            }
            const auto occupied = occupied_bits(expected, rule_.threshold, window_.zone_edge());
            EXPECT_TRUE(std::ranges::equal(
                occupied.words(), std::span(planes).subspan(slots_[place] * layout_.plane_words(),
                                                            layout_.plane_words())))
                << "occupied plane of the zone at place " << place;
        }
        EXPECT_EQ(differing, 0U) << "first: " << first;
    }

    Device& device_;
    oracle::Random random_;
    FusionRule rule_;
    Window window_;
    ZoneLayout layout_;
    Grid grid_;
    Words slots_;  ///< by place
    Words places_; ///< of the image's zones
    Words stated_; ///< cells with a statement in each of them
    Buffer local_planes_;
    Buffer grid_cells_;
    Buffer occupied_planes_;
    FuseLocalMap fuse_;
};

class FuseLocalMapOn : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, FuseLocalMapOn, testing::Values("opencl", "vulkan"),
                         backend_name);

TEST_P(FuseLocalMapOn, EqualsTheReference) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        Coverage coverage;
        std::uint64_t seed = 1;
        for (const std::int32_t zone_edge : {8, 16, 32}) {
            for (const std::uint32_t group_items : {32U, 64U, 128U}) {
                SCOPED_TRACE("zones of " + std::to_string(zone_edge) + ", groups of " +
                             std::to_string(group_items) + ", seed " + std::to_string(seed));
                FusionPair fusion(*device, zone_edge, group_items, seed++);
                for (int image = 0; image < 6; ++image) {
                    fusion.fuse_and_compare(coverage);
                }
            }
        }
        EXPECT_EQ(coverage.zones, 486U);
        EXPECT_GT(coverage.said_nothing, 1000U);
        EXPECT_GT(coverage.said_free, 1000U);
        EXPECT_GT(coverage.said_occupied, 1000U);
        EXPECT_GT(coverage.said_both, 1000U);
        EXPECT_GT(coverage.held_at_upper_limit, 1000U);
        EXPECT_GT(coverage.held_at_lower_limit, 1000U);
        EXPECT_GT(coverage.occupancy_changes, 200U);
        EXPECT_GT(coverage.denied, 10000U);
        EXPECT_GT(coverage.partly_seen, 10000U);
    });
}

TEST_P(FuseLocalMapOn, RefusesPairsThatCannotBeFused) {
    for_each_device([](const std::unique_ptr<Device>& device) {
        const ZoneLayout layout(8);
        FuseLocalMap fuse(*device, 8, FusionRule{MapperOptions{}});
        const Buffer local = device->make_buffer(2 * layout.local_bytes());
        Buffer grid = device->make_buffer(3 * layout.grid_bytes());
        Buffer occupied = device->make_buffer(4 * layout.plane_bytes());
        const auto dispatch = [&](const std::vector<ZonePair>& pairs) {
            fuse.dispatch({local, grid, occupied}, View{}, pairs);
        };
        EXPECT_THROW(dispatch({{2, 0, 0}}), UsageError);
        EXPECT_THROW(dispatch({{0, 3, 0}}), UsageError);
        EXPECT_THROW(dispatch({{0, 1, 0}, {1, 0, 0}, {1, 1, 0}}), UsageError);
        dispatch({});
        EXPECT_TRUE(fuse.changes().empty());
    });
}

} // namespace
} // namespace zonegrid
