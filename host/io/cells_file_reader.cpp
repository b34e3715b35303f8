#include "io/cells_file.h"
#include "io/cells_file_layout.h"
#include "io/file_bytes.h"
#include "io/little_endian.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>

namespace zonegrid {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Unpacks the compressed part piece by piece.
class Decompressor {
public:
    explicit Decompressor(Bytes bytes)
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

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
    throw InputError(file.string(), problem, "map the recording again or copy the file again");
}

template <class Whole>
Whole whole_at(Bytes bytes, std::size_t place) {
    return from_little_endian<Whole>(bytes.subspan(place));
}

/// Checks what surrounds the compressed part.
void check_frame(const std::filesystem::path& file, Bytes bytes) {
    const bool has_magic =
        bytes.size() >= cells_file::magic.size() &&
        std::ranges::equal(bytes.first(cells_file::magic.size()), cells_file::magic);
    if (!has_magic) {
        refuse(file, "the file is no grid that zonegrid wrote");
    }
    if (bytes.size() < cells_file::header_bytes + cells_file::trailer_bytes) {
        refuse(file, "the grid is cut off");
    }
    const auto version = whole_at<std::uint32_t>(bytes, cells_file::version_place);
    if (version != cells_file::version) {
        refuse(file, fmt::format("the grid has version {}, this zonegrid reads version {}", version,
                                 cells_file::version));
    }
    Sha256 sum;
    sum.add(bytes.first(bytes.size() - Sha256::size_bytes));
    if (!std::ranges::equal(sum.finish(), bytes.last(Sha256::size_bytes))) {
        refuse(file, "the grid is cut off or damaged: its checksum differs");
    }
}

StoredCells read_header(const std::filesystem::path& file, Bytes bytes) {
    StoredCells cells;
    cells.zone = whole_at<std::int32_t>(bytes, cells_file::zone_place);
    cells.cell_m = std::bit_cast<double>(whole_at<std::uint64_t>(bytes, cells_file::cell_place));
    cells.limit = whole_at<std::int32_t>(bytes, cells_file::limit_place);
    cells.threshold = whole_at<std::int32_t>(bytes, cells_file::threshold_place);
    if ((cells.zone != 8 && cells.zone != 16 && cells.zone != 32) || !std::isfinite(cells.cell_m) ||
        cells.cell_m <= 0.0) {
        refuse(file, "the grid's header is damaged");
    }
    return cells;
}

StoredZone read_zone(const std::filesystem::path& file, Decompressor& packed,
                     std::vector<std::uint8_t>& bytes) {
    if (!packed.read(bytes)) {
        refuse(file, "the grid's zones are damaged");
    }
    StoredZone zone;
    zone.zone = {whole_at<std::int32_t>(bytes, 0), whole_at<std::int32_t>(bytes, 4),
                 whole_at<std::int32_t>(bytes, 8)};
    const Bytes values = Bytes(bytes).subspan(cells_file::zone_index_bytes);
    zone.values.assign(values.begin(), values.end());
    return zone;
}

} // namespace

StoredCells read_cells_file(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(file);
    check_frame(file, bytes);
    StoredCells cells = read_header(file, bytes);
    const std::size_t packed_bytes =
        bytes.size() - cells_file::header_bytes - cells_file::trailer_bytes;
    Decompressor packed(Bytes(bytes).subspan(cells_file::header_bytes, packed_bytes));
    const auto zones = whole_at<std::uint64_t>(bytes, bytes.size() - cells_file::trailer_bytes);
    const auto edge = static_cast<std::size_t>(cells.zone);
    std::vector<std::uint8_t> zone_bytes(cells_file::zone_index_bytes + edge * edge * edge);
    for (std::uint64_t i = 0; i < zones; ++i) {
        cells.zones.push_back(read_zone(file, packed, zone_bytes));
        if (i > 0 && !(cells.zones[i - 1].zone < cells.zones[i].zone)) {
            refuse(file, "the grid's zones are not in order");
        }
    }
    if (!packed.at_end()) {
        refuse(file, "the grid holds more than its zones");
    }
    return cells;
}

void StoredCells::for_each_cell(const std::function<void(const CellIndex&, int)>& visit) const {
    const auto edge = static_cast<std::size_t>(zone);
    const auto visit_column = [&](const StoredZone& stored, std::size_t x, std::size_t y) {
        CellIndex cell = first_cell_of(stored.zone, zone);
        cell.x += static_cast<std::int32_t>(x);
        cell.y += static_cast<std::int32_t>(y);
        const auto column = std::span(stored.values).subspan((x * edge + y) * edge, edge);
        for (const int value : column) {
            if (value != 0) {
                visit(cell, value);
            }
            ++cell.z;
        }
    };
    // A layer shares its zone x, a row also its zone y: the cells' order crosses zones in both.
    for (auto layer = zones.begin(); layer != zones.end();) {
        const auto layer_end = std::find_if(
            layer, zones.end(), [&](const auto& stored) { return stored.zone.x != layer->zone.x; });
        for (std::size_t x = 0; x < edge; ++x) {
            for (auto row = layer; row != layer_end;) {
                const auto row_end = std::find_if(row, layer_end, [&](const auto& stored) {
                    return stored.zone.y != row->zone.y;
                });
                for (std::size_t y = 0; y < edge; ++y) {
                    std::for_each(row, row_end,
                                  [&](const auto& stored) { visit_column(stored, x, y); });
                }
                row = row_end;
            }
        }
        layer = layer_end;
    }
}

} // namespace zonegrid
