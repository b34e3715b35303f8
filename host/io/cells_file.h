#pragma once

#include "io/zone_stream.h"
#include "model/lattice.h"
#include "zonegrid/objects.h"
#include "zonegrid/options.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace zonegrid {

/// Writes cells.zgrid (docs/formats.md): the zones with a value other than 0, compressed, with a
/// checksum. Cells come by x, then y, then z; memory is that of one layer of zones.
class CellsFileWriter {
public:
    /// Throws OutputError if the file cannot be created.
    CellsFileWriter(const std::filesystem::path& file, const MapperOptions& options);

    /// Throws OutputError if the file cannot be written.
    void add(const CellIndex& cell, int value);

    /// Writes the end of the file. A writer that is destroyed without this leaves a file that
    /// readers refuse. Throws OutputError as `add` does.
    void close();

private:
    void flush_layer();
    std::vector<std::int8_t>& values_of(const ZoneIndex& zone);

    ZoneStreamWriter stream_;
    int zone_;
    std::int32_t layer_x_ = 0;
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int8_t>> layer_;
    ZoneIndex last_zone_;
    std::vector<std::int8_t>* last_values_ = nullptr;
};

/// One zone of a cells file.
struct StoredZone {
    ZoneIndex zone;
    std::vector<std::int8_t> values; ///< zone^3 values, `[x][y][z]`
};

/// What a cells file holds.
struct StoredCells {
    double cell_m = 0.0;
    int zone = 0; ///< edge of a zone, cells
    int limit = 0;
    int threshold = 0;
    std::vector<StoredZone> zones; ///< by x, then y, then z

    /// Calls `visit` for every cell with a value other than 0, by x, then y, then z.
    void for_each_cell(const std::function<void(const CellIndex&, int)>& visit) const;
};

/// Throws InputError if the file is missing, cut off, damaged or of an unknown version.
[[nodiscard]] StoredCells read_cells_file(const std::filesystem::path& file);

} // namespace zonegrid
