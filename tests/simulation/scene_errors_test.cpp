#include "simulation/scene.h"

#include "io/npy.h"
#include "support/temporary_folder.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace zonegrid::testing {
namespace {

const std::string flight = // 8 lines
    "[[flight.waypoint]]\nnorth_m = 0\neast_m = 0\nheight_m = 5\n"
    "[[flight.waypoint]]\nnorth_m = 50\neast_m = 0\nheight_m = 5\n";
const std::string route = // 8 lines
    "[[vehicle.waypoint]]\nnorth_m = 0\neast_m = 0\nheight_m = 5\n"
    "[[vehicle.waypoint]]\nnorth_m = 50\neast_m = 0\nheight_m = 5\n";
const std::string place = "north_m = 1\neast_m = 2\n";

struct BadScene {
    std::string text; ///< after the flight's 8 lines
    std::string place;
    std::string message;
};

std::string refusal(const std::filesystem::path& file) {
    try {
        static_cast<void>(read_scene(file, 1));
        return {};
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST(SceneErrors, NameFileLineAndKeyAndWhatIsAllowed) {
    const std::vector<BadScene> cases{
        {"[ground\n", ":9", "TOML"},
        {"", "bad.toml", "nothing is in the world"},
        {"[grund]\n", ":9", "grund is unknown"},
        {"[ground]\ncolour = 1\n", ":10", "ground.colour is unknown"},
        {"[ground]\ntexture = 1.5\n", ":10", "ground.texture is 1.5; give a number from 0 to 1"},
        {"[ground]\nspacing_m = 0\n", ":10", "ground.spacing_m is 0"},
        {"[ground]\n[terrain]\n", ":10", "terrain comes beside [ground]"},
        {"[terrain]\n", ":9", "terrain.relief_m is missing; add it; docs/simulation.md"},
        {"[terrain]\nrelief_m = 3\n", ":9", "terrain.wavelength_m is missing"},
        {"[terrain]\nrelief_m = 3\nwavelength_m = 50\noctaves = 2.5\n", ":12",
         "octaves is 2.5; give a whole number from 1 to 8"},
        {"[terrain]\nheights = \"x.npy\"\n", ":9", "terrain.north_m is missing"},
        {"[terrain]\nheights = \"x.npy\"\nnorth_m = [3, 3]\n", ":11", "north_m is no extent"},
        {"[terrain]\nheights = \"x.npy\"\nnorth_m = [0, 1]\neast_m = [0, 1]\n", "x.npy", ""},
        {"[terrain]\nheights = \"line.npy\"\nnorth_m = [0, 1]\neast_m = [0, 1]\n", "line.npy",
         "no table of at least 2 x 2"},
        {"[terrain]\nheights = \"hole.npy\"\nnorth_m = [0, 1]\neast_m = [0, 1]\n", "hole.npy",
         "a height is not finite"},
        {"tree = 3\n", ":9", "flight.waypoint.tree is unknown"}, // TOML: the last table's key
        {"[tree]\n", ":9", "tree is no list of tables; write each as [[tree]]"},
        {"[[tree]]\neast_m = 2\n", ":9", "tree.north_m is missing"},
        {"[[tree]]\n" + place + "[[tree]]\nnorth_m = 1\n", ":12", "tree.east_m is missing"},
        {"[[tree]]\n" + place + "height_m = -1\n", ":12", "tree.height_m is -1"},
        {"[[tree]]\n" + place + "height_m = [3, 2]\n", ":12", "height_m is no range; write one"},
        {"[[tree]]\n" + place + "height_m = [1, 2, 3]\n", ":12", "height_m is no range"},
        {"[[tree]]\n" + place + "height_m = \"tall\"\n", ":12", "height_m is no finite number"},
        {"[[tree]]\n" + place + "height_m = [5, 9]\ncrown_base_m = 4.6\n", ":13",
         "tree.crown_base_m is up to 4.6; the crown must begin below"},
        {"[[tree]]\n" + place + "species = \"palm\"\n", ":12",
         "species is 'palm'; give one of \"broadleaf\", \"conifer\", \"mixed\""},
        {"[[tree]]\n" + place + "[[bush]]\n" + place + "name = \"tree 1\"\n", ":15",
         "bush.name is 'tree 1'; give a name that nothing else has"},
        {"[[tree]]\n" + place + "name = \"\"\n", ":12", "tree.name is ''"},
        {"[[tree]]\n" + place + "name = \"ground\"\n[ground]\n", ":12", "tree.name is 'ground'"},
        {"[[bush]]\n" + place + "species = \"mixed\"\n", ":12", "bush.species is unknown"},
        {"[[row]]\nof = \"house\"\n", ":10", "row.of is 'house'; give one of \"tree\", \"bush\""},
        {"[[row]]\nof = \"tree\"\n", ":9", "row.start_m is missing"},
        {"[[row]]\nstart_m = [1, 2, 3]\n", ":10", "row.start_m is no point; give [north, east]"},
        {"[[row]]\nstart_m = [1, 2]\nend_m = [3, 4]\nnumber = 1\n", ":12",
         "row.number is 1; give a whole number from 2"},
        {"[[row]]\nof = \"bush\"\nstart_m = [1, 2]\nend_m = [3, 4]\nnumber = 2\n"
         "crown_base_m = 1\n",
         ":14", "row.crown_base_m is unknown or does not apply here"},
        {"[[forest]]\nnumber = 9\nnorth_m = [0, 5]\n", ":9", "forest.east_m is missing"},
        {"[[forest]]\nnumber = 9\nnorth_m = [0, 5]\neast_m = [0, 5]\nspacing_m = 6\n", ":10",
         "forest.number is 9, but only"},
        {"[[building]]\n" + place + "length_m = 5\nwidth_m = 5\n", ":9", "height_m is missing"},
        {"[[building]]\n" + place + "length_m = 5\nwidth_m = 5\nheight_m = 5\nroof_m = 1\n", ":15",
         "building.roof_m is unknown or does not apply here"},
        {"[[building]]\n" + place + "length_m = 5\nwidth_m = 5\nheight_m = 5\nyaw_deg = 700\n",
         ":15", "building.yaw_deg is 700"},
        {"[[wire]]\nstart_m = [0, 0, 5]\nend_m = [0, 0, 9]\n", ":11", "wire.end_m is above"},
        {"[[wire]]\nstart_m = [0, 0, 5]\nend_m = [9, 0, 5]\nsag_m = 20\n", ":12",
         "wire.sag_m is 20; give a number from 0 to 9"},
        {"[[mast]]\n" + place + "height_m = 9\nmodel = \"tower\"\n", ":13",
         "mast.model is 'tower'; give one of \"pole\", \"lattice\""},
        {"[tunnel]\ndiameter_m = 5\n", ":9", "tunnel.point comes 0 times"},
        {"[tunnel]\n[[tunnel.point]]\n" + place + "height_m = 0\n[[tunnel.point]]\n" + place +
             "height_m = 0\n",
         ":15", "less than 0.1 m from the point before"},
        {"[[aircraft]]\n" + place + "span_m = nan\n", ":12", "aircraft.span_m is no finite"},
        {"[[mesh]]\n" + place, ":9", "mesh.file is missing"},
        {"[[mesh]]\nfile = \"absent.obj\"\n" + place, "absent.obj", "no such file"},
        {"[[mesh]]\nfile = \"bad.toml\"\n" + place, "bad.toml", "the mesh cannot be read"},
        {"[[mesh]]\nfile = \"points.ply\"\n" + place, "points.ply",
         "give a PLY or OBJ with triangles"},
        {"[[vehicle]]\n", ":9", "vehicle.waypoint comes 0 times; give at least two"},
        {"[[vehicle]]\nloop = 1\n" + route, ":10", "vehicle.loop is neither true nor false"},
        {"[[vehicle]]\nhold_s = 1\n" + route, ":10", "vehicle.hold_s is unknown"},
        {"[camera]\nwidth_px = 0\n", ":10", "camera.width_px is 0"},
        {"[camera]\nfx_px = -1\n", ":10", "camera.fx_px is -1"},
        {"[camera]\nposition_m = [1]\n", ":10", "camera.position_m is no point"},
        {"[camera]\nmodel = \"pinhole\"\n", ":10", "camera.model is unknown"},
        // What Embree or memory cannot hold.
        {"[[tree]]\nnorth_m = 1e300\neast_m = 0\n", ":10",
         "tree.north_m is 1e+300; give a number from -100000 to 100000"},
        {"[[row]]\nstart_m = [0, 0]\nend_m = [0, 2e5]\nnumber = 2\n", ":11",
         "row.end_m is too far away"},
        {"[[row]]\nstart_m = [3, 4]\nend_m = [3, 4]\nnumber = 2\n", ":11", "row.end_m is start_m"},
        {"[tunnel]\ndiameter_m = 5\n[[tunnel.point]]\n" + place +
             "height_m = 1e30\n[[tunnel.point]]\n" + place + "height_m = 0\n",
         ":14", "tunnel.point.height_m is 1e+30"},
        {"[terrain]\nheights = \"high.npy\"\nnorth_m = [0, 1]\neast_m = [0, 1]\n", "high.npy",
         "a height is 1e+38 m"},
        {"[[mesh]]\nfile = \"large.obj\"\nscale = 1e6\n" + place, ":11",
         "mesh.scale is 1000000, which puts a vertex too far out"},
        {"[camera]\ncx_px = 1e308\n", ":10", "camera.cx_px is 1e+308"},
        {"[camera]\nposition_m = [0, 0, 1e30]\n", ":10", "camera.position_m is too far away"},
        {"[ground]\nspacing_m = 0.05\n", ":9", "the ground takes 42000000 nodes; give a larger"},
    };
    const TemporaryFolder folder;
    write_npy(folder.path() / "line.npy", {{4}, {1, 2, 3, 4}});
    write_npy(folder.path() / "hole.npy",
              {{2, 2}, {1, 2, 3, std::numeric_limits<float>::infinity()}});
    write_npy(folder.path() / "high.npy", {{2, 2}, {1, 2, 3, 1e38F}});
    std::ofstream(folder.path() / "large.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::ofstream(folder.path() / "points.ply")
        << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
           "property float z\nend_header\n1 2 3\n";
    for (const BadScene& bad : cases) {
        std::ofstream(folder.path() / "bad.toml") << flight << bad.text;
        const std::string message = refusal(folder.path() / "bad.toml");
        EXPECT_THAT(message, ::testing::HasSubstr(bad.place)) << bad.text;
        EXPECT_THAT(message, ::testing::HasSubstr(bad.message)) << bad.text;
    }
}

TEST(SceneErrors, NameWhatIsWrongWithTheFlight) {
    const std::string start = "[[flight.waypoint]]\nnorth_m = 0\neast_m = 0\nheight_m = 5\n";
    const std::vector<BadScene> cases{
        {"[ground]\n", ":1", "flight is missing"},
        {"[flight]\n", ":1", "flight.waypoint comes 0 times"},
        {start, ":1", "flight.waypoint comes 1 times; give at least two, each as [[flight.way"},
        {start + start, ":6", "are those of the one before"},
        {start + "[[flight.waypoint]]\nnorth_m = 0\neast_m = 0\n", ":5", "height_m is missing"},
        {start + "above_ground_m = 3\n", ":5", "above_ground_m comes beside height_m"},
        {start + "speed_mps = 0\n", ":5", "flight.waypoint.speed_mps is 0; give a number from"},
        {start + "hold_s = -1\n", ":5", "flight.waypoint.hold_s is -1"},
        {start + "wait_s = 1\n", ":5", "flight.waypoint.wait_s is unknown"},
        {"[flight]\nloop = true\n" + flight, ":2", "flight.loop is true, so the route has no end"},
        {"[flight]\nduration_s = 0\n" + flight, ":2", "flight.duration_s is 0"},
        {"[flight]\nspeed_mps = 5\n" + flight, ":2", "flight.speed_mps is unknown"},
        {"[flight.limits]\nclimb_mps = 0\n" + flight, ":2", "flight.limits.climb_mps is 0"},
        {"[flight.limits]\nyaw_rate_radps = 1\n" + flight, ":2", "yaw_rate_radps is unknown"},
    };
    const TemporaryFolder folder;
    for (const BadScene& bad : cases) {
        std::ofstream(folder.path() / "bad.toml") << bad.text;
        const std::string message = refusal(folder.path() / "bad.toml");
        EXPECT_THAT(message, ::testing::HasSubstr("bad.toml" + bad.place)) << bad.text;
        EXPECT_THAT(message, ::testing::HasSubstr(bad.message)) << bad.text;
    }
    EXPECT_THAT(refusal(folder.path() / "absent.toml"), ::testing::HasSubstr("no such file"));
}

TEST(SceneNames, AreOneLineOfUtf8) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "caf\xe9.toml";
    const std::string bush = "[[bush]]\n" + place + "name = \"a\\tb\"\n";
    std::ofstream(file) << flight << bush;
    const Scene scene = read_scene(file, 1);
    EXPECT_EQ(scene.name, "caf?");
    EXPECT_EQ(scene.surfaces.obstacles[0].name, "a b");
    std::ofstream(file) << "name = \"two\\nlines\"\n" << flight << bush;
    EXPECT_EQ(read_scene(file, 1).name, "two lines");
}

} // namespace
} // namespace zonegrid::testing
