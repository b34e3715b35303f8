#include "cli/command_fixture.h"
#include "device/device_choice.h"

#include <gmock/gmock.h>

#include <string>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class BackendChoiceTest : public CommandTest {
protected:
    /// Maps the small recording and gives what the report says of the backend.
    nlohmann::json backend_after(const std::string& options) {
        const CommandResult result =
            run("zonegrid map recording -o map --overwrite --cell 0.2 " + options);
        EXPECT_EQ(result.exit_code, 0) << result.errors;
        errors_ = result.errors;
        const auto report = read_json("map/report.json");
        EXPECT_EQ(report["parameters"]["backend"], report["backend"]["used"]);
        return report["backend"];
    }

    std::string errors_;
};

TEST_F(BackendChoiceTest, ReportsTheReference) {
    write_recording();
    const auto backend = backend_after("");
    EXPECT_EQ(backend["used"], "reference");
    EXPECT_TRUE(backend["device"].is_null());
    EXPECT_THAT(errors_, IsEmpty());
}

TEST_F(BackendChoiceTest, ReportsTheDeviceThatABackendStandsFor) {
    write_recording();
    for (const char* const name : {"opencl", "vulkan"}) {
        const auto list = device::list_devices(name);
        const auto usable = device::usable_devices(list);
        if (usable.empty()) {
            continue;
        }
        const auto backend = backend_after(std::string("--backend ") + name);
        EXPECT_EQ(backend["asked"], name);
        EXPECT_EQ(backend["used"], device::find_device(name).id());
        EXPECT_EQ(backend["device"]["name"], device::find_device(name).name);
        EXPECT_EQ(backend["device"]["driver"], device::find_device(name).driver);
    }
}

TEST_F(BackendChoiceTest, FindsADeviceByNumberIdAndName) {
    write_recording();
    for (const auto& info : device::usable_devices(device::list_devices())) {
        const std::string number = std::to_string(info.index);
        EXPECT_EQ(backend_after("--backend " + info.backend + " --device " + number)["used"],
                  info.id());
        EXPECT_EQ(backend_after("--device " + info.id())["used"], info.id());
        EXPECT_EQ(
            backend_after("--backend " + info.backend + " --device '" + info.name + "'")["used"],
            info.id());
    }
}

TEST_F(BackendChoiceTest, AutoTakesTheFirstDeviceThatPassesAndSaysWhy) {
    write_recording();
    const auto usable = device::usable_devices(device::list_devices());
    const auto backend = backend_after("--backend auto");
    EXPECT_EQ(backend["asked"], "auto");
    EXPECT_EQ(backend["used"], usable.empty() ? "reference" : usable.front().id());
    EXPECT_THAT(errors_, one_line_with("auto: ", backend["used"].get<std::string>()));
    EXPECT_THAT(errors_, HasSubstr(backend["reason"].get<std::string>()));
    static_cast<void>(backend_after("--backend auto --quiet"));
    EXPECT_THAT(errors_, IsEmpty());
}

TEST_F(BackendChoiceTest, AutoTakesTheReferenceWhereThereIsNoDevice) {
    write_recording();
    const CommandResult result =
        run("export ZONEGRID_OPENCL_LIBRARY=libnone.so ZONEGRID_VULKAN_LIBRARY=libnone.so\n"
            "zonegrid map recording -o map --cell 0.2 --backend auto");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, one_line_with("auto: no device passes", "reference", "libnone.so"));
    const auto backend = read_json("map/report.json")["backend"];
    EXPECT_EQ(backend["used"], "reference");
    EXPECT_THAT(backend["reason"], HasSubstr("libnone.so"));
}

TEST_F(BackendChoiceTest, LimitsADevicesMemoryAndCopiesWhereAsked) {
    write_recording();
    const auto usable = device::usable_devices(device::list_devices());
    if (usable.empty()) {
        GTEST_SKIP() << "no device here";
    }
    const std::string on = "--backend " + usable.front().id();
    static_cast<void>(backend_after(on));
    const auto digest = read_json("map/report.json")["digest"];
    static_cast<void>(backend_after(on + " --copy-memory --device-memory 4000"));
    EXPECT_EQ(read_json("map/report.json")["digest"], digest);
    const auto result =
        run("zonegrid map recording -o small --cell 0.2 --device-memory 0.01 " + on);
    EXPECT_NE(result.exit_code, 0);
    EXPECT_THAT(result.errors, one_line_with("of its limit of 0.0 MB", "choose a shorter range"));
    EXPECT_FALSE(exists("small"));
}

TEST_F(BackendChoiceTest, GivesTheSameMapWhateverComputes) {
    write_recording();
    static_cast<void>(backend_after(""));
    const auto digest = read_json("map/report.json")["digest"];
    static_cast<void>(backend_after("--backend auto"));
    EXPECT_EQ(read_json("map/report.json")["digest"], digest);
}

} // namespace
} // namespace zonegrid::testing
