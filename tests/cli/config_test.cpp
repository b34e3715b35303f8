#include "cli/command_fixture.h"

#include <fmt/format.h>

#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using ConfigTest = CommandTest;

TEST_F(ConfigTest, ComesBackTheSame) {
    const std::string options =
        "recording -o 'my \"map\"' --cell 0.25 --range 1e1 --model span --zone 8 --limit 100 "
        "--hit 3 --miss 2 --threshold 4 --span-sigmas 2.5 --max-gap 0.1 --layout poses "
        "--world-axes z_up --intrinsics 525 525.5 319.5 -2 --depth-scale 5000 --baseline 0.1 "
        "--disparity-sigma 0.5 --backend auto --device 'a chip' --device-memory 100 --copy-memory "
        "--frames :5 --cut-height -2 --history --overwrite --json --quiet";
    const CommandResult first = run("zonegrid map " + options + " --dump-config");
    ASSERT_EQ(first.exit_code, 0) << first.errors;
    EXPECT_THAT(first.output, Not(HasSubstr("not set")));
    for (const char* const line :
         {"cell = 0.25\n", "range = 10.0\n", "intrinsics = [525.0, 525.5, 319.5, -2.0]\n",
          "frames = ':5'\n", "overwrite = true\n", "zone = 8\n"}) {
        EXPECT_THAT(first.output, HasSubstr(line));
    }
    write_file("all.toml", first.output);
    const CommandResult second = run("zonegrid map --config all.toml --dump-config");
    EXPECT_EQ(second.output, first.output) << second.errors;
}

TEST_F(ConfigTest, DumpsDefaultsThatCanBeReadBack) {
    const CommandResult first = run("zonegrid map --dump-config");
    ASSERT_EQ(first.exit_code, 0) << first.errors;
    EXPECT_THAT(first.output, HasSubstr("# cut-height is not set\n"));
    write_file("all.toml", first.output);
    EXPECT_EQ(run("zonegrid map --config all.toml --dump-config").output, first.output);
}

TEST_F(ConfigTest, IsBeatenByTheCommandLine) {
    write_recording();
    write_file("flight.toml",
               "recording = 'recording'\noutput = 'map'\nrange = 8\ncell = 0.5\nquiet = true\n");
    const CommandResult result = run("zonegrid map --config flight.toml --cell 0.2");
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, IsEmpty());
    const nlohmann::json parameters = read_json("map/report.json")["parameters"];
    EXPECT_EQ(parameters["cell_m"], 0.2);
    EXPECT_EQ(parameters["range_m"], 8.0);
}

TEST_F(ConfigTest, GivesTheMapOfTheSameOptions) {
    write_recording();
    const std::string options = "--cell 0.2 --range 6 --zone 16 --limit 20 --hit 5 --frames 1:6";
    ASSERT_EQ(run("zonegrid map recording -o map " + options).exit_code, 0);
    ASSERT_EQ(run("zonegrid map " + options +
                  " --dump-config > flight.toml; "
                  "zonegrid map recording -o again --config flight.toml")
                  .exit_code,
              0);
    EXPECT_EQ(read_json("map/report.json")["digest"], read_json("again/report.json")["digest"]);
    EXPECT_EQ(read_json("map/report.json")["parameters"],
              read_json("again/report.json")["parameters"]);
}

struct WrongConfig {
    std::string text;
    std::string line;
    std::string problem;
};

class WrongConfigTest : public CommandTest, public ::testing::WithParamInterface<WrongConfig> {};

TEST_P(WrongConfigTest, IsRefusedWithFileAndLine) {
    write_recording();
    write_file("flight.toml", GetParam().text);
    const CommandResult result = run("zonegrid map recording -o map --config flight.toml");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors,
                one_line_with("flight.toml:" + GetParam().line + ": ", GetParam().problem));
    EXPECT_THAT(names(), ElementsAre("flight.toml", "recording"));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongConfigTest,
    ::testing::Values(
        WrongConfig{"# mine\nrange = 8\nsell = 0.1\n", "3",
                    "'sell' is no setting; did you mean "
                    "'cell'?"},
        WrongConfig{"nonsense = 1\n", "1", "--dump-config"},
        WrongConfig{"\ncell = 'small'\n", "2", "cell is 'small': it must be a number"},
        WrongConfig{"cell = 0\n", "1", "cell is 0: give a length above 0 in metres"},
        WrongConfig{"cell = nan\n", "1", "cell is nan: give a length above 0 in metres"},
        WrongConfig{"zone = 32.0\n", "1", "zone is 32.0: it must be a whole number"},
        WrongConfig{"zone = 7\n", "1", "zone is 7: give 8, 16 or 32"},
        WrongConfig{"limit = 99999999999\n", "1", "limit is 99999999999: it must be a whole"},
        WrongConfig{"quiet = 'yes'\n", "1", "quiet is 'yes': it must be true or false"},
        WrongConfig{"model = 3\n", "1", "model is 3: it must be text"},
        WrongConfig{"intrinsics = [1, 2, 3]\n", "1", "intrinsics is [ 1, 2, 3 ]: it must be four"},
        WrongConfig{"frames = '9:3'\n", "1", "frames is '9:3': give A:B"},
        WrongConfig{"[cell]\nm = 1\n", "1", "cell is a table: it must be a number"},
        WrongConfig{"cell = 1\ncell = 2\n", "2", "correct the TOML"},
        WrongConfig{"range = 8\ncell = = 2\n", "2", "correct the TOML"}),
    [](const auto& instance) { return fmt::format("Case{:02}", instance.index); });

TEST_F(ConfigTest, MustExist) {
    const CommandResult result = run("zonegrid map --config nowhere.toml --dump-config");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, one_line_with("--config nowhere.toml", "no such file"));
}

} // namespace
} // namespace zonegrid::testing
