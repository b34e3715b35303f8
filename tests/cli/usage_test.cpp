#include "cli/command_fixture.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace zonegrid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Arguments that cannot work, and what the one line must name.
struct WrongUsage {
    std::string arguments;
    std::vector<std::string> parts;
};

class UsageTest : public CommandTest, public ::testing::WithParamInterface<WrongUsage> {};

TEST_P(UsageTest, EndsWithTwoAndOneLineAndLeavesNothing) {
    write_recording();
    const CommandResult result = run("zonegrid " + GetParam().arguments);
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_THAT(result.errors, one_line_with("zonegrid"));
    for (const std::string& part : GetParam().parts) {
        EXPECT_THAT(result.errors, HasSubstr(part));
    }
    EXPECT_THAT(names(), ElementsAre("recording"));
}

WrongUsage map_option(const std::string& option, const std::vector<std::string>& parts) {
    return {"map recording -o map " + option, parts};
}

INSTANTIATE_TEST_SUITE_P(
    All, UsageTest,
    ::testing::Values(map_option("--cell 0", {"--cell is 0", "above 0 in metres"}),
                      map_option("--cell nan", {"--cell is nan", "above 0"}),
                      map_option("--cell inf", {"--cell is inf", "above 0"}),
                      map_option("--cell ten", {"--cell is ten", "metres"}),
                      map_option("--cell ''", {"--cell", "metres"}),
                      map_option("--range -1", {"--range is -1", "above 0"}),
                      map_option("--zone 7", {"--zone is 7", "8, 16 or 32"}),
                      map_option("--zone 8.0", {"--zone is 8.0", "8, 16 or 32"}),
                      map_option("--model lines", {"--model is lines", "line or span"}),
                      map_option("--backend cuda", {"--backend is cuda", "opencl:0"}),
                      map_option("--backend opencl:", {"--backend is opencl:", "opencl:0"}),
                      map_option("--backend opencl:0 --device 1", {"opencl:0", "--device"}),
                      map_option("--backend auto --device 1", {"auto", "--device"}),
                      map_option("--device 1", {"device 1", "backend"}),
                      map_option("--device-memory 0", {"--device-memory", "above 0"}),
                      map_option("--device ''", {"--device", "part of its name"}),
                      WrongUsage{"check", {"RECORDING", "--generated"}},
                      WrongUsage{"check recording --generated 1", {"RECORDING", "--generated"}},
                      WrongUsage{"check --generated 1 --cell 0.5", {"--cell", "--generated"}},
                      WrongUsage{"check --generated -1", {"--generated is -1", "whole number"}},
                      WrongUsage{"check --generated 1 --cases 0", {"--cases is 0", "1 or more"}},
                      WrongUsage{"check recording --cases 9", {"--cases", "--generated"}},
                      WrongUsage{"check recording -o case", {"--output", "--generated"}},
                      WrongUsage{"check recording --every 0", {"--every is 0", "1 or more"}},
                      WrongUsage{"check recording --against cuda", {"--against is cuda"}},
                      map_option("--hit 0", {"--hit is 0", "from 1"}),
                      map_option("--limit 128", {"--limit is 128", "127"}),
                      map_option("--hit 9", {"hit is 9", "limit (4)"}),
                      map_option("--threshold 9", {"threshold is 9", "limit (4)"}),
                      map_option("--span-sigmas -1", {"--span-sigmas is -1", "0 or more"}),
                      map_option("--max-gap 6", {"--max-gap is 6", "5 seconds"}),
                      map_option("--cell 0.01 --range 40", {"window", "2048", "cell"}),
                      map_option("--frames 9:3", {"--frames is 9:3", "A below B"}),
                      map_option("--frames 3", {"--frames is 3", "A:B"}),
                      map_option("--frames 0:9", {"--frames is 0:9", "0:8"}),
                      map_option("--frames 8:", {"--frames is 8:", "0:8"}),
                      map_option("--layout kinect", {"--layout is kinect", "auto"}),
                      map_option("--world-axes up", {"--world-axes is up", "z_up"}),
                      map_option("--intrinsics 1 2 3 x",
                                 {"--intrinsics is 1 2 3 x", "fx fy cx cy"}),
                      map_option("--intrinsics 0 2 3 4", {"ntrinsics", "above 0"}),
                      map_option("--depth-scale 0", {"--depth-scale is 0", "units a metre"}),
                      map_option("--baseline 0.1", {"--baseline", "--disparity-sigma"}),
                      map_option("--cut-height low", {"--cut-height is low", "metres"}),
                      map_option("--colour", {"--colour", "--help"}),
                      map_option("another", {"another", "--help"}),
                      WrongUsage{"map recording", {"--output", "-o DIR"}},
                      WrongUsage{"map -o map", {"RECORDING", "folder"}},
                      WrongUsage{"map recording -o", {"--output", "--help"}},
                      WrongUsage{"draw", {"draw", "--help"}},
                      WrongUsage{"dump", {"DIR", "dump --help"}},
                      WrongUsage{"inspect", {"RECORDING"}},
                      WrongUsage{"inspect recording --max-gap -1", {"--max-gap is -1"}}),
    [](const auto& instance) { return fmt::format("Case{:02}", instance.index); });

/// Arguments that are in order, but name what is not there.
class FailureTest : public CommandTest, public ::testing::WithParamInterface<WrongUsage> {};

TEST_P(FailureTest, EndsWithOneAndOneLineAndLeavesNothing) {
    write_recording();
    write_file("file", "no folder");
    const CommandResult result = run("zonegrid " + GetParam().arguments);
    EXPECT_EQ(result.exit_code, 1) << result.errors;
    EXPECT_THAT(result.errors, one_line_with("zonegrid"));
    for (const std::string& part : GetParam().parts) {
        EXPECT_THAT(result.errors, HasSubstr(part));
    }
    EXPECT_THAT(names(), ElementsAre("file", "recording"));
}

INSTANTIATE_TEST_SUITE_P(
    All, FailureTest,
    ::testing::Values(
        WrongUsage{"map nowhere -o map", {"nowhere", "no such folder"}},
        WrongUsage{"map file -o map", {"file", "no such folder"}},
        WrongUsage{"inspect nowhere", {"nowhere", "no such folder"}},
        WrongUsage{"map recording -o nowhere/map", {"nowhere", "no folder"}},
        WrongUsage{"map recording -o file", {"file", "folder"}},
        WrongUsage{"map recording -o file --overwrite", {"file", "folder"}},
        WrongUsage{"map recording -o file/map", {"file", "folder"}},
        WrongUsage{"map recording -o /proc/map", {"/proc", "cannot be made"}},
        WrongUsage{"map recording -o recording --overwrite", {"it holds", "did not write"}},
        WrongUsage{"map recording -o map --device 'no such chip'", {"no such chip", "found: "}},
        WrongUsage{"map recording -o map --backend vulkan --device 99", {"vulkan:99", "found: "}},
        WrongUsage{"check --generated 1 --device opencl:99", {"opencl:99", "found: "}},
        WrongUsage{"check --generated 1 --against opencl:99", {"opencl:99", "found: "}},
        WrongUsage{"dump nowhere", {"nowhere", "no such folder"}},
        WrongUsage{"dump recording", {"recording", "report.json"}}),
    [](const auto& instance) { return fmt::format("Case{:02}", instance.index); });

} // namespace
} // namespace zonegrid::testing
