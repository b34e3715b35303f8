#include "io/output_file.h"

#include "zonegrid/errors.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace zonegrid {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 18;

} // namespace

OutputFile::OutputFile(std::filesystem::path file) : file_(std::move(file)) {
    constexpr mode_t read_and_write_but_for_umask = 0666;
    descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC,
                         read_and_write_but_for_umask);
    if (descriptor_ < 0) {
        fail(errno);
    }
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_); // only after an error: the file is thrown away
    }
}

void OutputFile::write(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= buffer_bytes) {
        flush();
    }
}

void OutputFile::write(std::span<const std::uint8_t> bytes) {
    // Chars are what the text overload takes; the bytes stay the same.
    write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void OutputFile::flush() {
    std::string_view rest = buffer_;
    while (!rest.empty()) {
        const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
        if (written < 0 && errno != EINTR) {
            fail(errno);
        }
        rest.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    buffer_.clear();
}

void OutputFile::close() {
    flush();
    // The descriptor is gone whatever close() says; some file systems report a full disk only here.
    if (::close(std::exchange(descriptor_, -1)) != 0) {
        fail(errno);
    }
}

void OutputFile::fail(int error_number) const {
    throw OutputError(
        fmt::format("{}: cannot be written ({}); check the folder's permissions and "
                    "the space left on the disk",
                    file_.string(), std::generic_category().message(error_number)));
}

} // namespace zonegrid
