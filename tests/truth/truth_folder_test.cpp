#include "truth/truth_folder.h"

#include "io/recording.h"
#include "io/sha256.h"
#include "support/temporary_folder.h"
#include "truth/surfaces_ply.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace zonegrid::testing {
namespace {

namespace fs = std::filesystem;

Eigen::Isometry3d pose(double turn_rad, const Eigen::Vector3d& place_m) {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = attitude_from_euler(turn_rad / 3.0, -turn_rad, turn_rad).toRotationMatrix();
    result.translation() = place_m;
    return result;
}

NavigationSample sample_at(double time_s) {
    NavigationSample sample;
    sample.time_s = time_s;
    sample.position_m = {1.0 / 3.0, -0.1, 1e-300};
    sample.velocity_mps = {5.1, -0.0, 1e17 / 7.0};
    sample.acceleration_mps2 = {std::nextafter(0.3, 1.0), 2.0, -3.0};
    sample.world_from_body = attitude_from_euler(0.1, 0.2, 0.3 + time_s);
    sample.body_rate_radps = {1e-9, 0.1 + 0.2, -0.7};
    return sample;
}

/// Two obstacles of which the second moves; numbers that short decimals do not hold.
Truth example_truth() {
    Truth truth;
    truth.scene = "two \"things\"";
    truth.seed = std::numeric_limits<std::uint64_t>::max();
    truth.camera.width_px = 640;
    truth.camera.height_px = 480;
    truth.camera.fx_px = 320.0 / std::tan(0.445);
    truth.camera.fy_px = 659.4;
    truth.camera.cx_px = 319.5;
    truth.camera.cy_px = 239.5;
    truth.camera.stereo = StereoNoise{0.3, 0.25};
    truth.camera.body_from_camera = pose(0.4, {0.1, 1.0 / 7.0, -2.0});
    truth.surfaces.vertices_m = {{0, 0, 0},
                                 {1.0F / 3.0F, 0, std::numeric_limits<float>::denorm_min()},
                                 {0, -0.0F, 1e30F},
                                 {1, 2, 3}};
    truth.surfaces.triangles = {{0, 1, 2}, {3, 2, 1}, {0, 1, 3}};
    truth.surfaces.obstacles = {{"ground", ObstacleKind::ground, 0, 2, false},
                                {"vehicle, 2", ObstacleKind::aircraft, 2, 1, true}};
    truth.motions = {
        {1, {{0.1, pose(0.0, {0, 0, 0})}, {1.0 / 3.0, pose(0.5, {1, 2, 3})}}},
    };
    truth.navigation = {sample_at(1721907000.013), sample_at(1721907000.023)};
    truth.images = {{1721907000.0140001, pose(1.1, {9.0 / 7.0, 2, 3})},
                    {1721907000.047, pose(-1.1, {9, 2, -3})}};
    return truth;
}

// Bits, not values: 0 and -0 are different, and NaN would be equal to itself.
void expect_bits(double read, double written) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(written))
        << read << " " << written;
}

template <class Matrix>
void expect_same(const Matrix& read, const Matrix& written) {
    for (Eigen::Index i = 0; i < written.size(); ++i) {
        expect_bits(static_cast<double>(read.data()[i]), static_cast<double>(written.data()[i]));
    }
}

void expect_same(const NavigationSample& read, const NavigationSample& written) {
    expect_bits(read.time_s, written.time_s);
    expect_same(read.position_m, written.position_m);
    expect_same(read.velocity_mps, written.velocity_mps);
    expect_same(read.acceleration_mps2, written.acceleration_mps2);
    expect_same(read.world_from_body.coeffs(), written.world_from_body.coeffs());
    expect_same(read.body_rate_radps, written.body_rate_radps);
}

