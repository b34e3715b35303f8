#include "cli/command_fixture.h"
#include "device/device.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;

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
    EXPECT_THAT(result.errors, HasSubstr("zonegrid devices"));
}

} // namespace
} // namespace zonegrid::testing
