#include "cli/command_fixture.h"

#include <string>

// OctoMap's maps, for comparison, are judged as zonegrid's are.

namespace zonegrid::testing {
namespace {

#ifdef ZONEGRID_OCTOMAP_COMMAND

class EvaluateOctoMapTest : public CommandTest {
protected:
    const std::string slalom_ = ZONEGRID_SOURCE_DIR "/data/slalom";
    const std::string octomap_ = "'" ZONEGRID_OCTOMAP_COMMAND "'";
};

TEST_F(EvaluateOctoMapTest, IsJudgedByTheSameMeasures) {
    const auto made = run(octomap_ + " '" + slalom_ + "' -o map --cell 1");
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    EXPECT_THAT(made.output, ::testing::HasSubstr("105 images, 0 skipped"));
    const auto judged =
        run("zonegrid evaluate map --truth '" + slalom_ + "/truth' -o judged --quiet");
    ASSERT_EQ(judged.exit_code, 0) << judged.errors;
    const auto marks = read_json("judged/evaluation.json");
    EXPECT_EQ(marks["map"]["model"], "octomap");
    EXPECT_EQ(marks["obstacles"]["found"], 5);
    EXPECT_GT(marks["cells"]["recall"][1]["share"], 0.7);
    EXPECT_GT(marks["cells"]["precision"][1]["share"], 0.5);
    EXPECT_LT(marks["cells"]["unknown_free"]["share"], 0.3);
    for (const auto& obstacle : marks["obstacles"]["each"]) {
        EXPECT_FALSE(obstacle["detection"].is_null()) << obstacle["name"];
    }
}

TEST_F(EvaluateOctoMapTest, SaysWhatIsWrong) {
    const auto missing = run(octomap_ + " nowhere -o map");
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_THAT(missing.errors, ::testing::StartsWith("zonegrid-octomap: nowhere: there is no"));
    EXPECT_FALSE(exists("map"));
    EXPECT_EQ(run(octomap_ + " '" + slalom_ + "' -o map --cell 0").exit_code, 2);
}

#else

TEST(EvaluateOctoMapTest, NeedsOctoMap) {
    GTEST_SKIP() << "configured without ZONEGRID_OCTOMAP";
}

#endif

} // namespace
} // namespace zonegrid::testing
