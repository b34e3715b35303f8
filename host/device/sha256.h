#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace zonegrid::device {

/// SHA-256 (FIPS 180-4) of what is added, piece by piece. The library links to no cryptography, so
/// it has its own.
class Sha256 {
public:
    using Digest = std::array<std::byte, 32>;

    void add(std::span<const std::byte> bytes);
    /// Of all bytes added; nothing may be added after that.
    [[nodiscard]] Digest digest();

private:
    void take_block();

    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<std::byte, 64> block_{};
    std::size_t used_ = 0;     ///< bytes of the block
    std::uint64_t length_ = 0; ///< bytes added
};

[[nodiscard]] Sha256::Digest sha256(std::span<const std::byte> bytes);

} // namespace zonegrid::device
