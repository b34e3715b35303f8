#include "cli/command_fixture.h"

#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using AtomicOutputTest = CommandTest;

constexpr const char* map_command_line = "zonegrid map recording -o map --cell 0.1 --range 8 ";

TEST_F(AtomicOutputTest, KeepsAnExistingMapUnlessTold) {
    write_recording();
    ASSERT_EQ(run(map_command_line).exit_code, 0);
    const std::string cells = read_file("map/cells.zgrid");
    const CommandResult refused = run(std::string(map_command_line) + "--frames 0:2");
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.errors, one_line_with("map: the folder exists", "--overwrite"));
    EXPECT_TRUE(read_file("map/cells.zgrid") == cells);
    EXPECT_EQ(run(std::string(map_command_line) + "--frames 0:2 --overwrite").exit_code, 0);
    EXPECT_FALSE(read_file("map/cells.zgrid") == cells);
    EXPECT_THAT(names(), ElementsAre("map", "recording"));
}

TEST_F(AtomicOutputTest, DoesNotDeleteWhatItDidNotWrite) {
    write_recording();
    ASSERT_EQ(run(map_command_line).exit_code, 0);
    write_file("map/notes.txt", "mine");
    const CommandResult result = run(std::string(map_command_line) + "--overwrite");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, one_line_with("notes.txt", "move that away"));
    EXPECT_EQ(read_file("map/notes.txt"), "mine");
}

TEST_F(AtomicOutputTest, ReplacesThroughALinkAndATrailingSlash) {
    write_recording();
    ASSERT_EQ(run(map_command_line).exit_code, 0);
    ASSERT_EQ(
        run("ln -s map link; zonegrid map recording -o link/ --range 8 --overwrite").exit_code, 0);
    EXPECT_THAT(names(), ElementsAre("link", "map", "recording"));
    EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
}

TEST_F(AtomicOutputTest, LeavesNothingWhenTheDiskIsFull) {
    write_recording();
    ASSERT_EQ(run(map_command_line).exit_code, 0);
    const std::string report = read_file("map/report.json");
    // The limit, in kibibytes, stops the files one after another.
    for (const char* const limit_kib : {"0", "1", "3", "20"}) {
        const CommandResult result =
            run("(ulimit -f " + std::string(limit_kib) + "; " + map_command_line +
                "--overwrite) 2>&1 | cat >&2; exit ${PIPESTATUS[0]}");
        EXPECT_EQ(result.exit_code, 1) << limit_kib;
        EXPECT_THAT(result.errors, one_line_with("written")) << limit_kib;
        EXPECT_TRUE(read_file("map/report.json") == report) << limit_kib;
        EXPECT_THAT(names(), ElementsAre("map", "recording")) << limit_kib;
    }
}

TEST_F(AtomicOutputTest, SaysThatTheSummaryCannotBePrinted) {
    write_recording();
    const CommandResult result = run(std::string(map_command_line) + "> /dev/full");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, one_line_with("standard output"));
    EXPECT_TRUE(exists("map/report.json"));
}

TEST_F(AtomicOutputTest, CleansUpWhenInterrupted) {
    SmallRecording recording;
    recording.images = 1500;
    write_recording(recording);
    for (const char* const signal : {"INT", "TERM"}) {
        // Started by a shell of job control, which leaves SIGINT to the command.
        const CommandResult result =
            run("set -m; '" ZONEGRID_COMMAND
                "' map recording -o map --cell 0.02 --range 8 & "
                "while ! ls -d map.partial-* 2>/dev/null >/dev/null; do sleep 0.01; done; "
                "sleep 0.1; kill -" +
                std::string(signal) + " $!; wait $!");
        EXPECT_THAT(result.exit_code, AnyOf(130, 143)) << signal << result.errors;
        EXPECT_THAT(result.errors, HasSubstr("zonegrid: interrupted; nothing was written"));
        EXPECT_THAT(result.output, IsEmpty());
        EXPECT_THAT(names(), ElementsAre("recording")) << signal;
    }
}

} // namespace
} // namespace zonegrid::testing
