#include "device/sha256.h"

#include <algorithm>
#include <bit>

namespace zonegrid::device {

namespace {

constexpr std::size_t length_bytes = 8; // at the end of the last block

constexpr std::array<std::uint32_t, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

} // namespace

void Sha256::add(std::span<const std::byte> bytes) {
    length_ += bytes.size();
    while (!bytes.empty()) {
        const auto piece = bytes.first(std::min(bytes.size(), block_.size() - used_));
        std::ranges::copy(piece, block_.begin() + static_cast<std::ptrdiff_t>(used_));
        used_ += piece.size();
        bytes = bytes.subspan(piece.size());
        if (used_ == block_.size()) {
            take_block();
            used_ = 0;
        }
    }
}

Sha256::Digest Sha256::digest() {
    const std::uint64_t bits = 8 * length_;
    constexpr std::byte one_bit{0x80};
    constexpr std::byte none{0};
    add({&one_bit, 1});
    while (used_ != block_.size() - length_bytes) {
        add({&none, 1});
    }
    std::array<std::byte, length_bytes> length{};
    for (std::size_t i = 0; i < length.size(); ++i) {
        length[i] = static_cast<std::byte>(bits >> (56 - 8 * i));
    }
    add(length);
    Digest digest{};
    for (std::size_t i = 0; i < digest.size(); ++i) {
        digest[i] = static_cast<std::byte>(state_[i / 4] >> (24 - 8 * (i % 4)));
    }
    return digest;
}

void Sha256::take_block() {
    std::array<std::uint32_t, 64> words{};
    for (std::size_t i = 0; i < block_.size(); ++i) {
        words[i / 4] = words[i / 4] << 8U | std::to_integer<std::uint32_t>(block_[i]);
    }
    for (std::size_t i = 16; i < words.size(); ++i) {
        const auto near = words[i - 15];
        const auto last = words[i - 2];
        words[i] = words[i - 16] + words[i - 7] +
                   (std::rotr(near, 7) ^ std::rotr(near, 18) ^ near >> 3U) +
                   (std::rotr(last, 17) ^ std::rotr(last, 19) ^ last >> 10U);
    }
    auto [a, b, c, d, e, f, g, h] = state_;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::uint32_t first = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                                    ((e & f) ^ (~e & g)) + round_constants[i] + words[i];
        const std::uint32_t second =
            (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + first;
        d = c;
        c = b;
        b = a;
        a = first + second;
    }
    const std::array<std::uint32_t, 8> added{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state_.size(); ++i) {
        state_[i] += added[i];
    }
}

Sha256::Digest sha256(std::span<const std::byte> bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.digest();
}

} // namespace zonegrid::device
