#pragma once

#include "device/sha256.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zonegrid::device {

/// Which compiled kernel: a digest over all that its machine code depends on.
class KernelKey {
public:
    /// Each is told apart from its neighbours: "ab", "c" gives another key than "a", "bc".
    KernelKey& add(std::string_view text);
    KernelKey& add(std::span<const std::byte> bytes);

    [[nodiscard]] Sha256::Digest digest() const;

private:
    Sha256 hash_;
};

/// Compiled kernels in files between runs, one a file. Nothing that goes wrong with a file or the
/// folder is an error: then the kernel is compiled once more. Safe for several threads and
/// processes at once: a file appears whole, by being renamed.
///
/// A file: magic, version, key, length and SHA-256 of what follows, then that. One that is damaged,
/// cut short, of another key, or of another user than this one or root is not used.
class KernelCache {
public:
    /// Keeps nothing.
    KernelCache() = default;
    explicit KernelCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The folder that ZONEGRID_CACHE_DIR names, else $XDG_CACHE_HOME/zonegrid, else
    /// ~/.cache/zonegrid; none if ZONEGRID_CACHE_DIR is set to nothing.
    [[nodiscard]] static KernelCache of_user();

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    /// What was kept under the key, if anything is, and whole.
    [[nodiscard]] std::optional<std::vector<std::byte>> find(const KernelKey& key) const;

    /// Keeps `bytes`, if it can, in place of what was kept under the key before.
    void keep(const KernelKey& key, std::span<const std::byte> bytes) const;

    /// Where that is, or would be.
    [[nodiscard]] std::filesystem::path file_of(const KernelKey& key) const;

private:
    std::filesystem::path folder_; ///< empty: there is none
};

} // namespace zonegrid::device
