#include "io/sha256.h"

#include "io/hexadecimal.h"

#include <openssl/evp.h>

#include <new>

namespace zonegrid {

struct Sha256::Context {
    Context() : digest(EVP_MD_CTX_new()) {
        if (digest == nullptr || EVP_DigestInit_ex(digest, EVP_sha256(), nullptr) != 1) {
            throw std::bad_alloc(); // all that can go wrong with a built-in digest
        }
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context() { EVP_MD_CTX_free(digest); }

    EVP_MD_CTX* digest;
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::string_view text) {
    EVP_DigestUpdate(context_->digest, text.data(), text.size());
}

void Sha256::add(std::span<const std::uint8_t> bytes) {
    EVP_DigestUpdate(context_->digest, bytes.data(), bytes.size());
}

std::array<std::uint8_t, Sha256::size_bytes> Sha256::finish() {
    std::array<std::uint8_t, size_bytes> sum{};
    EVP_DigestFinal_ex(context_->digest, sum.data(), nullptr);
    return sum;
}

std::string Sha256::finish_hex() {
    return to_hexadecimal(finish());
}

} // namespace zonegrid
