#include "cli/command_fixture.h"
#include "device/device.h"

#include <gmock/gmock.h>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;

class DevicesTest : public CommandTest {};

TEST_F(DevicesTest, ListsEveryDeviceWithItsName) {
    const CommandResult result = run("zonegrid devices");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    for (const auto& info : device::list_devices().devices) {
        EXPECT_THAT(result.output, HasSubstr(info.id() + "  " + info.name));
    }
}

TEST_F(DevicesTest, SaysTheSameAsJson) {
    const CommandResult result = run("zonegrid devices --json");
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const auto json = nlohmann::json::parse(result.output);
    const auto devices = device::list_devices().devices;
    ASSERT_EQ(json.at("devices").size(), devices.size());
    for (std::size_t i = 0; i < devices.size(); ++i) {
        EXPECT_EQ(json["devices"][i].at("id"), devices[i].id());
        EXPECT_EQ(json["devices"][i].at("usable"), devices[i].refusal.empty());
        EXPECT_EQ(json["devices"][i].at("buffer_bytes"), devices[i].limits.buffer_bytes);
    }
}

TEST_F(DevicesTest, NamesALoaderThatIsMissing) {
    const CommandResult result =
        run("ZONEGRID_OPENCL_LIBRARY=libnone.so "
            "ZONEGRID_VULKAN_LIBRARY=libnone.so zonegrid devices");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("missing: "));
    EXPECT_THAT(result.output, HasSubstr("libnone.so"));
}

TEST_F(DevicesTest, AMissingDeviceIsAFailureThatNamesIt) {
    write_recording(SmallRecording{});
    const CommandResult result = run("zonegrid map recording -o map --backend vulkan:99");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, HasSubstr("vulkan:99"));
    EXPECT_FALSE(exists("map"));
}

} // namespace
} // namespace zonegrid::testing
