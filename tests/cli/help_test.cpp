#include "cli/command_fixture.h"

#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

using HelpTest = CommandTest;

TEST_F(HelpTest, IsWhatTheBareCommandPrints) {
    const CommandResult bare = run("zonegrid");
    EXPECT_EQ(bare.exit_code, 0);
    EXPECT_THAT(bare.errors, IsEmpty());
    for (const char* const part : {"map", "dump", "inspect", "Exit codes", "--version"}) {
        EXPECT_THAT(bare.output, HasSubstr(part));
    }
    EXPECT_EQ(run("zonegrid --help").output, bare.output);
}

TEST_F(HelpTest, TeachesEachCommand) {
    for (const char* const command : {"map", "dump", "inspect", "devices", "check", "doctor"}) {
        const CommandResult result = run("zonegrid " + std::string(command) + " --help");
        EXPECT_EQ(result.exit_code, 0) << command;
        EXPECT_THAT(result.output, HasSubstr("Examples:")) << command;
        EXPECT_THAT(result.output, HasSubstr("Exit codes:")) << command;
    }
}

TEST_F(HelpTest, GivesUnitsAndDefaultsOfMap) {
    const std::string help = run("zonegrid map --help").output;
    for (const char* const part : {"edge of a cell, metres (default 0.1)",
                                   "metres (default 40.0)",
                                   "seconds (default 0.05)",
                                   "--zone",
                                   "--model",
                                   "--backend",
                                   "--device",
                                   "--hit",
                                   "--miss",
                                   "--limit",
                                   "--threshold",
                                   "--span-sigmas",
                                   "--max-gap",
                                   "--layout",
                                   "--world-axes",
                                   "--intrinsics",
                                   "--depth-scale",
                                   "--baseline",
                                   "--disparity-sigma",
                                   "--frames",
                                   "--cut-height",
                                   "--overwrite",
                                   "--json",
                                   "--quiet",
                                   "--config",
                                   "--dump-config"}) {
        EXPECT_THAT(help, HasSubstr(part));
    }
}

TEST_F(HelpTest, PrintsTheVersion) {
    const CommandResult result = run("zonegrid --version");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.output, MatchesRegex("zonegrid [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(HelpTest, NoticesThatItCannotBePrinted) {
    const CommandResult result = run("zonegrid --help > /dev/full");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, one_line_with("standard output", "No space left"));
}

} // namespace
} // namespace zonegrid::testing
