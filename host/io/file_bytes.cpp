#include "io/file_bytes.h"

#include "zonegrid/errors.h"

#include <algorithm>
#include <fstream>
#include <ios>
#include <system_error>

namespace zonegrid {

std::vector<std::uint8_t> read_file_bytes(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) {
        throw InputError(file.string(), "cannot be opened: " + error.message(),
                         "check the name and the permissions");
    }
    if (size == 0) {
        throw InputError(file.string(), "the file is empty", "copy it again from its source");
    }
    std::vector<std::uint8_t> bytes(size);
    std::ifstream stream(file, std::ios::binary);
    // Reading chars into bytes is what the stream interface asks for.
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream) {
        throw InputError(file.string(), "cannot be read to its end",
                         "check the permissions and the disk");
    }
    return bytes;
}

std::vector<std::filesystem::path> list_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::vector<std::filesystem::path> entries;
    std::filesystem::directory_iterator entry(folder, error);
    while (!error && entry != std::filesystem::directory_iterator{}) {
        entries.push_back(entry->path());
        entry.increment(error);
    }
    if (error) {
        throw InputError(folder.string(), "the folder cannot be listed: " + error.message(),
                         "check the name and the permissions");
    }
    std::ranges::sort(entries);
    return entries;
}

} // namespace zonegrid
