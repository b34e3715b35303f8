#include "device/device.h"

#include "support/each_device.h"
#include "support/environment.h"
#include "zonegrid/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

namespace zonegrid {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

template <class Failure>
std::string message_of_opening(const char* name) {
    try {
        (void)device::open_device(name);
    } catch (const Failure& error) {
        return error.what();
    }
    return "opened, or failed otherwise";
}

class DeviceListOf : public EachDevice {};

INSTANTIATE_TEST_SUITE_P(Backends, DeviceListOf, testing::Values("opencl", "vulkan"), backend_name);

TEST_P(DeviceListOf, SaysWhatMatters) {
    for (const auto& info : devices()) {
        SCOPED_TRACE(describe(info));
        EXPECT_FALSE(info.name.empty());
        EXPECT_FALSE(info.driver.empty());
        EXPECT_FALSE(info.type.empty());
        EXPECT_THAT(info.api, HasSubstr("."));
        EXPECT_GE(info.limits.buffer_bytes, 128U << 20U);
        EXPECT_GE(info.limits.memory_bytes, info.limits.buffer_bytes);
        EXPECT_GE(info.limits.group_items, 128U);
        EXPECT_GE(info.limits.local_bytes, 16U << 10U);
        EXPECT_GE(info.limits.kernel_buffers, 4U);
    }
}

TEST_P(DeviceListOf, OpensTheFirstUsableDeviceByItsBackendsName) {
    EXPECT_EQ(device::open_device(GetParam())->info().id(), devices().front().id());
}

TEST_P(DeviceListOf, NamesWhatWasFoundIfThereIsNoSuchDevice) {
    EXPECT_THAT(message_of_opening<DeviceError>((std::string(GetParam()) + ":99").c_str()),
                AllOf(HasSubstr(":99"), HasSubstr(devices().front().name),
                      HasSubstr(devices().front().driver)));
}

TEST(DeviceList, CountsEachBackendFromZero) {
    std::map<std::string, std::uint32_t> next;
    for (const auto& info : device::list_devices().devices) {
        EXPECT_EQ(info.index, next[info.backend]++) << info.id();
    }
}

TEST(DeviceList, RefusesNamesThatAreNoDevices) {
    for (const char* name : {"", "cuda", "opencl:", "opencl:x", "vulkan:-1", "vulkan:0x", ":0",
                             "opencl:99999999999"}) {
        EXPECT_THAT(message_of_opening<UsageError>(name), HasSubstr("opencl:1")) << name;
    }
}

TEST(DeviceList, SaysWhichLoadersAreMissing) {
    const Environment opencl("ZONEGRID_OPENCL_LIBRARY", "libNoOpenCL.so");
    const Environment vulkan("ZONEGRID_VULKAN_LIBRARY", "libno_vulkan.so");
    const auto list = device::list_devices();
    EXPECT_TRUE(list.devices.empty());
    EXPECT_THAT(list.missing, Contains(AllOf(HasSubstr("libNoOpenCL.so"), HasSubstr("install"))));
    EXPECT_THAT(list.missing, Contains(AllOf(HasSubstr("libno_vulkan.so"), HasSubstr("install"))));
    EXPECT_THAT(message_of_opening<DeviceError>("vulkan"), HasSubstr("libno_vulkan.so"));
    EXPECT_THAT(message_of_opening<DeviceError>("opencl:0"), HasSubstr("libNoOpenCL.so"));
}

TEST(DeviceList, SaysThatALibraryIsNoLoader) {
    const Environment opencl("ZONEGRID_OPENCL_LIBRARY", "libm.so.6");
    const Environment vulkan("ZONEGRID_VULKAN_LIBRARY", "libm.so.6");
    const auto list = device::list_devices();
    EXPECT_TRUE(list.devices.empty());
    EXPECT_THAT(list.missing, Contains(HasSubstr("libm.so.6 has no function clGetPlatformIDs")));
    EXPECT_THAT(list.missing,
                Contains(HasSubstr("libm.so.6 has no function vkGetInstanceProcAddr")));
}

} // namespace
} // namespace zonegrid
