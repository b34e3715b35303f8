#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace zonegrid {

/// A file by which drivers reach a GPU, and whether this user may use it.
struct DeviceFile {
    std::filesystem::path file;
    bool readable = false;
    bool writable = false;
    std::string owner;      ///< name of its user; the number if that has no name
    std::string group;      ///< name of its group
    bool group_may = false; ///< the group may read and write

    [[nodiscard]] bool usable() const { return readable && writable; }
};

/// `dri/renderD*`, `kfd`, `nvidia*` and `mali*` in `folder`, which is /dev, sorted by name.
[[nodiscard]] std::vector<DeviceFile> find_device_files(const std::filesystem::path& folder);

} // namespace zonegrid
