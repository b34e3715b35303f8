#pragma once

#include "io/sha256.h"

#include <array>
#include <cstddef>
#include <cstdint>

// The fixed parts of cells.zgrid (docs/formats.md). Numbers are little-endian.
namespace zonegrid::cells_file {

/// A transfer as text, which changes ends of lines, breaks the last three.
inline constexpr std::array<std::uint8_t, 8> magic{'Z', 'G', 'R', 'I', 'D', '\r', '\n', 0x1A};
inline constexpr std::uint32_t version = 1;

// Header: magic, uint32 version, uint32 zone, float64 cell_m, int32 limit, int32 threshold.
inline constexpr std::size_t version_place = 8;
inline constexpr std::size_t zone_place = 12;
inline constexpr std::size_t cell_place = 16;
inline constexpr std::size_t limit_place = 24;
inline constexpr std::size_t threshold_place = 28;
inline constexpr std::size_t header_bytes = 32;

// Trailer: uint64 number of zones, SHA-256 of all bytes before it.
inline constexpr std::size_t count_bytes = 8;
inline constexpr std::size_t trailer_bytes = count_bytes + Sha256::size_bytes;

// Between them, compressed, each zone: int32 x, y, z, then zone^3 int8 values.
inline constexpr std::size_t zone_index_bytes = 12;

} // namespace zonegrid::cells_file
