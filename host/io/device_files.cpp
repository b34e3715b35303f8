#include "io/device_files.h"

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <system_error>

namespace zonegrid {
namespace {

namespace fs = std::filesystem;

void add_files(const fs::path& folder, std::string_view prefix, std::vector<DeviceFile>& found) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator{};
         entry.increment(error)) {
        const fs::path& file = entry->path();
        struct stat status {};
        if (!file.filename().string().starts_with(prefix) || ::stat(file.c_str(), &status) != 0 ||
            S_ISDIR(status.st_mode)) {
            continue;
        }
        const passwd* const owner = ::getpwuid(status.st_uid);
        const group* const owners = ::getgrgid(status.st_gid);
        found.push_back({file, ::access(file.c_str(), R_OK) == 0, ::access(file.c_str(), W_OK) == 0,
                         owner == nullptr ? std::to_string(status.st_uid) : owner->pw_name,
                         owners == nullptr ? std::to_string(status.st_gid) : owners->gr_name,
                         (status.st_mode & (S_IRGRP | S_IWGRP)) == (S_IRGRP | S_IWGRP)});
    }
}

} // namespace

std::vector<DeviceFile> find_device_files(const fs::path& folder) {
    std::vector<DeviceFile> found;
    add_files(folder / "dri", "renderD", found);
    for (const char* const prefix : {"kfd", "nvidia", "mali"}) {
        add_files(folder, prefix, found);
    }
    std::ranges::sort(found, {}, &DeviceFile::file);
    return found;
}

} // namespace zonegrid
