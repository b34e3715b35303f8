#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace zonegrid {

/// The SHA-256 of bytes that come in pieces.
class Sha256 {
public:
    static constexpr std::size_t size_bytes = 32;

    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;
    Sha256(Sha256&&) noexcept;
    Sha256& operator=(Sha256&&) noexcept;

    void add(std::string_view text);
    void add(std::span<const std::uint8_t> bytes);

    /// The sum of all bytes added; to be called once, after the last.
    [[nodiscard]] std::array<std::uint8_t, size_bytes> finish();
    /// The same as 64 lower-case hexadecimal digits.
    [[nodiscard]] std::string finish_hex();

private:
    struct Context;
    std::unique_ptr<Context> context_;
};

} // namespace zonegrid
