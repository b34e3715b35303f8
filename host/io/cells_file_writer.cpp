#include "io/cells_file.h"
#include "io/cells_file_layout.h"
#include "io/little_endian.h"

#include <fmt/format.h>
#include <zstd.h>

#include <new>
#include <stdexcept>

namespace zonegrid {

/// zstd, as a stream that hands its output to a function.
class CellsFileWriter::Compressor {
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

CellsFileWriter::CellsFileWriter(const std::filesystem::path& file, const MapperOptions& options)
    : output_(file), compressor_(std::make_unique<Compressor>()), zone_(options.zone) {
    std::vector<std::uint8_t> header(cells_file::magic.begin(), cells_file::magic.end());
    append_little_endian(header, cells_file::version);
    append_little_endian(header, static_cast<std::uint32_t>(options.zone));
    append_little_endian(header, options.cell_m);
    append_little_endian(header, static_cast<std::int32_t>(options.limit));
    append_little_endian(header, static_cast<std::int32_t>(options.threshold));
    write(header);
}

CellsFileWriter::~CellsFileWriter() = default;

void CellsFileWriter::add(const CellIndex& cell, int value) {
    const ZoneIndex zone = zone_of(cell, zone_);
    if (last_values_ == nullptr || zone != last_zone_) {
        if (zone.x != layer_x_) {
            flush_layer();
            layer_x_ = zone.x;
        }
        last_values_ = &values_of(zone);
        last_zone_ = zone;
    }
    const CellIndex first = first_cell_of(zone, zone_);
    const std::int32_t place =
        ((cell.x - first.x) * zone_ + (cell.y - first.y)) * zone_ + (cell.z - first.z);
    (*last_values_)[static_cast<std::size_t>(place)] = static_cast<std::int8_t>(value);
}

void CellsFileWriter::close() {
    flush_layer();
    compressor_->add({}, true, [this](auto bytes) { write(bytes); });
    std::vector<std::uint8_t> count;
    append_little_endian(count, zones_);
    write(count);
    output_.write(sum_.finish());
    output_.close();
}

void CellsFileWriter::write(std::span<const std::uint8_t> bytes) {
    sum_.add(bytes);
    output_.write(bytes);
}

void CellsFileWriter::flush_layer() {
    std::vector<std::uint8_t> bytes;
    for (const auto& [place, values] : layer_) {
        bytes.clear();
        append_little_endian(bytes, layer_x_);
        append_little_endian(bytes, place.first);
        append_little_endian(bytes, place.second);
        bytes.insert(bytes.end(), values.begin(), values.end());
        compressor_->add(bytes, false, [this](auto piece) { write(piece); });
    }
    zones_ += layer_.size();
    layer_.clear();
    last_values_ = nullptr;
}

std::vector<std::int8_t>& CellsFileWriter::values_of(const ZoneIndex& zone) {
    std::vector<std::int8_t>& values = layer_[{zone.y, zone.z}];
    const auto edge = static_cast<std::size_t>(zone_);
    values.resize(edge * edge * edge);
    return values;
}

} // namespace zonegrid
