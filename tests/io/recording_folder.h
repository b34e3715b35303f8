#pragma once

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "zonegrid/errors.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace zonegrid::testing {

/// A folder of its own for one test, removed at its end.
class RecordingFolder {
public:
    /// `name` is the last part of its path, which some layouts look at.
    explicit RecordingFolder(const std::string& name = "recording");

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    // Each writes one file, creates its folders and returns its path.
    std::filesystem::path write(const std::string& name, std::string_view text) const;
    std::filesystem::path write_floats(const std::string& name,
                                       std::span<const float> values) const;
    /// 16-bit grey, width * (values.size() / width).
    std::filesystem::path write_depth(const std::string& name, int width_px,
                                      std::span<const std::uint16_t> values) const;
    /// 8 bits a channel, grey or RGB, all black.
    std::filesystem::path write_8_bit(const std::string& name, int width_px, int height_px,
                                      bool in_colour) const;
    /// NPY version 1 with the given header entries, e.g. "'<f4'" and "(2, 3)".
    std::filesystem::path write_npy(const std::string& name, const std::string& shape,
                                    std::span<const float> values,
                                    const std::string& type = "'<f4'",
                                    const std::string& fortran_order = "False") const;

    /// The file's bytes, and a copy cut to its first `size` bytes.
    [[nodiscard]] std::string bytes(const std::string& name) const;
    void truncate(const std::string& name, std::size_t size) const;

private:
    TemporaryFolder root_;
    std::filesystem::path path_;
};

/// Matches a callable that throws an InputError whose message holds all the given parts.
template <typename... Parts>
auto refuses(const Parts&... parts) {
    return ::testing::ThrowsMessage<InputError>(::testing::AllOf(::testing::HasSubstr(parts)...));
}

} // namespace zonegrid::testing
