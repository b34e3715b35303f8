#include "cli/command_fixture.h"

#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* scene = R"([ground]
texture = 0.8

[[building]]
north_m = 25.0
east_m = 0.0
length_m = 4.0
width_m = 20.0
height_m = 9.0

[camera]
width_px = 64
height_px = 48
disparity_sigma_px = 0.4

[flight]
duration_s = 0.17

[[flight.waypoint]]
north_m = 0.0
east_m = 0.0
height_m = 4.0

[[flight.waypoint]]
north_m = 10.0
east_m = 0.0
height_m = 4.0
)";

class SimulateTest : public CommandTest {
protected:
    void SetUp() override { write_file("wall.toml", scene); }
};

TEST_F(SimulateTest, MakesARecordingThatCanBeMapped) {
    const CommandResult result = run("zonegrid simulate wall.toml -o flight");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, IsEmpty());
    EXPECT_THAT(result.output, HasSubstr("none: depth is exact and navigation true"));
    EXPECT_THAT(result.output, HasSubstr("5 of 64 x 48 pixels, 30 Hz"));
    EXPECT_THAT(names(), ElementsAre("flight", "wall.toml"));
    EXPECT_TRUE(exists("flight/truth/truth.json"));
    EXPECT_TRUE(exists("flight/depth/000005.png"));
    EXPECT_FALSE(exists("flight/depth/000006.png"));
    EXPECT_EQ(run("zonegrid map flight -o map --cell 1").exit_code, 0);
    EXPECT_EQ(read_json("map/report.json")["images"]["integrated"], 5);
    EXPECT_GT(read_json("map/report.json")["map"]["cells_occupied"], 20);
    const CommandResult inspected = run("zonegrid inspect flight");
    EXPECT_EQ(inspected.exit_code, 0) << inspected.output << inspected.errors;
}

TEST_F(SimulateTest, MakesTheSameBytesOnAnyNumberOfCores) {
    ASSERT_EQ(run("zonegrid simulate wall.toml -o a --all-faults --screen 1").exit_code, 0);
    ASSERT_EQ(
        run("taskset -c 0 '" ZONEGRID_COMMAND "' simulate wall.toml -o b --all-faults --screen 1")
            .exit_code,
        0);
    EXPECT_EQ(run("diff -r a b").exit_code, 0);
    ASSERT_EQ(run("zonegrid simulate wall.toml -o c --all-faults --screen 1 --seed 2").exit_code,
              0);
    EXPECT_EQ(run("cmp -s a/depth/000003.png c/depth/000003.png").exit_code, 1);
    EXPECT_EQ(run("cmp -s a/navigation.csv c/navigation.csv").exit_code, 1);
}

TEST_F(SimulateTest, TakesOptionsOfFlightAndCamera) {
    const CommandResult result = run(
        "zonegrid simulate wall.toml -o flight --seconds 1 --rate 10 --size 32x12 --stereo-noise "
        "0.3");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("10 of 32 x 12 pixels, 10 Hz"));
    EXPECT_THAT(result.output, HasSubstr("--stereo-noise 0.3\n"));
    const std::string description = read_file("flight/description.toml");
    EXPECT_THAT(description, HasSubstr("disparity_sigma_px = 0.3"));
    EXPECT_THAT(description, HasSubstr("cx_px = 15.5\n")); // still the middle
    EXPECT_THAT(description, HasSubstr("cy_px = 5.5\n"));
}

TEST_F(SimulateTest, TakesAllFaultsButForThoseGiven) {
    const CommandResult result =
        run("zonegrid simulate wall.toml -o flight --all-faults --outliers 0 --quantise 0.125");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output,
                HasSubstr("--stereo-noise 0.4 --quantise 0.125 --missing 1 --bleeding 2 "
                          "--vibration 0.1 --navigation-errors 1 --navigation-constant 60\n"));
}

TEST_F(SimulateTest, FindsScenesByTheirName) {
    ASSERT_EQ(run("mkdir scenes && mv wall.toml scenes/").exit_code, 0);
    EXPECT_EQ(run("zonegrid simulate wall -o flight").exit_code, 0);
    const CommandResult result = run("zonegrid simulate slalom -o other");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, one_line_with("SCENE is slalom", "scenes/slalom.toml"));
}

