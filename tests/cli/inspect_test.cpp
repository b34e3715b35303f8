#include "cli/command_fixture.h"

#include <cmath>
#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class InspectTest : public CommandTest {
protected:
    [[nodiscard]] nlohmann::json inspect(const std::string& options = "") const {
        const CommandResult result = run("zonegrid inspect recording --json " + options);
        EXPECT_EQ(result.exit_code, 0) << result.errors;
        return nlohmann::json::parse(result.output);
    }
};

/// A camera at (x, 0, z) in optical axes, turned by `yaw_rad` about y, as camera-to-world.
std::vector<double> turned_pose(double yaw_rad, double x_m, double z_m) {
    const double c = std::cos(yaw_rad);
    const double s = std::sin(yaw_rad);
    return {c, 0, s, x_m, 0, 1, 0, 0, -s, 0, c, z_m, 0, 0, 0, 1};
}

/// The same pose the wrong way round, as world-to-camera.
std::vector<double> inverted(const std::vector<double>& pose) {
    const double c = pose[0];
    const double s = pose[2];
    return {c, 0, -s, -(c * pose[3] - s * pose[11]), 0, 1, 0, 0,
            s, 0, c,  -(s * pose[3] + c * pose[11]), 0, 0, 0, 1};
}

/// Drives a curve before a wall 6 m ahead in the world.
SmallRecording curve(bool inside_out) {
    const auto yaw_rad = [](std::size_t image) { return 0.03 * static_cast<double>(image); };
    const auto z_m = [](std::size_t image) { return 0.12 * static_cast<double>(image); };
    SmallRecording recording;
    recording.pose = [=](std::size_t image) {
        const std::vector<double> pose =
            turned_pose(yaw_rad(image), 0.05 * static_cast<double>(image), z_m(image));
        return inside_out ? inverted(pose) : pose;
    };
    recording.depth_m = [=](std::size_t image, int u, int /*v*/) {
        const double slope = (u - 15.5) / 24.0;
        return (6.0 - z_m(image)) / (std::cos(yaw_rad(image)) - slope * std::sin(yaw_rad(image)));
    };
    return recording;
}

TEST_F(InspectTest, TellsWhatIsInTheRecording) {
    write_recording();
    const nlohmann::json report = inspect();
    EXPECT_EQ(report["recording"]["layout"], "poses");
    EXPECT_EQ(report["frames"]["count"], 8);
    EXPECT_NEAR(report["frames"]["rate_hz"].get<double>(), 30.0, 1e-6);
    EXPECT_NEAR(report["path"]["length_m"].get<double>(), 0.7, 1e-9);
    EXPECT_NEAR(report["path"]["greatest_step_m"].get<double>(), 0.1, 1e-9);
    EXPECT_NEAR(report["path"]["greatest_speed_mps"].get<double>(), 3.0, 1e-6);
    EXPECT_NEAR(report["contents"]["valid_share"]["median"].get<double>(), 767.0 / 768.0, 1e-9);
    EXPECT_NEAR(report["contents"]["depth_m"]["least"].get<double>(), 2.3, 1e-6);
    EXPECT_NEAR(report["contents"]["depth_m"]["greatest"].get<double>(), 5.0, 1e-6);
    EXPECT_THAT(report["warnings"], IsEmpty());
}

TEST_F(InspectTest, PrintsTextWithTheNotesOfTheReader) {
    write_recording();
    const CommandResult result = run("zonegrid inspect recording");
    EXPECT_EQ(result.exit_code, 0);
    for (const char* const part : {"poses", "32 x 24", "Intrinsics", "0.70 m long", "99.9 %"}) {
        EXPECT_THAT(result.output, HasSubstr(part));
    }
}

TEST_F(InspectTest, TellsPosesFromInvertedOnes) {
    write_recording(curve(false));
    const nlohmann::json right = inspect();
    EXPECT_LT(right["pose_direction"]["difference_as_stated_m"], 0.01);
    EXPECT_GT(right["pose_direction"]["difference_inverted_m"], 0.1);
    EXPECT_THAT(right["warnings"], IsEmpty());
    write_recording(curve(true));
    const nlohmann::json wrong = inspect();
    EXPECT_GT(wrong["pose_direction"]["difference_as_stated_m"], 0.1);
    EXPECT_LT(wrong["pose_direction"]["difference_inverted_m"], 0.01);
    EXPECT_THAT(wrong["warnings"], Contains(HasSubstr("invert its poses")));
}

TEST_F(InspectTest, SuspectsTheDepthScale) {
    write_recording();
    EXPECT_THAT(inspect("--depth-scale 1")["warnings"], Contains(HasSubstr("--depth-scale")));
    EXPECT_THAT(inspect("--depth-scale 1000000")["warnings"], Contains(HasSubstr("--depth-scale")));
}

TEST_F(InspectTest, SuspectsTheWorldAxes) {
    write_recording();
    // The camera looks along the world's z axis: upwards, if z is taken for up.
    EXPECT_THAT(inspect("--world-axes z_up")["warnings"],
                Contains(HasSubstr("straight up or down in 100 %")));
}

TEST_F(InspectTest, SuspectsAVerticalPath) {
    SmallRecording recording;
    recording.images = 20;
    write_recording(recording);
    EXPECT_THAT(inspect("--world-axes z_up")["warnings"], Contains(HasSubstr("1.9 m in height")));
}

TEST_F(InspectTest, CountsDamagedImages) {
    write_recording();
    write_file("recording/frame-000004.depth.png", "no picture");
    const nlohmann::json report = inspect("--all");
    EXPECT_EQ(report["contents"]["read"], 7);
    EXPECT_EQ(report["contents"]["damaged"], 1);
    EXPECT_THAT(report["warnings"], Contains(HasSubstr("frame-000004.depth.png")));
}

TEST_F(InspectTest, ReadsEveryImageWhenAsked) {
    SmallRecording recording;
    recording.images = 60;
    write_recording(recording);
    EXPECT_EQ(inspect()["contents"]["read"], 50);
    EXPECT_EQ(inspect("--all")["contents"]["read"], 60);
}

} // namespace
} // namespace zonegrid::testing
