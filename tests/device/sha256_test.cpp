#include "device/sha256.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace zonegrid {
namespace {

std::string hexadecimal(const device::Sha256::Digest& digest) {
    std::string text;
    for (const auto byte : digest) {
        text += fmt::format("{:02x}", std::to_integer<unsigned>(byte));
    }
    return text;
}

std::string sha256_of(std::string_view text) {
    return hexadecimal(device::sha256(std::as_bytes(std::span(text))));
}

// The examples that NIST publishes with FIPS 180.
TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256_of(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnThePieces) {
    const std::string text(300, 'z');
    for (std::size_t first = 0; first <= text.size(); ++first) {
        device::Sha256 hash;
        hash.add(std::as_bytes(std::span(text)).first(first));
        hash.add(std::as_bytes(std::span(text)).subspan(first));
        ASSERT_EQ(hexadecimal(hash.digest()), sha256_of(text)) << first;
    }
}

} // namespace
} // namespace zonegrid
