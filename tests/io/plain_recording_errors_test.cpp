#include "io/recording.h"

#include "io/recording_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace zonegrid {
namespace {

using testing::RecordingFolder;
using testing::refuses;

constexpr const char* camera_table =
    "[camera]\nmodel = \"pinhole\"\nwidth_px = 3\nheight_px = 2\n"
    "fx_px = 2\nfy_px = 2.5\ncx_px = 1.0\ncy_px = 0.5\n";
constexpr const char* navigation_rows =
    "time_s,north_m,east_m,down_m,roll_rad,pitch_rad,yaw_rad\n"
    "1.00,10,20,-30,0.1,-0.2,0.3\n";

void fill(const RecordingFolder& folder, const std::string& description,
          const std::string& navigation = navigation_rows) {
    folder.write_depth("depth/a.png", 3, std::array<std::uint16_t, 6>{1000});
    folder.write("description.toml", description);
    folder.write("navigation.csv", navigation);
    folder.write("frames.csv", "time_s,file\n1.002,depth/a.png\n");
}

auto opening(const RecordingFolder& folder) {
    return [&folder] { return open_recording(folder.path()); };
}

struct BadDescription {
    std::string text;
    std::string place;
    std::string message;
};

TEST(PlainDescription, RefusesBadKeysAndNamesThem) {
    const std::string camera = camera_table;
    const std::string depth = "[depth]\nunits_per_m = 1000\n";
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = camera;
        changed.replace(changed.find(from), from.size(), to);
        return changed + depth;
    };
    const RecordingFolder folder;
    const std::vector<BadDescription> cases{
        {"[camera\n", ".toml:1", "TOML"},
        {"", "description.toml", "neither a [camera] nor a [scanner]"},
        {"# nothing\n", "description.toml", "neither a [camera] nor a [scanner]"},
        {camera + "[scanner]\n", "description.toml", "both"},
        {camera + "colour = 1\n", ".toml:9", "camera.colour is unknown"},
        {camera + "k1 = 0.1\n", ".toml:9", "camera.k1 is unknown or does not apply"},
        {camera + depth + "[lens]\n", ".toml:11", "lens is unknown"},
        {camera + depth + "offset = 3\n", ".toml:11", "depth.offset is unknown"},
        {"[scanner]\nmodel = 1\n", ".toml:2", "scanner.model is unknown"},
        {"[scanner]\n[depth]\nkind = \"ray\"\n", ".toml:2", "depth is unknown or does not apply"},
        {with("pinhole", "fisheye"), ".toml:2", "camera.model is 'fisheye'"},
        {with("\"pinhole\"", "3"), ".toml:2", "camera.model is no text"},
        {with("model = \"pinhole\"\n", ""), ".toml:1", "camera.model is missing"},
        {with("width_px = 3", "width_px = 0"), ".toml:3", "camera.width_px is 0"},
        {with("width_px = 3", "width_px = 16385"), ".toml:3", "camera.width_px is 16385"},
        {with("width_px = 3", "width_px = 3.5"), ".toml:3", "camera.width_px is 3.5"},
        {with("height_px = 2", "height_px = \"2\""), ".toml:4", "height_px is no finite number"},
        {with("fx_px = 2", "fx_px = 0"), ".toml:5", "camera.fx_px is 0"},
        {with("fy_px = 2.5", "fy_px = -1"), ".toml:6", "camera.fy_px is -1"},
        {with("cx_px = 1.0", "cx_px = nan"), ".toml:7", "camera.cx_px is no finite number"},
        {with("cy_px = 0.5\n", ""), ".toml:1", "camera.cy_px is missing"},
        {camera, "description.toml", "depth.units_per_m is missing"},
        {camera + "[depth]\nunits_per_m = 0\n", ".toml:10", "depth.units_per_m is 0"},
        {camera + "[depth]\nunits_per_m = -1000\n", ".toml:10", "depth.units_per_m is -1000"},
        {camera + "[depth]\nunits_per_m = inf\n", ".toml:10", "units_per_m is no finite number"},
        {camera + depth + "kind = \"slant\"\n", ".toml:11", "depth.kind is 'slant'"},
        {camera + depth + "missing = 0\n", ".toml:11", "depth.missing is no list"},
        {camera + depth + "missing = [\"x\"]\n", ".toml:11", "depth.missing holds something"},
        {camera + depth + "[stereo]\nbaseline_m = 0.1\n", ".toml:11", "disparity_sigma_px is mis"},
        {camera + depth + "[stereo]\nbaseline_m = 0\ndisparity_sigma_px = 1\n", ".toml:12",
         "stereo.baseline_m is 0"},
        {camera + depth + "[mounting]\nposition_m = [1, 2]\n", ".toml:12", "no position"},
        {camera + depth + "[mounting]\nposition_m = [1, 2, nan]\n", ".toml:12", "no position"},
        {camera + depth + "[mounting]\npitch_rad = 1\n", ".toml:12", "mounting.pitch_rad is unkn"},
        {camera + depth + "[world]\naxes = \"up\"\n", ".toml:12", "world.axes is 'up'"},
        {camera + depth + "[world]\nlatitude_deg = 1\n", ".toml:11", "longitude_deg is missing"},
        {camera + depth + "[world]\nlatitude_deg = 91\nlongitude_deg = 0\naltitude_m = 0\n",
         ".toml:12", "world.latitude_deg is 91"},
        {camera + depth + "[truth]\n", ".toml:11", "truth.digest is missing"},
        {camera + depth + "[truth]\ndigest = \"" + std::string(63, 'a') + "\"\n", ".toml:12",
         "truth.digest is 'aaa"},
        {camera + depth + "[truth]\ndigest = \"" + std::string(64, 'A') + "\"\n", ".toml:12",
         "lower-case"},
        {camera + depth + "[truth]\nseed = 1\ndigest = \"" + std::string(64, 'a') + "\"\n",
         ".toml:12", "truth.seed is unknown"},
        {"camera = 3\n", ".toml:1", "camera is a value"},
    };
    for (const BadDescription& bad : cases) {
        fill(folder, bad.text);
        EXPECT_THAT(opening(folder), refuses(bad.place, bad.message)) << bad.text;
    }
}

