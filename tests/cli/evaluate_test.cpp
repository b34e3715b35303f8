#include "cli/command_fixture.h"

#include "io/flight_writer.h"
#include "io/generated_flight.h"
#include "truth/ray_caster.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// A flight of a second and a half past two boxes on a floor, with exact depth and navigation.
class EvaluateTest : public CommandTest {
protected:
    static constexpr int images = 15;

    void SetUp() override { write_flight_of("recording", images, 7); }

    /// Writes the recording `name` with its truth.
    void write_flight_of(const std::string& name, int count, std::uint64_t seed) const {
        Truth truth = scene();
        truth.seed = seed;
        FlightPlan plan;
        plan.camera = truth.camera;
        for (int i = 0; i < count; ++i) {
            fly(i, truth, plan);
        }
        std::filesystem::create_directories(path(name) / "truth");
        write_flight(path(name), GeneratedFlight(std::move(plan)));
        write_truth(path(name) / "truth", truth);
        std::ofstream(path(name) / "description.toml", std::ios::app)
            << fmt::format("[truth]\ndigest = \"{}\"\n", digest_of_truth(path(name) / "truth"));
    }

private:
    static void add_box(Surfaces& surfaces, const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                        const std::string& name, ObstacleKind kind) {
        const auto first = static_cast<std::uint32_t>(surfaces.vertices_m.size());
        for (std::uint32_t i = 0; i < 8; ++i) {
            surfaces.vertices_m.emplace_back((i & 1U) != 0 ? high.x() : low.x(),
                                             (i & 2U) != 0 ? high.y() : low.y(),
                                             (i & 4U) != 0 ? high.z() : low.z());
        }
        const auto triangles = static_cast<std::uint32_t>(surfaces.triangles.size());
        // Two triangles a face, corners named by their bits.
        for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 1, 3, 2},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 3, 7, 6},
                                         {0, 2, 6, 4},
                                         {1, 3, 7, 5}}) {
            surfaces.triangles.push_back({first + a, first + b, first + c});
            surfaces.triangles.push_back({first + a, first + c, first + d});
        }
        surfaces.obstacles.push_back({name, kind, triangles, 12, false});
    }

    static Truth scene() {
        Truth truth;
        truth.scene = "two boxes";
        truth.camera.width_px = 96;
        truth.camera.height_px = 72;
        truth.camera.fx_px = truth.camera.fy_px = 80.0;
        truth.camera.cx_px = 47.5;
        truth.camera.cy_px = 35.5;
        truth.camera.body_from_camera.linear() = body_from_forward_camera();
        add_box(truth.surfaces, {-10.0F, -20.0F, 2.3F}, {40.0F, 20.0F, 2.7F}, "floor",
                ObstacleKind::ground);
        add_box(truth.surfaces, {14.25F, -4.75F, -0.75F}, {15.75F, -2.25F, 2.3F}, "left box",
                ObstacleKind::building);
        add_box(truth.surfaces, {16.25F, 2.25F, -0.75F}, {17.75F, 3.75F, 2.3F}, "right box",
                ObstacleKind::building);
        return truth;
    }

    static void fly(int image, Truth& truth, FlightPlan& plan) {
        const double time_s = 100.0 + 0.1 * image;
        NavigationSample sample;
        sample.time_s = time_s;
        sample.position_m = Eigen::Vector3d(0.5 * image, 0.1, -0.2);
        sample.velocity_mps.x() = 5.0;
        truth.navigation.push_back(sample);
        plan.navigation.push_back({sample, Eigen::Vector3d::Zero()});
        TrueImage at;
        at.time_s = time_s;
        at.world_from_camera =
            Eigen::Translation3d(sample.position_m) * truth.camera.body_from_camera;
        truth.images.push_back(at);
        plan.times_s.push_back(time_s);
        FrameData frame;
        frame.depth_m.resize(96U * 72U);
        RayCaster(truth.surfaces).draw(truth.camera, at.world_from_camera, frame.depth_m);
        plan.frames.push_back(std::move(frame));
    }
};

constexpr const char* map_line = "zonegrid map recording -o map --cell 0.5 --range 18 --quiet ";

