#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace zonegrid::testing {

/// How a command ended.
struct CommandResult {
    int exit_code = 0; ///< as a shell gives it: 128 + n after signal n
    std::string output;
    std::string errors;
};

/// A recording of the poses layout that the tests vary: a camera of 32 x 24 pixels drives 10 cm an
/// image towards a wall with a box before it.
struct SmallRecording {
    static constexpr int width_px = 32;
    static constexpr int height_px = 24;

    std::size_t images = 8;
    int units_per_m = 1000;
    std::string folder = "recording";
    /// Camera-to-world, optical axes, as 16 numbers; by default 0.1 m forward an image.
    std::function<std::vector<double>(std::size_t image)> pose = forward;
    /// Depth of a pixel in metres; 0 is missing.
    std::function<double(std::size_t image, int u, int v)> depth_m = wall_and_box;

    static std::vector<double> forward(std::size_t image);
    static double wall_and_box(std::size_t image, int u, int v);
};

/// A folder for one test, in which the real command runs.
class CommandTest : public ::testing::Test {
protected:
    /// Runs a line of shell in the folder; `zonegrid` is the command under test.
    [[nodiscard]] CommandResult run(const std::string& shell_line) const;

    void write_recording(const SmallRecording& recording = {}) const;
    void write_file(const std::string& name, const std::string& text) const;
    [[nodiscard]] std::string read_file(const std::string& name) const;
    [[nodiscard]] nlohmann::json read_json(const std::string& name) const;
    [[nodiscard]] bool exists(const std::string& name) const;
    /// Names in the folder, sorted, without the files in which `run` catches output.
    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] std::filesystem::path path(const std::string& name) const;

private:
    TemporaryFolder folder_;
};

/// Matches errors that are exactly one line "zonegrid: ..." with all the given parts.
template <typename... Parts>
auto one_line_with(const Parts&... parts) {
    return ::testing::AllOf(::testing::MatchesRegex("zonegrid: [^\n]*\n"),
                            ::testing::HasSubstr(parts)...);
}

} // namespace zonegrid::testing
