#include "simulation/simulation.h"

#include "io/depth_png_writer.h"
#include "io/output_file.h"
#include "simulation/stereo_sensor.h"
#include "truth/ray_caster.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace zonegrid {
namespace {

std::filesystem::path image_name(std::size_t index) {
    return fmt::format("depth/{:06}.png", index + 1);
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    if (error) {
        throw OutputError(
            fmt::format("{}: the folder cannot be made ({}); check permissions and space",
                        folder.string(), error.message()));
    }
}

/// Calls `work(i)` for i below `count` on all cores; the first exception comes out.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::mutex guard;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) {
                work(i);
            }
        } catch (...) {
            next = count;
            const std::scoped_lock lock(guard);
            failure = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
        for (std::size_t i = 1; i < std::min(cores, count); ++i) {
            others.emplace_back(run);
        }
        run();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

/// Draws images one after the other, each on all cores.
class Painter {
public:
    Painter(const Scene& scene, const SimulatedFlight& flight)
        : scene_(scene), flight_(flight), caster_(flight.truth.surfaces, flight.truth.motions) {}

    [[nodiscard]] Exposure draw(std::uint64_t number) {
        const auto pixels = static_cast<std::size_t>(scene_.camera.width_px) *
                            static_cast<std::size_t>(scene_.camera.height_px);
        Exposure exposure{std::vector<float>(pixels), std::vector<std::uint32_t>(pixels)};
        const TrueImage& image = flight_.taken[number];
        caster_.move_to(image.time_s);
        caster_.draw(scene_.camera, image.world_from_camera, exposure.depth_m, exposure.obstacles);
        return exposure;
    }

private:
    const Scene& scene_;
    const SimulatedFlight& flight_;
    RayCaster caster_;
};

void write_image(const std::filesystem::path& file, const Camera& camera,
                 std::span<const float> depth_m) {
    DepthPng image;
    image.size = {camera.width_px, camera.height_px};
    image.values.resize(depth_m.size());
    std::ranges::transform(depth_m, image.values.begin(), depth_value);
    OutputFile output(file);
    output.write(encode_depth_png(image));
    output.close();
}

void write_images(const std::filesystem::path& folder, const Scene& scene,
                  const SimulationOptions& options, const SimulatedFlight& flight,
                  const StereoSensor& sensor, const std::function<void(std::uint64_t)>& observe) {
    Painter painter(scene, flight);
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t batch = 2 * cores;
    const bool mixes = options.sensor.screen_px > 0.0;
    std::optional<std::uint64_t> last_number;
    Exposure last;
    for (std::size_t first = 0; first < flight.numbers.size(); first += batch) {
        const std::size_t count = std::min(batch, flight.numbers.size() - first);
        std::vector<Exposure> exposures(count);
        std::vector<Exposure> before(count); // only where exposures are mixed
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t number = flight.numbers[first + i];
            exposures[i] = painter.draw(number);
            if (mixes) {
                const std::uint64_t earlier = number == 0 ? 0 : number - 1;
                before[i] = last_number == earlier ? last : painter.draw(earlier);
                last = exposures[i];
                last_number = number;
            }
        }
        on_all_cores(count, [&](std::size_t i) {
            const std::vector<float> depth_m =
                sensor.see(flight.numbers[first + i], exposures[i], before[i]);
            write_image(folder / image_name(first + i), scene.camera, depth_m);
        });
        if (observe) {
            observe(first + count);
        }
    }
}

std::vector<FrameEntry> frames_of(const SimulatedFlight& flight) {
    std::vector<FrameEntry> frames;
    for (std::size_t i = 0; i < flight.image_times_s.size(); ++i) {
        frames.push_back({flight.image_times_s[i], image_name(i), ""});
    }
    return frames;
}

PlainSensor description_of(const Scene& scene, const SimulationOptions& options,
                           const StereoSensor& sensor) {
    PlainSensor description;
    description.camera = scene.camera;
    description.camera->stereo = sensor.noise();
    description.mounting = mounting_of(scene.camera.body_from_camera);
    description.coding = DepthCoding{simulated_units_per_m, DepthKind::axis, {0.0F}, {65535.0F}};
    const std::string faults = fault_arguments(options);
    description.comments = {fmt::format("Simulated: scene {}, seed {}.", scene.name, options.seed),
                            faults.empty() ? "Faults: none." : fmt::format("Faults: {}", faults)};
    return description;
}

} // namespace

void write_simulation(const std::filesystem::path& folder, const Scene& scene,
                      const SimulationOptions& options, const SimulatedFlight& flight,
                      const std::function<void(std::uint64_t)>& observe) {
    const StereoSensor sensor(scene.camera, scene.texture, options.sensor, options.seed);
    make_folder(folder / "truth");
    write_truth(folder / "truth", flight.truth);
    PlainSensor description = description_of(scene, options, sensor);
    description.truth_digest = digest_of_truth(folder / "truth");
    write_plain_description(folder / "description.toml", description);
    write_navigation_csv(folder / "navigation.csv", flight.navigation);
    write_frames_csv(folder / "frames.csv", frames_of(flight));
    make_folder(folder / "depth");
    write_images(folder, scene, options, flight, sensor, observe);
}

} // namespace zonegrid
