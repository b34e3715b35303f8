#include "device/kernel_cache.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <system_error>
#include <utility>

namespace zonegrid::device {

namespace {

// The last byte is the version of the format.
constexpr std::string_view magic{"ZGKERNL\x01", 8};
constexpr std::size_t length_bytes = 8;
constexpr std::size_t head_bytes =
    magic.size() + sizeof(Sha256::Digest) + length_bytes + sizeof(Sha256::Digest);

using Head = std::array<std::byte, head_bytes>;

std::array<std::byte, length_bytes> little_endian(std::uint64_t value) {
    std::array<std::byte, length_bytes> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::byte>(value >> (8 * i));
    }
    return bytes;
}

Head make_head(const KernelKey& key, std::span<const std::byte> bytes) {
    Head head{};
    auto at = head.begin();
    const auto put = [&](std::span<const std::byte> piece) {
        at = std::ranges::copy(piece, at).out;
    };
    put(std::as_bytes(std::span(magic)));
    put(key.digest());
    put(little_endian(bytes.size()));
    put(sha256(bytes));
    return head;
}

/// A file that is closed when destroyed.
class OpenFile {
public:
    explicit OpenFile(int number) : number_(number) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (number_ >= 0) {
            close(number_);
        }
    }

    [[nodiscard]] int number() const { return number_; }
    [[nodiscard]] explicit operator bool() const { return number_ >= 0; }
    /// Some file systems tell only now that a write failed.
    [[nodiscard]] bool close_early() { return close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

bool read_all(const OpenFile& file, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const auto count = read(file.number(), bytes.data(), bytes.size());
        if (count > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            return false;
        }
    }
    return true;
}

bool write_all(const OpenFile& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const auto count = write(file.number(), bytes.data(), bytes.size());
        if (count >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

/// Machine code runs with this process's rights, so only its own user and root may have written it.
bool is_trusted(const struct stat& status) {
    return S_ISREG(status.st_mode) && (status.st_uid == geteuid() || status.st_uid == 0);
}

std::optional<std::vector<std::byte>> read_file(const std::filesystem::path& path,
                                                const KernelKey& key) {
    // Without O_NONBLOCK a pipe of that name would hold up the program.
    const OpenFile file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    Head head{};
    if (!file || fstat(file.number(), &status) != 0 || !is_trusted(status) ||
        status.st_size < static_cast<off_t>(head.size()) || !read_all(file, head)) {
        return std::nullopt;
    }
    // Key and length are compared before memory is taken for what they announce.
    std::vector<std::byte> bytes;
    const auto size = static_cast<std::size_t>(status.st_size) - head.size();
    const auto digest = key.digest();
    const auto length = little_endian(size);
    const auto key_at = head.begin() + magic.size();
    const auto length_at = key_at + digest.size();
    if (!std::ranges::equal(std::span(head).first(magic.size()), std::as_bytes(std::span(magic))) ||
        !std::equal(digest.begin(), digest.end(), key_at) ||
        !std::equal(length.begin(), length.end(), length_at)) {
        return std::nullopt;
    }
    bytes.resize(size);
    if (!read_all(file, bytes) || make_head(key, bytes) != head) {
        return std::nullopt;
    }
    return bytes;
}

void write_file(const std::filesystem::path& path, const KernelKey& key,
                std::span<const std::byte> bytes) {
    std::string temporary = path.string() + ".XXXXXX";
    OpenFile file(mkostemp(temporary.data(), O_CLOEXEC));
    if (!file) {
        return;
    }
    if (!write_all(file, make_head(key, bytes)) || !write_all(file, bytes) || !file.close_early() ||
        std::rename(temporary.c_str(), path.c_str()) != 0) {
        unlink(temporary.c_str());
    }
}

const char* value_of(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr || *value == '\0' ? nullptr : value;
}

} // namespace

KernelKey& KernelKey::add(std::string_view text) {
    return add(std::as_bytes(std::span(text)));
}

KernelKey& KernelKey::add(std::span<const std::byte> bytes) {
    hash_.add(little_endian(bytes.size()));
    hash_.add(bytes);
    return *this;
}

Sha256::Digest KernelKey::digest() const {
    Sha256 hash = hash_;
    return hash.digest();
}

KernelCache KernelCache::of_user() {
    if (std::getenv("ZONEGRID_CACHE_DIR") != nullptr) {
        const char* const chosen = value_of("ZONEGRID_CACHE_DIR");
        return chosen == nullptr ? KernelCache() : KernelCache(chosen);
    }
    // A relative XDG_CACHE_HOME does not count, by its specification.
    const char* const caches = value_of("XDG_CACHE_HOME");
    if (caches != nullptr && *caches == '/') {
        return KernelCache(std::filesystem::path(caches) / "zonegrid");
    }
    const char* const home = value_of("HOME");
    return home == nullptr ? KernelCache()
                           : KernelCache(std::filesystem::path(home) / ".cache" / "zonegrid");
}

std::optional<std::vector<std::byte>> KernelCache::find(const KernelKey& key) const {
    if (folder_.empty()) {
        return std::nullopt;
    }
    try {
        return read_file(file_of(key), key);
    } catch (const std::exception&) {
        return std::nullopt; // no memory for it: the compiler will tell
    }
}

void KernelCache::keep(const KernelKey& key, std::span<const std::byte> bytes) const {
    if (folder_.empty()) {
        return;
    }
    try {
        std::error_code error; // then no file can be made in it either
        std::filesystem::create_directories(folder_, error);
        write_file(file_of(key), key, bytes);
    } catch (const std::exception&) {
        return; // a kernel that is not kept is compiled again
    }
}

std::filesystem::path KernelCache::file_of(const KernelKey& key) const {
    std::string name;
    for (const auto byte : key.digest()) {
        name += fmt::format("{:02x}", std::to_integer<unsigned>(byte));
    }
    return folder_ / (name + ".kernel");
}

} // namespace zonegrid::device