TEST_F(EvaluateTest, JudgesARealMapOfAPerfectSensor) {
    ASSERT_EQ(run(std::string(map_line) + "--history").errors, "");
    const CommandResult result = run("zonegrid evaluate map --truth recording/truth -o judged");
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, IsEmpty());
    EXPECT_THAT(result.output, AllOf(HasSubstr("precision within 0 cells"), HasSubstr("left box"),
                                     HasSubstr("3 visible, 3 found, 0 never visible")));
    for (const char* const name : {"profiles.png", "profiles_3d.png", "measures.png"}) {
        EXPECT_THAT(read_file(std::string("judged/") + name), StartsWith("\x89PNG")) << name;
    }
    const nlohmann::json marks = read_json("judged/evaluation.json");
    EXPECT_EQ(marks["truth"]["scene"], "two boxes");
    EXPECT_EQ(marks["truth"]["seed"], 7);
    EXPECT_EQ(marks["truth"]["images"], images);
    EXPECT_EQ(marks["truth"]["unplaced_hits"], 0);
    const auto& cells = marks["cells"];
    EXPECT_GT(cells["precision"][0]["share"], 0.99);
    EXPECT_EQ(cells["precision"][1]["share"], 1.0);
    // Far floor is seen at a slant: cells in which few rays end are passed by many, and cleared.
    EXPECT_GT(cells["recall"][0]["share"], 0.75);
    EXPECT_GT(cells["recall"][2]["share"], 0.99);
    EXPECT_EQ(cells["wrong_free_solid"]["count"], 0);
    EXPECT_LT(cells["unknown_free"]["share"], 0.05);
    const auto& box = marks["obstacles"]["each"][1];
    EXPECT_EQ(box["name"], "left box");
    EXPECT_EQ(box["found"], true);
    EXPECT_EQ(box["merged"], false);
    EXPECT_LT(box["horizontal_error_m"], 0.3);
    // In sight from the start, 14.25 m ahead and 2.35 m aside; held from the first images on.
    EXPECT_EQ(box["first_sight"]["image"], 0);
    EXPECT_NEAR(box["first_sight"]["distance_m"], std::hypot(14.25, 2.35), 0.5);
    EXPECT_LE(box["detection"]["image"], 2);
    EXPECT_GT(box["detection"]["distance_m"], 12.0);
}

TEST_F(EvaluateTest, GivesTheSameMarksAgainAndOnStandardOutput) {
    ASSERT_EQ(run(std::string(map_line) + "--history").exit_code, 0);
    const std::string line = "zonegrid evaluate map --truth recording/truth --every 4 ";
    const CommandResult first = run(line + "--json -o judged");
    ASSERT_EQ(first.exit_code, 0) << first.errors;
    EXPECT_EQ(first.output, read_file("judged/evaluation.json"));
    EXPECT_EQ(read_json("judged/evaluation.json")["truth"]["images"], 4);
    EXPECT_EQ(run(line + "--json -o judged --overwrite").output, first.output);
    EXPECT_THAT(run(line + "-o judged").errors, one_line_with("judged", "--overwrite"));
    EXPECT_THAT(names(), ElementsAre("judged", "map", "recording"));
}

TEST_F(EvaluateTest, SaysWhatAMapWithoutAHistoryCannotTell) {
    ASSERT_EQ(run(map_line).exit_code, 0);
    const CommandResult result = run("zonegrid evaluate map --truth recording/truth");
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("zonegrid map --history"));
    const auto marks =
        nlohmann::json::parse(run("zonegrid evaluate map --truth recording/truth --json").output);
    EXPECT_EQ(marks["map"]["history"], false);
    EXPECT_GT(marks["cells"]["recall"][0]["share"], 0.75);
    EXPECT_TRUE(marks["obstacles"]["each"][1]["detection"].is_null());
    EXPECT_FALSE(marks["obstacles"]["each"][1]["first_sight"].is_null());
}

TEST_F(EvaluateTest, RefusesTheTruthOfAnotherRecording) {
    ASSERT_EQ(run(std::string(map_line) + "--history").exit_code, 0);
    write_flight_of("shorter", images - 1, 7);
    const CommandResult result = run("zonegrid evaluate map --truth shorter/truth -o judged");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, one_line_with("shorter/truth", "14 images", "15", "recording"));
    EXPECT_FALSE(exists("judged"));
    EXPECT_EQ(run("sed -i 's/\"first_frame_s\": 100.0/\"first_frame_s\": 300.0/' map/report.json")
                  .exit_code,
              0);
    EXPECT_THAT(run("zonegrid evaluate map --truth recording/truth").errors,
                one_line_with("recording/truth", "from 100.000", "300.000"));
    EXPECT_EQ(run("sed -i 's/\"first_frame_s\": 300.0/\"first_frame_s\": 99.9/' map/report.json")
                  .exit_code,
              0); // stamps may be late, never early
    EXPECT_THAT(run("zonegrid evaluate map --truth recording/truth").errors,
                one_line_with("recording/truth", "from 100.000", "99.900"));
}

TEST_F(EvaluateTest, RefusesTheTruthOfAnotherFlightWithAsManyImagesAtTheSameTimes) {
    ASSERT_EQ(run(std::string(map_line) + "--history --frames 2:9").exit_code, 0);
    EXPECT_EQ(run("zonegrid evaluate map --truth recording/truth --quiet").errors, "");
    write_flight_of("other", images, 8);
    const auto stated = digest_of_truth(path("recording/truth")).substr(0, 12);
    const auto others = digest_of_truth(path("other/truth")).substr(0, 12);
    const CommandResult result = run("zonegrid evaluate map --truth other/truth -o judged");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors,
                one_line_with("other/truth", others, "recording.truth_digest in map/report.json",
                              stated, "name the truth of", "recording"));
    EXPECT_FALSE(exists("judged"));
}

