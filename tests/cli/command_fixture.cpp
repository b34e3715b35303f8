#include "cli/command_fixture.h"

#include <fmt/format.h>
#include <png.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace zonegrid::testing {
namespace {

constexpr double focal_px = 24.0;

void write_depth_png(const std::filesystem::path& file, const SmallRecording& recording,
                     std::size_t image) {
    std::vector<std::uint16_t> pixels;
    for (int v = 0; v < SmallRecording::height_px; ++v) {
        for (int u = 0; u < SmallRecording::width_px; ++u) {
            pixels.push_back(static_cast<std::uint16_t>(
                std::lround(recording.depth_m(image, u, v) * recording.units_per_m)));
        }
    }
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = SmallRecording::width_px;
    png.height = SmallRecording::height_px;
    png.format = PNG_FORMAT_LINEAR_Y;
    if (png_image_write_to_file(&png, file.c_str(), 0, pixels.data(), 0, nullptr) == 0) {
        throw std::runtime_error(png.message);
    }
}

} // namespace

std::vector<double> SmallRecording::forward(std::size_t image) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.1 * static_cast<double>(image), 0, 0, 0, 1};
}

double SmallRecording::wall_and_box(std::size_t image, int u, int v) {
    const bool box = u >= 8 && u < 16 && v >= 8 && v < 16;
    if (u == 0 && v == 0) {
        return 0.0;
    }
    return (box ? 3.0 : 5.0) - 0.1 * static_cast<double>(image);
}

CommandResult CommandTest::run(const std::string& shell_line) const {
    const std::string script =
        fmt::format("cd '{}' || exit 99\nzonegrid() {{ '{}' \"$@\"; }}\n{}\n",
                    folder_.path().string(), ZONEGRID_COMMAND, shell_line);
    write_file("run.sh", script);
    const std::string line =
        fmt::format("bash '{0}/run.sh' >'{0}/run.out' 2>'{0}/run.err'", folder_.path().string());
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_file("run.out"),
            read_file("run.err")};
}

void CommandTest::write_recording(const SmallRecording& recording) const {
    const std::filesystem::path folder = folder_.path() / recording.folder;
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "camera-intrinsics.txt")
        << fmt::format("{0} 0 {1}\n0 {0} {2}\n0 0 1\n", focal_px,
                       0.5 * SmallRecording::width_px - 0.5, 0.5 * SmallRecording::height_px - 0.5);
    for (std::size_t image = 0; image < recording.images; ++image) {
        const std::string stem = fmt::format("frame-{:06}", image);
        write_depth_png(folder / (stem + ".depth.png"), recording, image);
        const std::vector<double> pose = recording.pose(image);
        std::ofstream stream(folder / (stem + ".pose.txt"));
        for (std::size_t i = 0; i < pose.size(); ++i) {
            stream << fmt::format("{}{}", pose[i], i % 4 == 3 ? "\n" : " ");
        }
    }
}

void CommandTest::write_file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
}

std::string CommandTest::read_file(const std::string& name) const {
    std::ifstream stream(folder_.path() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

nlohmann::json CommandTest::read_json(const std::string& name) const {
    return nlohmann::json::parse(read_file(name));
}

bool CommandTest::exists(const std::string& name) const {
    return std::filesystem::exists(folder_.path() / name);
}

std::vector<std::string> CommandTest::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("run.")) {
            names.push_back(name);
        }
    }
    std::ranges::sort(names);
    return names;
}

std::filesystem::path CommandTest::path(const std::string& name) const {
    return folder_.path() / name;
}

} // namespace zonegrid::testing
