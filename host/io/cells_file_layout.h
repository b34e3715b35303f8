#pragma once

#include "io/zone_stream.h"
#include "model/lattice.h"
#include "zonegrid/options.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// The fixed parts of cells.zgrid and history.zgrid (docs/formats.md).
namespace zonegrid::cells_file {

// Header: magic, uint32 version, uint32 zone, float64 cell_m, int32 limit, int32 threshold; that of
// a history goes on with uint32 frames.
inline constexpr std::size_t zone_place = 12;
inline constexpr std::size_t cell_place = 16;
inline constexpr std::size_t limit_place = 24;
inline constexpr std::size_t threshold_place = 28;
inline constexpr std::size_t header_bytes = 32;
inline constexpr std::size_t frames_place = 32;
inline constexpr std::size_t history_header_bytes = 36;

// Each zone: int32 x, y, z, then zone^3 int8 values. In a history: uint32 number of stamps, then
// each stamp: uint16 place, uint32 first image, uint32 since.
inline constexpr std::size_t zone_index_bytes = 12;
inline constexpr std::size_t stamp_bytes = 10;

inline constexpr ZoneStreamKind cells_kind{
    {'Z', 'G', 'R', 'I', 'D', '\r', '\n', 0x1A}, 1, header_bytes, "grid"};
inline constexpr ZoneStreamKind history_kind{
    {'Z', 'H', 'I', 'S', 'T', '\r', '\n', 0x1A}, 1, history_header_bytes, "history"};

/// What both headers hold after magic and version.
[[nodiscard]] std::vector<std::uint8_t> header_of(const MapperOptions& options);

/// The inverse, from a header with magic and version; the other options are the default ones.
/// Refuses what no map can have.
[[nodiscard]] MapperOptions options_of(const ZoneStreamReader& reader);

/// The index that the bytes of a zone begin with.
[[nodiscard]] ZoneIndex zone_index_of(std::span<const std::uint8_t> bytes);

} // namespace zonegrid::cells_file