TEST_F(EvaluateTest, RefusesMapsOfRecordingsThatDoNotStateTheirTruth) {
    ASSERT_EQ(run("sed -i '/truth/d;/digest/d' recording/description.toml").exit_code, 0);
    ASSERT_EQ(run(std::string(map_line) + "--history").errors, "");
    EXPECT_TRUE(read_json("map/report.json")["recording"].at("truth_digest").is_null());
    const std::string line = "zonegrid evaluate map --truth recording/truth";
    const auto refusal =
        one_line_with("map/report.json", "recording.truth_digest is missing", "simulate it again");
    EXPECT_EQ(run(line).exit_code, 1);
    EXPECT_THAT(run(line).errors, refusal);
    ASSERT_EQ(run("sed -i '/truth_digest/d' map/report.json").exit_code, 0); // an older version's
    EXPECT_THAT(run(line).errors, refusal);
}

TEST_F(EvaluateTest, TakesMapsWhoseTimeStampsAreLate) {
    ASSERT_EQ(run(std::string(map_line) + "--history").exit_code, 0);
    ASSERT_EQ(run("sed -i -e 's/\"first_frame_s\": 100.0/\"first_frame_s\": 109.5/' "
                  "-e 's/\"last_frame_s\": 101.4/\"last_frame_s\": 110.9/' map/report.json && "
                  "grep -q 109.5 map/report.json && grep -q 110.9 map/report.json")
                  .exit_code,
              0);
    EXPECT_EQ(run("zonegrid evaluate map --truth recording/truth --quiet").errors, "");
}

TEST_F(EvaluateTest, RefusesFilesThatDoNotBelongTogether) {
    ASSERT_EQ(run(std::string(map_line) + "--history").exit_code, 0);
    ASSERT_EQ(
        run("zonegrid map recording -o coarse --cell 1 --range 18 --quiet --history").exit_code, 0);
    ASSERT_EQ(run("zonegrid map recording -o part --cell 0.5 --range 18 --quiet --history "
                  "--frames 0:9")
                  .exit_code,
              0);
    const auto judge_with = [this](const std::string& from, const std::string& name) {
        const CommandResult result =
            run(fmt::format("rm -rf mixed && cp -r map mixed && cp {}/{} mixed/ && "
                            "zonegrid evaluate mixed --truth recording/truth -o judged",
                            from, name));
        EXPECT_EQ(result.exit_code, 1) << from << name;
        EXPECT_FALSE(exists("judged"));
        return result.errors;
    };
    EXPECT_THAT(judge_with("coarse", "history.zgrid"),
                one_line_with("history.zgrid", "1 m wide", "0.5 m", "map the recording again"));
    EXPECT_THAT(judge_with("part", "history.zgrid"),
                one_line_with("history.zgrid", "value", "cells.zgrid"));
    EXPECT_THAT(judge_with("coarse", "cells.zgrid"),
                one_line_with("cells.zgrid", "not those of report.json"));
    EXPECT_THAT(judge_with("part", "objects.json"),
                one_line_with("objects.json", "not those of report.json"));
    EXPECT_THAT(judge_with("coarse", "report.json"), one_line_with("cells.zgrid", "report.json"));
}

TEST_F(EvaluateTest, RefusesDamagedFiles) {
    ASSERT_EQ(run(std::string(map_line) + "--history").exit_code, 0);
    const auto judge = [this](const std::string& damage) {
        const CommandResult result = run(
            fmt::format("rm -rf bad worse && cp -r map bad && cp -r recording/truth worse && {} "
                        "&& zonegrid evaluate bad --truth worse -o judged",
                        damage));
        EXPECT_EQ(result.exit_code, 1) << damage;
        EXPECT_FALSE(exists("judged")) << damage;
        return result.errors;
    };
    EXPECT_THAT(judge("truncate -s -9 bad/history.zgrid"),
                one_line_with("history.zgrid", "cut off or damaged"));
    EXPECT_THAT(judge("truncate -s -9 bad/cells.zgrid"), one_line_with("cells.zgrid", "damaged"));
    EXPECT_THAT(judge("truncate -s -9 bad/objects.json"), one_line_with("objects.json", "damaged"));
    EXPECT_THAT(judge("truncate -s -9 bad/report.json"), one_line_with("report.json", "damaged"));
    EXPECT_THAT(judge("rm bad/objects.json"), one_line_with("bad", "holds no objects.json"));
    EXPECT_THAT(judge("truncate -s -9 worse/surfaces.ply"), one_line_with("surfaces.ply"));
    EXPECT_THAT(judge("rm worse/images.csv"), one_line_with("images.csv"));
    EXPECT_THAT(run("zonegrid evaluate nowhere --truth recording/truth").errors,
                one_line_with("nowhere", "no such folder"));
}

TEST_F(EvaluateTest, NeedsATruthAndAWholeNumber) {
    EXPECT_EQ(run("zonegrid evaluate map").exit_code, 2);
    EXPECT_THAT(run("zonegrid evaluate map").errors, one_line_with("--truth"));
    EXPECT_EQ(run("zonegrid evaluate map --truth recording/truth --every 0").exit_code, 2);
}

} // namespace
} // namespace zonegrid::testing
