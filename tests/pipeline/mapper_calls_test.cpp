#include "support/scenes.h"
#include "zonegrid/errors.h"
#include "zonegrid/mapper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

// What the Mapper does with calls that cannot be served: skipped and told, or refused.

namespace zonegrid {
namespace {

using scenes::resting_at;
using testing::HasSubstr;

Camera camera() {
    return scenes::forward_camera(16, 12, 16.0);
}

MapperOptions short_range() {
    MapperOptions options;
    options.range_m = 12.0;
    options.zone = 8;
    return options;
}

class MapperCalls : public testing::Test {
protected:
    ImageStatus show_wall(double time_s) { return mapper_.add_image({time_s, wall_}).status; }

    Mapper mapper_{short_range(), camera()};
    std::vector<float> wall_ = scenes::flat_image(camera(), 10.0F);
};

TEST_F(MapperCalls, NoNavigationNoImage) {
    EXPECT_EQ(show_wall(1.0), ImageStatus::no_navigation);
    mapper_.add_navigation(resting_at(1.0, {0.0, 0.0, 0.0}));
    EXPECT_EQ(show_wall(1.06), ImageStatus::no_navigation); // the default gap is 0.05 s
    EXPECT_TRUE(scenes::values_of(mapper_).empty());
    EXPECT_EQ(show_wall(1.04), ImageStatus::integrated);
    EXPECT_FALSE(scenes::values_of(mapper_).empty());
}

TEST_F(MapperCalls, ImagesOutOfOrderAreSkipped) {
    mapper_.add_navigation(resting_at(1.0, {0.0, 0.0, 0.0}));
    EXPECT_EQ(show_wall(std::numeric_limits<double>::quiet_NaN()), ImageStatus::out_of_order);
    EXPECT_EQ(show_wall(1.01), ImageStatus::integrated);
    const auto before = scenes::values_of(mapper_);
    EXPECT_EQ(show_wall(1.01), ImageStatus::out_of_order);
    EXPECT_EQ(show_wall(0.99), ImageStatus::out_of_order);
    EXPECT_EQ(scenes::values_of(mapper_), before);
    EXPECT_EQ(show_wall(1.02), ImageStatus::integrated);
}

TEST_F(MapperCalls, ASkippedImageDoesNotTakeItsTime) {
    EXPECT_EQ(show_wall(5.0), ImageStatus::no_navigation);
    mapper_.add_navigation(resting_at(1.0, {0.0, 0.0, 0.0}));
    EXPECT_EQ(show_wall(1.0), ImageStatus::integrated);
}

TEST_F(MapperCalls, PosesTooFarAwayAreSkipped) {
    mapper_.add_navigation(resting_at(1.0, {0.0, 1.1e9, 0.0}));
    EXPECT_EQ(show_wall(1.0), ImageStatus::pose_out_of_range);
    EXPECT_EQ(mapper_.statistics().zones_held, 0U);
    mapper_.add_navigation(resting_at(2.0, {0.0, -1.07e9, 0.0}));
    EXPECT_EQ(show_wall(2.0), ImageStatus::integrated);
    EXPECT_EQ(mapper_.objects().size(), 1U);
    EXPECT_LT(mapper_.objects()[0].box_max.y, -1000000000);
}

TEST_F(MapperCalls, ScansAreSkippedAndCountedAlike) {
    const std::vector<Eigen::Vector3f> ends_m{{5.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}};
    Scan scan;
    scan.time_s = 1.0;
    scan.ends_m = ends_m;
    EXPECT_EQ(mapper_.add_scan(scan).status, ImageStatus::no_navigation);
    mapper_.add_navigation(resting_at(1.0, {0.5, 0.5, 0.5}));
    const auto result = mapper_.add_scan(scan);
    EXPECT_EQ(result.status, ImageStatus::integrated);
    EXPECT_EQ(result.rays, 1U);
    EXPECT_EQ(result.missing, 1U);
    EXPECT_EQ(result.cells_changed, 6U);
    EXPECT_EQ(mapper_.value({5, 0, 0}), 2);
    EXPECT_EQ(mapper_.value({4, 0, 0}), -1);
    EXPECT_EQ(mapper_.add_scan(scan).status, ImageStatus::out_of_order);
    EXPECT_EQ(show_wall(1.0), ImageStatus::out_of_order) << "images and scans share one clock";
}

std::string refusal(const std::function<void()>& call) {
    try {
        call();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

TEST_F(MapperCalls, ImagesOfAnotherSizeAreRefused) {
    mapper_.add_navigation(resting_at(1.0, {0.0, 0.0, 0.0}));
    wall_.pop_back();
    EXPECT_THAT(refusal([&] { show_wall(1.0); }),
                HasSubstr("depth image at 1.000000 s has 191 pixels, the camera has 16 x 12"));
    wall_.push_back(10.0F);
    EXPECT_EQ(show_wall(1.0), ImageStatus::integrated);
}

TEST_F(MapperCalls, ImagesWithoutACameraAreRefused) {
    Mapper scanner(short_range());
    EXPECT_THAT(refusal([&] {
                    scanner.add_image({1.0, wall_});
                }),
                HasSubstr("hand the camera to the Mapper"));
}

TEST_F(MapperCalls, ARefusedScanLeavesNoTrace) {
    mapper_.add_navigation(resting_at(1.0, {0.5, 0.5, 0.5}));
    const std::vector<Eigen::Vector3f> ends_m{{5.0F, 0.0F, 0.0F}, {6.0F, 0.0F, 0.0F}};
    const std::vector<Eigen::Vector3f> starts_m{{0.0F, 0.0F, 0.0F}};
    Scan scan;
    scan.time_s = 1.0;
    scan.ends_m = ends_m;
    scan.starts_m = starts_m;
    EXPECT_THAT(refusal([&] { mapper_.add_scan(scan); }), HasSubstr("1 starts for 2 ends"));
    scan.starts_m = {};
    EXPECT_EQ(mapper_.add_scan(scan).status, ImageStatus::integrated);
}

std::map<CellIndex, bool> statements_of(const Mapper& mapper) {
    std::map<CellIndex, bool> statements;
    mapper.for_each_statement([&](const CellIndex& cell, bool occupied) {
        EXPECT_TRUE(statements.emplace(cell, occupied).second);
    });
    return statements;
}

TEST_F(MapperCalls, TellsWhatTheLastImageSays) {
    EXPECT_TRUE(statements_of(mapper_).empty());
    const std::vector<Eigen::Vector3f> far_m{{2.0F, 0.0F, 0.0F}};
    const std::vector<Eigen::Vector3f> near_m{{1.0F, 0.0F, 0.0F}};
    mapper_.add_navigation(resting_at(1.0, {0.5, 0.5, 0.5}));
    Scan scan;
    scan.time_s = 1.0;
    scan.ends_m = far_m;
    mapper_.add_scan(scan);
    const std::map<CellIndex, bool> expected{
        {{0, 0, 0}, false}, {{1, 0, 0}, false}, {{2, 0, 0}, true}};
    EXPECT_EQ(statements_of(mapper_), expected);
    scan.time_s = 1.01;
    scan.ends_m = near_m;
    mapper_.add_scan(scan);
    const std::map<CellIndex, bool> shorter{{{0, 0, 0}, false}, {{1, 0, 0}, true}};
    EXPECT_EQ(statements_of(mapper_), shorter);
    EXPECT_EQ(mapper_.value({2, 0, 0}), 2) << "what earlier images said is in the cells";
    mapper_.add_scan(scan); // not after the last one: skipped
    EXPECT_EQ(statements_of(mapper_), shorter);
}

TEST_F(MapperCalls, OptionsAndWindowAreCheckedAtOnce) {
    MapperOptions options = short_range();
    options.zone = 7;
    EXPECT_THAT(refusal([&] { Mapper{options}; }), HasSubstr("zone is 7"));
    options = short_range();
    options.cell_m = 0.001;
    EXPECT_THROW(Mapper{options}, CapacityError);
    options.backend = "warp";
    options.cell_m = 1.0;
    EXPECT_THAT(refusal([&] { Mapper{options}; }), HasSubstr("backend is warp"));
}

TEST_F(MapperCalls, ACutThatIsNoNumberIsRefused) {
    EXPECT_THAT(
        refusal([&] { (void)mapper_.height_profile(std::numeric_limits<double>::quiet_NaN()); }),
        HasSubstr("cut height"));
}

TEST_F(MapperCalls, OptionsAreThoseHandedIn) {
    EXPECT_EQ(mapper_.options().range_m, 12.0);
    EXPECT_EQ(mapper_.options().zone, 8);
}

TEST_F(MapperCalls, MovingAMapperTakesItsMapAlong) {
    mapper_.add_navigation(resting_at(1.0, {0.0, 0.0, 0.0}));
    show_wall(1.0);
    const auto before = scenes::values_of(mapper_);
    const Mapper moved = std::move(mapper_);
    EXPECT_EQ(scenes::values_of(moved), before);
    EXPECT_FALSE(before.empty());
}

TEST_F(MapperCalls, NoImageYetMeansAnEmptyMap) {
    EXPECT_TRUE(mapper_.objects().empty());
    EXPECT_TRUE(mapper_.height_profile().columns.empty());
    EXPECT_EQ(mapper_.value({0, 0, 0}), 0);
    EXPECT_TRUE(scenes::values_of(mapper_).empty());
    EXPECT_EQ(mapper_.statistics().cells_occupied, 0U);
}

} // namespace
} // namespace zonegrid