void expect_same(const Surfaces& read, const Surfaces& written) {
    ASSERT_EQ(read.vertices_m.size(), written.vertices_m.size());
    for (std::size_t i = 0; i < written.vertices_m.size(); ++i) {
        expect_same(read.vertices_m[i], written.vertices_m[i]);
    }
    EXPECT_EQ(read.triangles, written.triangles);
    ASSERT_EQ(read.obstacles.size(), written.obstacles.size());
    for (std::size_t i = 0; i < written.obstacles.size(); ++i) {
        EXPECT_EQ(read.obstacles[i].name, written.obstacles[i].name);
        EXPECT_EQ(read.obstacles[i].kind, written.obstacles[i].kind);
        EXPECT_EQ(read.obstacles[i].first_triangle, written.obstacles[i].first_triangle);
        EXPECT_EQ(read.obstacles[i].triangles, written.obstacles[i].triangles);
        EXPECT_EQ(read.obstacles[i].moving, written.obstacles[i].moving);
    }
}

void expect_same(const Camera& read, const Camera& written) {
    EXPECT_EQ(read.width_px, written.width_px);
    EXPECT_EQ(read.height_px, written.height_px);
    expect_bits(read.fx_px, written.fx_px);
    expect_bits(read.fy_px, written.fy_px);
    expect_bits(read.cx_px, written.cx_px);
    expect_bits(read.cy_px, written.cy_px);
    ASSERT_EQ(read.stereo.has_value(), written.stereo.has_value());
    if (written.stereo) {
        expect_bits(read.stereo->baseline_m, written.stereo->baseline_m);
        expect_bits(read.stereo->disparity_sigma_px, written.stereo->disparity_sigma_px);
    }
    expect_same(read.body_from_camera.matrix(), written.body_from_camera.matrix());
}

