#include "cli/command_fixture.h"
#include "device/device.h"
#include "io/generated_case.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class CheckTest : public CommandTest {};

TEST_F(CheckTest, FindsTheReferencesMapOnEveryUsableDevice) {
    write_recording(SmallRecording{});
    const CommandResult result = run("zonegrid check recording --cell 0.2 --model span");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    for (const auto& info : device::list_devices().devices) {
        if (info.refusal.empty()) {
            EXPECT_THAT(result.output, HasSubstr(info.id() + ": the reference's map, 8 images"));
        }
    }
}

TEST_F(CheckTest, ComparesAsOftenAsItIsTold) {
    write_recording(SmallRecording{});
    const CommandResult result = run("zonegrid check recording --cell 0.2 --every 1");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr(": the reference's map, 8 images"));
}

TEST_F(CheckTest, FliesGeneratedFlightsOnEveryUsableDevice) {
    const CommandResult result = run("zonegrid check --generated 7 --cases 10");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    for (const auto& info : device::list_devices().devices) {
        if (info.refusal.empty()) {
            EXPECT_THAT(result.output,
                        HasSubstr(info.id() + ": the reference's map, 10 flights, "));
        }
    }
    EXPECT_TRUE(names().empty()); // nothing is saved where nothing differs
}

TEST_F(CheckTest, FliesOnOneDeviceAgainstAnother) {
    for (const auto& info : device::list_devices().devices) {
        if (info.refusal.empty()) {
            const CommandResult result = run("zonegrid check --generated 7 --cases 3 --device " +
                                             info.id() + " --against " + info.id());
            EXPECT_EQ(result.exit_code, 0) << result.errors;
            EXPECT_THAT(result.output, StartsWith(info.id() + ": the map of " + info.id() + ", 3"));
        }
    }
}

TEST_F(CheckTest, ReplaysASavedCaseWithItsOptions) {
    for (const std::uint64_t number : {0U, 1U, 4U}) {
        const GeneratedFlight flight(7, number);
        const MapperOptions& options = flight.options();
        save_case(path("a case"), flight, "");
        const std::string command = replay_command("a case", options, "auto", "reference");
        const CommandResult checked = run(command);
        EXPECT_EQ(checked.exit_code, 0) << command << "\n" << checked.errors;
        EXPECT_THAT(checked.output, HasSubstr("the "));
        const CommandResult mapped =
            run("zonegrid map 'a case' -o map --overwrite " + mapping_arguments(options));
        ASSERT_EQ(mapped.exit_code, 0) << mapped.errors;
        const auto parameters = read_json("map/report.json")["parameters"];
        EXPECT_EQ(parameters["cell_m"], options.cell_m);
        EXPECT_EQ(parameters["range_m"], options.range_m);
        EXPECT_EQ(parameters["zone_cells"], options.zone);
        EXPECT_EQ(parameters["model"], options.model == SensorModel::span ? "span" : "line");
        EXPECT_EQ(parameters["span_sigmas"], options.span_sigmas);
        EXPECT_EQ(parameters["hit"], options.hit);
        EXPECT_EQ(parameters["miss"], options.miss);
        EXPECT_EQ(parameters["limit"], options.limit);
        EXPECT_EQ(parameters["threshold"], options.threshold);
        EXPECT_EQ(parameters["max_gap_s"], options.max_gap_s);
    }
}

TEST_F(CheckTest, NamesADeviceThatIsMissing) {
    write_recording(SmallRecording{});
    const CommandResult result = run("zonegrid check recording --backend opencl:77");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, HasSubstr("opencl:77"));
}

TEST_F(CheckTest, SaysSoWhereThereIsNoDevice) {
    write_recording(SmallRecording{});
    const CommandResult result =
        run("ZONEGRID_OPENCL_LIBRARY=libnone.so ZONEGRID_VULKAN_LIBRARY=libnone.so "
            "zonegrid check recording");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, HasSubstr("zonegrid doctor"));
}

} // namespace
} // namespace zonegrid::testing