TEST_F(SimulateTest, NamesWhatIsWrong) {
    EXPECT_EQ(run("zonegrid simulate -o flight").exit_code, 2);
    const CommandResult no_output = run("zonegrid simulate wall.toml");
    EXPECT_EQ(no_output.exit_code, 2);
    EXPECT_THAT(no_output.errors, one_line_with("--output is missing"));
    for (const char* const option :
         {"--seed -1", "--seconds 0", "--size 64", "--size 0x5", "--stereo-noise -1",
          "--missing 1.5", "--bleeding 1.5", "--late-images 2", "--rate nan"}) {
        const CommandResult result =
            run("zonegrid simulate wall.toml -o flight " + std::string(option));
        EXPECT_EQ(result.exit_code, 2) << option;
        EXPECT_THAT(result.errors, one_line_with(std::string(option).substr(0, 6), "give"));
    }
    write_file("bad.toml", std::string(scene) + "\n[sky]\ncolour = 1\n");
    const CommandResult bad = run("zonegrid simulate bad.toml -o flight");
    EXPECT_EQ(bad.exit_code, 1);
    EXPECT_THAT(bad.errors, one_line_with("bad.toml", "sky"));
    const CommandResult short_flight = run("zonegrid simulate wall.toml -o flight --lost-images 1");
    EXPECT_EQ(short_flight.exit_code, 2);
    EXPECT_THAT(short_flight.errors, one_line_with("no image is left"));
    EXPECT_FALSE(exists("flight"));
}

TEST_F(SimulateTest, ReplacesOnlyWhatWasSimulated) {
    ASSERT_EQ(run("zonegrid simulate wall.toml -o flight").exit_code, 0);
    const std::string before = read_file("flight/navigation.csv");
    const CommandResult refused = run("zonegrid simulate wall.toml -o flight --seed 2");
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.errors, one_line_with("flight", "exists", "--overwrite"));
    EXPECT_EQ(read_file("flight/navigation.csv"), before);
    EXPECT_EQ(run("zonegrid simulate wall.toml -o flight --seed 2 --overwrite").exit_code, 0);
    EXPECT_NE(read_file("flight/navigation.csv"), before);
    ASSERT_EQ(run("rm -r flight/truth").exit_code, 0); // as if it were a real one
    const CommandResult real = run("zonegrid simulate wall.toml -o flight --overwrite");
    EXPECT_EQ(real.exit_code, 1);
    EXPECT_THAT(real.errors, one_line_with("flight", "not simulated"));
    EXPECT_TRUE(exists("flight/depth/000001.png"));
    EXPECT_THAT(names(), ElementsAre("flight", "wall.toml"));
}

TEST_F(SimulateTest, LeavesNothingWhenInterruptedOrOutOfSpace) {
    const CommandResult interrupted =
        run("set -m; '" ZONEGRID_COMMAND
            "' simulate wall.toml -o flight --seconds 600 & "
            "while ! ls flight.partial-*/depth/000100.png 2>/dev/null >/dev/null; do sleep 0.01; "
            "done; kill -TERM $!; wait $!");
    EXPECT_THAT(interrupted.exit_code, AnyOf(130, 143)) << interrupted.errors;
    EXPECT_THAT(interrupted.errors, HasSubstr("interrupted; nothing was written"));
    EXPECT_THAT(names(), ElementsAre("wall.toml"));
    const CommandResult full =
        run("(ulimit -f 1; zonegrid simulate wall.toml -o flight) 2>&1 | cat >&2; exit "
            "${PIPESTATUS[0]}");
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_THAT(full.errors, one_line_with("written"));
    EXPECT_THAT(names(), ElementsAre("wall.toml"));
}

TEST_F(SimulateTest, TakesNamesOfAnyBytes) {
    ASSERT_EQ(run("cp wall.toml $'w\\xe9 \\n.toml'").exit_code, 0);
    EXPECT_EQ(run("zonegrid simulate $'w\\xe9 \\n.toml' -o $'f\\xe9' --quiet").errors, "");
    EXPECT_EQ(run("zonegrid map $'f\\xe9' -o $'m\\xe9' --cell 1 --quiet").errors, "");
    EXPECT_EQ(run("zonegrid evaluate $'m\\xe9' --truth $'f\\xe9/truth' -o judged --quiet").errors,
              "");
    EXPECT_EQ(run("zonegrid inspect $'f\\xe9' --json").exit_code, 0);
}

TEST_F(SimulateTest, IsQuietWhenTold) {
    const CommandResult result = run("zonegrid simulate wall.toml -o flight --quiet");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.output + result.errors, IsEmpty());
}

TEST_F(SimulateTest, ExplainsItself) {
    const std::string help = run("zonegrid simulate --help").output;
    for (const char* const part : {"SCENE",
                                   "--output",
                                   "--seed",
                                   "--seconds",
                                   "--rate",
                                   "--size",
                                   "--stereo-noise",
                                   "--quantise",
                                   "--missing",
                                   "--bleeding",
                                   "--outliers",
                                   "--missing-sky",
                                   "--vibration",
                                   "--screen",
                                   "--navigation-errors",
                                   "--navigation-constant",
                                   "--late-images",
                                   "--late-by",
                                   "--lost-images",
                                   "--lost-navigation",
                                   "--all-faults",
                                   "--overwrite",
                                   "--quiet",
                                   "Examples:",
                                   "Exit codes:"}) {
        EXPECT_THAT(help, HasSubstr(part));
    }
    EXPECT_THAT(help, Not(HasSubstr("default )")));
}

} // namespace
} // namespace zonegrid::testing
