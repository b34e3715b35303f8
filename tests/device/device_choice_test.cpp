#include "device/device_choice.h"

#include "zonegrid/errors.h"

#include <gmock/gmock.h>

#include <functional>
#include <string>
#include <vector>

namespace zonegrid::device {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

DeviceInfo made(const std::string& backend, std::uint32_t index, const std::string& name,
                const std::string& type, const std::string& refusal = "") {
    DeviceInfo info;
    info.backend = backend;
    info.index = index;
    info.name = name;
    info.type = type;
    info.driver = "driver 1";
    info.refusal = refusal;
    return info;
}

DeviceList two_backends() {
    return {
        {made("opencl", 0, "Processor", "CPU"), made("opencl", 1, "Radeon 780M", "integrated GPU"),
         made("opencl", 2, "Radeon 780M Graphics", "integrated GPU", "it is too old"),
         made("vulkan", 0, "Radeon RX 7600", "discrete GPU"), made("vulkan", 1, "llvmpipe", "CPU")},
        {}};
}

std::string id_of(const std::string& backend, const std::string& wanted) {
    return choose_device(two_backends(), backend, wanted).id();
}

/// The message of the UsageError or DeviceError that a choice must end with.
template <class Expected>
std::string refusal_of(const std::string& backend, const std::string& wanted) {
    try {
        return "chose " + id_of(backend, wanted);
    } catch (const Expected& error) {
        return error.what();
    }
}

TEST(DeviceChoice, TakesANumberOfABackend) {
    EXPECT_EQ(id_of("opencl", "1"), "opencl:1");
    EXPECT_EQ(id_of("vulkan", "1"), "vulkan:1");
    EXPECT_THAT(refusal_of<DeviceError>("vulkan", "2"), HasSubstr("vulkan:2"));
    EXPECT_THAT(refusal_of<DeviceError>("vulkan", "2"), HasSubstr("vulkan:1 (llvmpipe"));
    EXPECT_THAT(refusal_of<UsageError>("", "1"), HasSubstr("give the backend too"));
}

TEST(DeviceChoice, TakesAnId) {
    EXPECT_EQ(id_of("", "vulkan:0"), "vulkan:0");
    EXPECT_THAT(refusal_of<DeviceError>("opencl", "vulkan:0"), HasSubstr("found: opencl:0"));
}

TEST(DeviceChoice, TakesAPartOfANameInAnyLetters) {
    EXPECT_EQ(id_of("", "LLVM"), "vulkan:1");
    EXPECT_EQ(id_of("", "rx 76"), "vulkan:0");
    EXPECT_EQ(id_of("vulkan", "radeon"), "vulkan:0");
}

TEST(DeviceChoice, PrefersAWholeNameAndWhatIsNotRefused) {
    DeviceList list = two_backends();
    list.devices[2].refusal = "";
    EXPECT_EQ(choose_device(list, "opencl", "radeon 780m").id(), "opencl:1");
    EXPECT_EQ(id_of("opencl", "radeon"), "opencl:1");
}

TEST(DeviceChoice, ListsAllThatAreMeant) {
    const std::string message = refusal_of<UsageError>("", "radeon");
    EXPECT_THAT(message, HasSubstr("opencl:1 (Radeon 780M, driver 1)"));
    EXPECT_THAT(message, HasSubstr("vulkan:0 (Radeon RX 7600"));
    EXPECT_THAT(message, ::testing::Not(HasSubstr("llvmpipe")));
}

TEST(DeviceChoice, SaysWhyADeviceIsRefused) {
    EXPECT_THAT(refusal_of<DeviceError>("opencl", "2"), HasSubstr("it is too old"));
    EXPECT_THAT(refusal_of<DeviceError>("", "graphics"), HasSubstr("it is too old"));
}

TEST(DeviceChoice, ListsWhatThereIsWhereThereIsNone) {
    EXPECT_THAT(refusal_of<DeviceError>("", "geforce"), HasSubstr("found: opencl:0 (Processor"));
    try {
        static_cast<void>(choose_device({{}, {"vulkan: no driver"}}, "", "geforce"));
        ADD_FAILURE();
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), HasSubstr("found: vulkan: no driver"));
    }
}

TEST(DeviceChoice, TriesGpusFirst) {
    std::vector<std::string> ids;
    for (const auto& info : usable_devices(two_backends())) {
        ids.push_back(info.id());
    }
    EXPECT_THAT(ids, ElementsAre("vulkan:0", "opencl:1", "opencl:0", "vulkan:1"));
}

} // namespace
} // namespace zonegrid::device
