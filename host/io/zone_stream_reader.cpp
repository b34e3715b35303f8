#include "io/file_bytes.h"
#include "io/little_endian.h"
#include "io/zone_stream.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <new>
#include <utility>

namespace zonegrid {
namespace {

constexpr std::size_t version_place = 8;
constexpr std::size_t trailer_bytes = 8 + Sha256::size_bytes;

} // namespace

/// Unpacks the compressed part piece by piece.
class ZoneStreamReader::Decompressor {
public:
    explicit Decompressor(std::span<const std::uint8_t> bytes)
        : stream_(ZSTD_createDCtx()), input_{bytes.data(), bytes.size(), 0} {
        if (stream_ == nullptr) {
            throw std::bad_alloc();
        }
    }
    Decompressor(const Decompressor&) = delete;
    Decompressor& operator=(const Decompressor&) = delete;
    ~Decompressor() { ZSTD_freeDCtx(stream_); }

    /// Fills `target`; false if the stream is damaged or ends before that.
    [[nodiscard]] bool read(std::span<std::uint8_t> target) {
        ZSTD_outBuffer out{target.data(), target.size(), 0};
        while (out.pos < out.size) {
            const std::size_t before = out.pos + input_.pos;
            left_ = ZSTD_decompressStream(stream_, &out, &input_);
            if (ZSTD_isError(left_) != 0 || out.pos + input_.pos == before) {
                return false;
            }
        }
        return true;
    }

    /// True if the stream holds nothing more.
    [[nodiscard]] bool at_end() {
        std::uint8_t more = 0;
        ZSTD_outBuffer out{&more, 1, 0};
        while (left_ != 0 && out.pos == 0) {
            const std::size_t before = input_.pos;
            left_ = ZSTD_decompressStream(stream_, &out, &input_);
            if (ZSTD_isError(left_) != 0 || (input_.pos == before && left_ != 0)) {
                return false;
            }
        }
        return out.pos == 0 && input_.pos == input_.size;
    }

private:
    ZSTD_DCtx* stream_;
    ZSTD_inBuffer input_;
    std::size_t left_ = 1;
};

ZoneStreamReader::ZoneStreamReader(std::filesystem::path file, const ZoneStreamKind& kind)
    : file_(std::move(file)), kind_(kind), bytes_(read_file_bytes(file_)) {
    check_frame();
    const std::span<const std::uint8_t> bytes(bytes_);
    zones_ = from_little_endian<std::uint64_t>(bytes.subspan(bytes.size() - trailer_bytes));
    packed_ = std::make_unique<Decompressor>(
        bytes.subspan(kind_.header_bytes, bytes.size() - kind_.header_bytes - trailer_bytes));
}

ZoneStreamReader::~ZoneStreamReader() = default;

std::span<const std::uint8_t> ZoneStreamReader::header() const {
    return std::span(bytes_).first(kind_.header_bytes);
}

void ZoneStreamReader::read(std::span<std::uint8_t> target) {
    if (!packed_->read(target)) {
        refuse("'s zones are damaged");
    }
}

void ZoneStreamReader::require_end() {
    if (!packed_->at_end()) {
        refuse(" holds more than its zones");
    }
}

void ZoneStreamReader::refuse(const std::string& problem) const {
    throw InputError(file_.string(), fmt::format("the {}{}", kind_.word, problem),
                     "map the recording again or copy the file again");
}

void ZoneStreamReader::check_frame() const {
    const std::span<const std::uint8_t> bytes(bytes_);
    if (bytes.size() < kind_.magic.size() ||
        !std::ranges::equal(bytes.first(kind_.magic.size()), kind_.magic)) {
        throw InputError(file_.string(),
                         fmt::format("the file is no {} that zonegrid wrote", kind_.word),
                         "map the recording again or copy the file again");
    }
    if (bytes.size() < kind_.header_bytes + trailer_bytes) {
        refuse(" is cut off");
    }
    const auto version = from_little_endian<std::uint32_t>(bytes.subspan(version_place));
    if (version != kind_.version) {
        refuse(
            fmt::format(" has version {}, this zonegrid reads version {}", version, kind_.version));
    }
    Sha256 sum;
    sum.add(bytes.first(bytes.size() - Sha256::size_bytes));
    if (!std::ranges::equal(sum.finish(), bytes.last(Sha256::size_bytes))) {
        refuse(" is cut off or damaged: its checksum differs");
    }
}

} // namespace zonegrid
