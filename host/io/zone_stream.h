#pragma once

#include "io/output_file.h"
#include "io/sha256.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

// What cells.zgrid and history.zgrid have in common (docs/formats.md): a header that is not
// compressed, zones as one zstd frame, then their number and a SHA-256 of all bytes before.
// Numbers are little-endian.
namespace zonegrid {

/// A transfer as text, which changes ends of lines, breaks the last three.
using ZoneStreamMagic = std::array<std::uint8_t, 8>;

/// Which of the files it is.
struct ZoneStreamKind {
    ZoneStreamMagic magic{};
    std::uint32_t version = 0;
    std::size_t header_bytes = 0; ///< magic and version, which are its first 12, among them
    const char* word = "";        ///< how messages call it: "grid"
};

/// Writes such a file, piece by piece. Throws OutputError if it cannot be written.
class ZoneStreamWriter {
public:
    /// `header`: what follows the magic and the version.
    ZoneStreamWriter(const std::filesystem::path& file, const ZoneStreamKind& kind,
                     std::span<const std::uint8_t> header);
    ZoneStreamWriter(const ZoneStreamWriter&) = delete;
    ZoneStreamWriter& operator=(const ZoneStreamWriter&) = delete;
    ~ZoneStreamWriter();

    void add_zone(std::span<const std::uint8_t> bytes);

    /// Writes the end of the file. A writer that is destroyed without this leaves a file that
    /// readers refuse.
    void close();

private:
    class Compressor;

    void write(std::span<const std::uint8_t> bytes);

    OutputFile output_;
    Sha256 sum_;
    std::unique_ptr<Compressor> compressor_;
    std::uint64_t zones_ = 0;
};

/// Reads such a file. Whatever is wrong with it is an InputError.
class ZoneStreamReader {
public:
    ZoneStreamReader(std::filesystem::path file, const ZoneStreamKind& kind);
    ZoneStreamReader(const ZoneStreamReader&) = delete;
    ZoneStreamReader& operator=(const ZoneStreamReader&) = delete;
    ~ZoneStreamReader();

    /// The header from the magic on.
    [[nodiscard]] std::span<const std::uint8_t> header() const;
    [[nodiscard]] std::uint64_t zones() const { return zones_; }

    /// Fills `target` with what comes next of the zones.
    void read(std::span<std::uint8_t> target);

    /// To be called after the last zone.
    void require_end();

    /// Throws InputError: "the grid" and `problem`.
    [[noreturn]] void refuse(const std::string& problem) const;

private:
    class Decompressor;

    void check_frame() const;

    std::filesystem::path file_;
    ZoneStreamKind kind_;
    std::vector<std::uint8_t> bytes_;
    std::uint64_t zones_ = 0;
    std::unique_ptr<Decompressor> packed_;
};

} // namespace zonegrid
