#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace zonegrid {

/// A file being written, buffered. No failed write goes unnoticed, not even one that the system
/// reports only when the file is closed.
class OutputFile {
public:
    /// Creates `file`, or empties it. Throws OutputError if it cannot.
    explicit OutputFile(std::filesystem::path file);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    /// Throws OutputError naming the file and the system's reason.
    void write(std::string_view text);
    void write(std::span<const std::uint8_t> bytes);

    /// Writes what is left and closes. A file that is destroyed without this is incomplete.
    /// Throws OutputError as `write` does.
    void close();

private:
    void flush();
    [[noreturn]] void fail(int error_number) const;

    std::filesystem::path file_;
    std::string buffer_;
    int descriptor_ = -1;
};

} // namespace zonegrid
