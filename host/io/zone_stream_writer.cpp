#include "io/little_endian.h"
#include "io/zone_stream.h"

#include <fmt/format.h>
#include <zstd.h>

#include <new>
#include <stdexcept>

namespace zonegrid {

/// zstd, as a stream that hands its output to a function.
class ZoneStreamWriter::Compressor {
public:
    Compressor() : stream_(ZSTD_createCCtx()), output_(ZSTD_CStreamOutSize()) {
        if (stream_ == nullptr) {
            throw std::bad_alloc();
        }
    }
    Compressor(const Compressor&) = delete;
    Compressor& operator=(const Compressor&) = delete;
    ~Compressor() { ZSTD_freeCCtx(stream_); }

    /// Takes all of `bytes`; with `last` also ends the stream. Calls `write` for what comes out.
    template <class Write>
    void add(std::span<const std::uint8_t> bytes, bool last, Write write) {
        ZSTD_inBuffer input{bytes.data(), bytes.size(), 0};
        std::size_t left = 1;
        while (last ? left != 0 : input.pos < input.size) {
            ZSTD_outBuffer out{output_.data(), output_.size(), 0};
            left = ZSTD_compressStream2(stream_, &out, &input, last ? ZSTD_e_end : ZSTD_e_continue);
            if (ZSTD_isError(left) != 0) {
                throw std::runtime_error(fmt::format("zstd: {}", ZSTD_getErrorName(left)));
            }
            write(std::span(output_).first(out.pos));
        }
    }

private:
    ZSTD_CCtx* stream_;
    std::vector<std::uint8_t> output_;
};

ZoneStreamWriter::ZoneStreamWriter(const std::filesystem::path& file, const ZoneStreamKind& kind,
                                   std::span<const std::uint8_t> header)
    : output_(file), compressor_(std::make_unique<Compressor>()) {
    std::vector<std::uint8_t> start(kind.magic.begin(), kind.magic.end());
    append_little_endian(start, kind.version);
    start.insert(start.end(), header.begin(), header.end());
    write(start);
}

ZoneStreamWriter::~ZoneStreamWriter() = default;

void ZoneStreamWriter::add_zone(std::span<const std::uint8_t> bytes) {
    compressor_->add(bytes, false, [this](auto piece) { write(piece); });
    ++zones_;
}

void ZoneStreamWriter::close() {
    compressor_->add({}, true, [this](auto bytes) { write(bytes); });
    std::vector<std::uint8_t> count;
    append_little_endian(count, zones_);
    write(count);
    output_.write(sum_.finish());
    output_.close();
}

void ZoneStreamWriter::write(std::span<const std::uint8_t> bytes) {
    sum_.add(bytes);
    output_.write(bytes);
}

} // namespace zonegrid
