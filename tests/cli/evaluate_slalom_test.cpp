#include "cli/command_fixture.h"

#include "device/device_choice.h"

#include <string>
#include <vector>

// The shipped flight through a line of trees, with all faults of camera and navigation.

namespace zonegrid::testing {
namespace {

class EvaluateSlalomTest : public CommandTest {
protected:
    const std::string slalom_ = ZONEGRID_SOURCE_DIR "/data/slalom";

    nlohmann::json map_with(const std::string& options) const {
        const auto result = run("zonegrid map '" + slalom_ +
                                "' -o map --overwrite --quiet --cell 1 --history " + options);
        EXPECT_EQ(result.exit_code, 0) << result.errors;
        return read_json("map/report.json");
    }
};

TEST_F(EvaluateSlalomTest, IsMappedAlikeOnEveryDevice) {
    for (const std::string model : {"line", "span"}) {
        const auto expected = map_with("--model " + model);
        EXPECT_GT(expected["map"]["cells_occupied"], 5000);
        const auto history = run("sha256sum < map/history.zgrid").output;
        for (const auto& info : device::usable_devices(device::list_devices())) {
            const auto actual = map_with("--model " + model + " --backend " + info.id());
            EXPECT_EQ(actual["digest"], expected["digest"]) << info.id() << ", " << model;
            EXPECT_EQ(run("sha256sum < map/history.zgrid").output, history) << info.id();
        }
    }
}

TEST_F(EvaluateSlalomTest, FindsTheTreesApartAndInLine) {
    static_cast<void>(map_with("--model span"));
    const auto result =
        run("zonegrid evaluate map --truth '" + slalom_ + "/truth' -o judged --quiet");
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const auto judged = read_json("judged/evaluation.json");
    int trees = 0;
    for (const auto& obstacle : judged["obstacles"]["each"]) {
        EXPECT_TRUE(obstacle["found"]) << obstacle["name"];
        if (obstacle["kind"] == "tree") {
            ++trees;
            EXPECT_GT(obstacle["detection"]["distance_m"], 25.0) << obstacle["name"];
            EXPECT_FALSE(obstacle["merged"]) << obstacle["name"];
            EXPECT_LT(obstacle["horizontal_error_m"], 3.0) << obstacle["name"];
        }
    }
    EXPECT_EQ(trees, 4);
    ASSERT_EQ(judged["lines"].size(), 1U);
    EXPECT_LT(judged["lines"][0]["line_error_m"], 1.0);
    ASSERT_EQ(judged["lines"][0]["gaps"].size(), 3U);
    for (const auto& gap : judged["lines"][0]["gaps"]) {
        EXPECT_GT(gap["clear_m"], 7.0) << gap;
    }
    EXPECT_LT(judged["cells"]["wrong_free_solid"]["share"], 0.01);
    EXPECT_LT(judged["cells"]["wrong_free_surface"]["share"], 0.05);
}

} // namespace
} // namespace zonegrid::testing
