#include "cli/command_fixture.h"
#include "device/device.h"

#include <gmock/gmock.h>

namespace zonegrid::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class DoctorTest : public CommandTest {};

TEST_F(DoctorTest, TestsEveryUsableDevice) {
    const CommandResult result = run("zonegrid doctor");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    for (const char* const part : {"zonegrid      0.", "system  ", "processor  ", "\nopencl\n",
                                   "\nvulkan\n", "\ndevice files\n", "\nproblems\n"}) {
        EXPECT_THAT(result.output, HasSubstr(part));
    }
    for (const auto& info : device::list_devices().devices) {
        EXPECT_THAT(result.output, HasSubstr(info.id() + "  " + info.name));
        if (info.refusal.empty()) {
            EXPECT_THAT(result.output, HasSubstr("passes the self-test"));
            EXPECT_THAT(result.output, HasSubstr("the reference's map, bit for bit"));
        }
    }
}

TEST_F(DoctorTest, SaysTheSameAsJson) {
    const CommandResult result = run("zonegrid doctor --json");
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const auto json = nlohmann::json::parse(result.output);
    EXPECT_FALSE(json.at("kernel").get<std::string>().empty());
    EXPECT_FALSE(json.at("processor").get<std::string>().empty());
    ASSERT_EQ(json.at("backends").size(), 2U);
    EXPECT_EQ(json["backends"][0].at("backend"), "opencl");
    const auto devices = device::list_devices().devices;
    ASSERT_EQ(json.at("devices").size(), devices.size());
    for (std::size_t i = 0; i < devices.size(); ++i) {
        EXPECT_EQ(json["devices"][i].at("id"), devices[i].id());
        if (devices[i].refusal.empty()) {
            EXPECT_EQ(json["devices"][i].at("self_test").at("passed"), true);
            EXPECT_GT(json["devices"][i]["self_test"].at("cells_changed"), 1000);
        }
    }
}

TEST_F(DoctorTest, WithoutALoaderNamesTheVariableAndSucceeds) {
    const CommandResult result =
        run("ZONEGRID_OPENCL_LIBRARY=libnone.so ZONEGRID_VULKAN_LIBRARY=libnone.so "
            "zonegrid doctor");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("libnone.so not found: libnone.so: cannot open"));
    EXPECT_THAT(result.output, HasSubstr("unset ZONEGRID_OPENCL_LIBRARY"));
    EXPECT_THAT(result.output, HasSubstr("ZONEGRID_VULKAN_LIBRARY=libnone.so"));
    EXPECT_THAT(result.output, HasSubstr("no device can be used; maps are still made"));
    EXPECT_THAT(result.errors, IsEmpty());
}

TEST_F(DoctorTest, NamesDriverFilesThatDoNotWork) {
    write_file("broken.icd", "libnone-opencl.so\n");
    write_file("broken.json", R"({"ICD": {"library_path": "./libnone-vulkan.so"}})");
    write_file("malformed.json", "{");
    const CommandResult result =
        run("OCL_ICD_VENDORS=$PWD/broken.icd "
            "VK_DRIVER_FILES=$PWD/broken.json:$PWD/malformed.json:$PWD/absent.json "
            "VK_ICD_FILENAMES=$VK_DRIVER_FILES zonegrid doctor --json");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const auto json = nlohmann::json::parse(result.output);
    const auto& opencl = json["backends"][0]["driver_files"];
    ASSERT_EQ(opencl.size(), 1U);
    EXPECT_EQ(opencl[0]["library"], "libnone-opencl.so");
    EXPECT_EQ(opencl[0]["found"], false);
    const auto& vulkan = json["backends"][1]["driver_files"];
    ASSERT_EQ(vulkan.size(), 3U);
    EXPECT_EQ(vulkan[0]["library"], path("./libnone-vulkan.so").string());
    EXPECT_THAT(vulkan[1]["problem"], HasSubstr("ICD.library_path"));
    EXPECT_THAT(vulkan[2]["problem"], HasSubstr("no such file"));
    const std::string problems = json["problems"].dump();
    for (const char* const part :
         {"broken.icd names libnone-opencl.so", "malformed.json", "absent.json", "dpkg -S"}) {
        EXPECT_THAT(problems, HasSubstr(part));
    }
}

TEST_F(DoctorTest, SaysWhereNoDriverIsInstalled) {
    const CommandResult result = run("mkdir none; OCL_ICD_VENDORS=$PWD/none/ zonegrid doctor");
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("none in "));
    EXPECT_THAT(result.output, HasSubstr("sudo apt install pocl-opencl-icd"));
    EXPECT_THAT(result.output, Not(HasSubstr("opencl:0")));
}

} // namespace
} // namespace zonegrid::testing
