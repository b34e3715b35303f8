#include "io/device_files.h"

#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

namespace zonegrid {
namespace {

using ::testing::ElementsAre;

void write_files(const std::filesystem::path& dev) {
    std::filesystem::create_directories(dev / "dri");
    std::filesystem::create_directories(dev / "nvidia-caps");
    for (const char* const name :
         {"dri/renderD129", "dri/renderD128", "dri/card0", "kfd", "nvidia0", "mali0", "null"}) {
        std::ofstream(dev / name) << "";
    }
}

TEST(DeviceFiles, AreThoseOfGpus) {
    const testing::TemporaryFolder dev;
    write_files(dev.path());
    std::vector<std::string> names;
    for (const DeviceFile& file : find_device_files(dev.path())) {
        names.push_back(std::filesystem::relative(file.file, dev.path()).string());
        EXPECT_TRUE(file.usable());
        EXPECT_FALSE(file.group.empty());
        EXPECT_FALSE(file.owner.empty());
    }
    EXPECT_THAT(names, ElementsAre("dri/renderD128", "dri/renderD129", "kfd", "mali0", "nvidia0"));
}

TEST(DeviceFiles, SayWhatTheGroupMay) {
    namespace fs = std::filesystem;
    const testing::TemporaryFolder dev;
    std::ofstream(dev.path() / "kfd") << "";
    fs::permissions(dev.path() / "kfd", fs::perms::owner_all | fs::perms::group_read);
    EXPECT_FALSE(find_device_files(dev.path()).at(0).group_may);
    fs::permissions(dev.path() / "kfd", fs::perms::group_read | fs::perms::group_write);
    const DeviceFile file = find_device_files(dev.path()).at(0);
    EXPECT_TRUE(file.group_may);
    EXPECT_EQ(file.usable(), ::geteuid() == 0); // root may do everything
}

TEST(DeviceFiles, MayBeNone) {
    EXPECT_TRUE(find_device_files("/nowhere").empty());
}

} // namespace
} // namespace zonegrid