void expect_same(const Truth& read, const Truth& written) {
    EXPECT_EQ(read.scene, written.scene);
    EXPECT_EQ(read.seed, written.seed);
    expect_same(read.camera, written.camera);
    expect_same(read.surfaces, written.surfaces);
    ASSERT_EQ(read.motions.size(), written.motions.size());
    for (std::size_t i = 0; i < written.motions.size(); ++i) {
        EXPECT_EQ(read.motions[i].obstacle, written.motions[i].obstacle);
        ASSERT_EQ(read.motions[i].poses.size(), written.motions[i].poses.size());
        for (std::size_t k = 0; k < written.motions[i].poses.size(); ++k) {
            const MovingPose& expected = written.motions[i].poses[k];
            expect_bits(read.motions[i].poses[k].time_s, expected.time_s);
            expect_same(read.motions[i].poses[k].world_from_obstacle.matrix(),
                        expected.world_from_obstacle.matrix());
        }
    }
    ASSERT_EQ(read.navigation.size(), written.navigation.size());
    for (std::size_t i = 0; i < written.navigation.size(); ++i) {
        expect_same(read.navigation[i], written.navigation[i]);
    }
    ASSERT_EQ(read.images.size(), written.images.size());
    for (std::size_t i = 0; i < written.images.size(); ++i) {
        expect_bits(read.images[i].time_s, written.images[i].time_s);
        expect_same(read.images[i].world_from_camera.matrix(),
                    written.images[i].world_from_camera.matrix());
    }
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

/// The message with which the folder is refused; empty if it is read.
std::string refusal(const fs::path& folder) {
    try {
        static_cast<void>(read_truth(folder));
        return {};
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(TruthFolder, GivesBackEveryBit) {
    const TemporaryFolder folder;
    const Truth written = example_truth();
    write_truth(folder.path(), written);
    expect_same(read_truth(folder.path()), written);
}

TEST(TruthFolder, HoldsAWorldInWhichNobodyFlewAndNothingMoves) {
    const TemporaryFolder folder;
    Truth written = example_truth();
    written.navigation.clear();
    written.images.clear();
    written.motions.clear();
    written.surfaces.obstacles[1].moving = false;
    written.camera.stereo.reset();
    write_truth(folder.path(), written);
    expect_same(read_truth(folder.path()), written);
}

TEST(TruthFolder, HoldsTheTrianglesAsAnyProgramReadsThem) {
    const TemporaryFolder folder;
    write_truth(folder.path(), example_truth());
    const std::string ply = text_of(folder.path() / "surfaces.ply");
    EXPECT_THAT(ply, ::testing::StartsWith("ply\nformat binary_little_endian 1.0\n"));
    const std::string end = "end_header\n";
    const std::string body = ply.substr(ply.find(end) + end.size());
    ASSERT_EQ(body.size(), 4U * 12U + 3U * 13U);
    // Vertex 3 is (1, 2, 3), triangle 1 is (3, 2, 1), as IEEE 754 and the PLY of 1998 write them.
    EXPECT_EQ(body.substr(36, 12), std::string("\0\0\x80\x3F\0\0\0\x40\0\0\x40\x40", 12));
    EXPECT_EQ(body.substr(48 + 13, 13), std::string("\3\3\0\0\0\2\0\0\0\1\0\0\0", 13));
}

TEST(TruthFolder, IsRefusedWhereverAFileIsCutOff) {
    const TemporaryFolder folder;
    write_truth(folder.path(), example_truth());
    int cuts = 0;
    for (const char* name :
         {"truth.json", "surfaces.ply", "navigation.csv", "images.csv", "motions.csv"}) {
        const fs::path file = folder.path() / name;
        const std::string whole = text_of(file);
        // All cuts within the last numbers, where a shorter number would still be one.
        for (std::size_t size = 0; size + 1 < whole.size();
             size += size + 40 < whole.size() ? 17U : 1U) {
            write_text(file, whole.substr(0, size));
            EXPECT_THAT(refusal(folder.path()), ::testing::HasSubstr(name)) << size;
            ++cuts;
        }
        write_text(file, whole);
    }
    EXPECT_GT(cuts, 300);
    EXPECT_EQ(refusal(folder.path()), "");
}

TEST(TruthFolder, IsRefusedWithoutOneOfItsFiles) {
    for (const char* name :
         {"truth.json", "surfaces.ply", "navigation.csv", "images.csv", "motions.csv"}) {
        const TemporaryFolder folder;
        write_truth(folder.path(), example_truth());
        fs::remove(folder.path() / name);
        EXPECT_THAT(refusal(folder.path()), ::testing::HasSubstr(name));
    }
}

struct Damage {
    const char* file;
    std::string from;
    std::string to;
    std::string message;
};

TEST(TruthFolder, IsRefusedIfItsFilesContradictEachOtherOrThemselves) {
    const std::vector<Damage> damages{
        {"truth.json", "\"version\": 1", "\"version\": 2", "version 2"},
        {"truth.json", "\"seed\"", "\"sead\"", "seed"},
        {"truth.json", "\"aircraft\"", "\"airship\"", "an obstacle is a 'airship'"},
        {"truth.json", "\"name\": \"ground\"", "\"name\": \"vehicle, 2\"", "two obstacles"},
        {"truth.json", "\"first_triangle\": 2", "\"first_triangle\": 1", "begins at triangle 1"},
        {"truth.json", "\"triangles\": 1", "\"triangles\": 2", "the obstacles have 4 triangles"},
        {"truth.json", "\"moving\": false", "\"moving\": true", "2 obstacles move"},
        {"truth.json", "\"moving\": true", "\"moving\": false", "obstacle 1 is none that moves"},
        {"truth.json", "\"images\": 2", "\"images\": 3", "images.csv: 2 lines"},
        {"truth.json", "\"images\": 2", "\"images\": 0", "truth.json says that there is none"},
        {"truth.json", "\"width_px\": 640", "\"width_px\": 0", "not above 0"},
        {"truth.json", "\"fx_px\": ", "\"fx_px\": -", "not above 0"},
        {"surfaces.ply", "little", "big___", "the header"},
        {"surfaces.ply", "float x", "float y", "the header"},
        {"surfaces.ply", "vertex 4", "vertex 5", "do not fill exactly"},
        {"surfaces.ply", "face 3", "face 9223372036854775807", "do not fill exactly"},
        {"surfaces.ply", std::string("\3\3\0\0\0", 5), std::string("\4\3\0\0\0", 5),
         "face 1 has 4 corners"},
        {"surfaces.ply", std::string("\3\3\0\0\0", 5), std::string("\3\4\0\0\0", 5),
         "triangle 1 names vertex 4"},
        {"navigation.csv", "qw", "q_w", "no column 'qw'"},
        {"navigation.csv", "1721907000.023", "1721907000.003", "navigation.csv:3"},
        {"images.csv", "x_north", "north", "no column 'x_north'"},
        {"images.csv", "1721907000.047", "1721907000.007", "images.csv:3"},
        {"motions.csv", "\n1,0.333", "\n0,0.333", "motions.csv:3: obstacle 0 is none that moves"},
        {"motions.csv", "\n1,0.333", "\n2,0.333", "motions.csv:3: obstacle 2 is none that moves"},
        {"motions.csv", "0.1,0,0,0,1,", "0.1,0,0,0,2,", "motions.csv:2: the axes"},
        {"motions.csv", "0.1,0,0,0,1,", "0.1,0,0,1e7,1,", "motions.csv:2: the place is beyond"},
        {"motions.csv", "\n1,0.333", "\n1,0.033", "motions.csv:3: time"},
    };
    for (const Damage& damage : damages) {
        const TemporaryFolder folder;
        write_truth(folder.path(), example_truth());
        std::string text = text_of(folder.path() / damage.file);
        const std::size_t at = text.find(damage.from);
        ASSERT_NE(at, std::string::npos) << damage.from;
        write_text(folder.path() / damage.file, text.replace(at, damage.from.size(), damage.to));
        EXPECT_THAT(refusal(folder.path()), ::testing::HasSubstr(damage.message))
            << damage.from << " -> " << damage.to;
    }
}

TEST(TruthFolder, HasADigestOfEveryByte) {
    const TemporaryFolder folder;
    write_truth(folder.path(), example_truth());
    const std::string digest = digest_of_truth(folder.path());
    Sha256 all;
    for (const char* name :
         {"truth.json", "surfaces.ply", "navigation.csv", "images.csv", "motions.csv"}) {
        const fs::path file = folder.path() / name;
        std::string text = text_of(file);
        all.add(text);
        ++text.back();
        write_text(file, text);
        EXPECT_NE(digest_of_truth(folder.path()), digest) << name;
        --text.back();
        write_text(file, text);
    }
    EXPECT_EQ(digest, all.finish_hex());
    EXPECT_EQ(digest_of_truth(folder.path()), digest);
    fs::remove(folder.path() / "motions.csv");
    EXPECT_NE(digest_of_truth(folder.path()), digest);
}

TEST(TruthFolder, OfTheShippedSlalomIsTheOneThatItsRecordingStates) {
    const fs::path slalom = fs::path(ZONEGRID_SOURCE_DIR) / "data" / "slalom";
    EXPECT_EQ(open_recording(slalom)->truth_digest(), digest_of_truth(slalom / "truth"));
}

TEST(TruthFolder, IsNotWrittenIfItCouldNotBeRead) {
    const TemporaryFolder folder;
    Truth broken = example_truth();
    broken.surfaces.triangles[0][0] = 4;
    EXPECT_THROW(write_truth(folder.path(), broken), InputError);
    broken = example_truth();
    broken.camera.directions.resize(640 * 480);
    EXPECT_THROW(write_truth(folder.path(), broken), UsageError);
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_THROW(write_truth(folder.path() / "absent", example_truth()), OutputError);
}

TEST(ObstacleMotion, MovesEvenlyBetweenItsEntriesAndRestsOutside) {
    ObstacleMotion motion{3, {{1.0, pose(0.0, {0, 0, -4})}, {3.0, pose(0.0, {8, -2, -4})}}};
    motion.poses[1].world_from_obstacle.linear() =
        attitude_from_euler(0, 0, 1.2).toRotationMatrix();
    const Eigen::Isometry3d quarter = motion.at(1.5);
    EXPECT_TRUE(quarter.translation().isApprox(Eigen::Vector3d(2, -0.5, -4), 1e-12));
    EXPECT_TRUE(quarter.linear().isApprox(attitude_from_euler(0, 0, 0.3).toRotationMatrix(), 1e-9));
    for (const double time_s : {-5.0, 1.0}) {
        expect_same(motion.at(time_s).matrix(), motion.poses[0].world_from_obstacle.matrix());
    }
    for (const double time_s : {3.0, 3.1, 1e9}) {
        expect_same(motion.at(time_s).matrix(), motion.poses[1].world_from_obstacle.matrix());
    }
    motion.poses.clear();
    EXPECT_THROW(static_cast<void>(motion.at(0.0)), UsageError);
}

} // namespace
} // namespace zonegrid::testing
