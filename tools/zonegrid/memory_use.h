#pragma once

#include <cstdint>

namespace zonegrid {

/// The most memory this process has held so far, in bytes.
[[nodiscard]] std::uint64_t memory_most_bytes();

} // namespace zonegrid