TEST(PlainNavigation, RefusesBadTables) {
    const RecordingFolder folder;
    const auto with = [&](const std::string& navigation) {
        fill(folder, std::string(camera_table) + "[depth]\nunits_per_m = 1000\n", navigation);
        return opening(folder);
    };
    const std::string header = "time_s,north_m,east_m,down_m,roll_rad,pitch_rad,yaw_rad";
    const std::string row = "\n1,1,2,3,0,0,0\n";
    EXPECT_THAT(with(""), refuses("navigation.csv", "empty"));
    EXPECT_THAT(with(header + "\n"), refuses("navigation.csv", "no line below the header"));
    EXPECT_THAT(with(header + row + "1,1,2,3,0,0,0\n"), refuses("navigation.csv:3", "doubles"));
    EXPECT_THAT(with(header + row + "0.5,1,2,3,0,0,0\n"),
                refuses("navigation.csv:3", "is earlier than"));
    EXPECT_THAT(with(header + "\n1,1,nan,3,0,0,0\n"),
                refuses("navigation.csv:2", "east_m is 'nan'"));
    EXPECT_THAT(with(header + "\n1,1,,3,0,0,0\n"), refuses("navigation.csv:2", "east_m is ''"));
    EXPECT_THAT(with(header + "\n1,1,2,3,0,0\n"), refuses("navigation.csv:2", "6 fields"));
    EXPECT_THAT(with(header + ",north_mps" + "\n1,1,2,3,0,0,0,0\n"),
                refuses("navigation.csv:1", "no column 'east_mps'"));
    EXPECT_THAT(with(header + ",nroth_mps" + "\n1,1,2,3,0,0,0,0\n"),
                refuses("navigation.csv:1", "'nroth_mps' is unknown"));
    EXPECT_THAT(with(header + ",east_m" + "\n1,1,2,3,0,0,0,0\n"),
                refuses("navigation.csv:1", "'east_m' comes twice"));
    EXPECT_THAT(with("time_s,north_m,east_m,down_m\n1,1,2,3\n"),
                refuses("navigation.csv:1", "no column 'qx'"));
    EXPECT_THAT(with("time_s,x_m,y_m,z_m,qx,qy,qz,qw\n1,1,2,3,0,0,0,0.9\n"),
                refuses("navigation.csv:2", "norm 0.9"));
    EXPECT_THAT(with("north_m\n1\n"), refuses("navigation.csv:1", "no column 'time_s'"));

    with(header + row);
    EXPECT_THAT([&] { return open_recording(folder.path(), {.world_axes = WorldAxes::z_up}); },
                refuses("navigation.csv:1", "axes z_up"));
    folder.write("frames.csv", "time_s,file\n1,depth/a.png\n1,depth/a.png\n");
    EXPECT_THAT(opening(folder), refuses("frames.csv:3", "doubles"));
    folder.write("frames.csv", "time_s,path\n1,depth/a.png\n");
    EXPECT_THAT(opening(folder), refuses("frames.csv:1", "no column 'file'"));
}

} // namespace
} // namespace zonegrid
