#include "reference/integrate_image.h"

#include "field_scene.h"
#include "model/segment_walk.h"
#include "ops/integrate_image.h"
#include "ops/reached_zones.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace zonegrid::bench {
namespace {

/// The field scene as integers, on its window.
struct Field {
    Field(double cell_m, SensorModel model) : scene(make_field_scene()), window(32, 1, 1) {
        MapperOptions options;
        options.cell_m = cell_m;
        options.model = model;
        scene.camera.stereo = StereoNoise{0.30, 0.25};
        window = make_window(options, scene.camera);
        window.move_to(*cell_of(scene.world_from_camera.translation(), cell_m));
        ImageQuantizer(scene.camera, options)
            .quantize(scene.depth_m, scene.world_from_camera, window, rays);
    }

    FieldScene scene;
    Window window;
    ImageRays rays;
};

/// The walk of docs/model.md, section 4, with nothing around it: one dense array over the whole
/// window, one byte a cell. What the zoned local map is measured against.
class DenseWalk {
public:
    explicit DenseWalk(const Window& window)
        : edge_(window.edge_cells()),
          statements_(static_cast<std::size_t>(edge_) * static_cast<std::size_t>(edge_) *
                      static_cast<std::size_t>(edge_)) {}

    void draw(const ImageRays& rays) {
        for_each_pixel(rays, [&](const Direction& direction, const PixelDepth& depth) {
            walk(rays.origin, rays.point_at(direction, depth.near));
        });
        for_each_pixel(rays, [&](const Direction& direction, const PixelDepth& depth) {
            if (depth.far >= 0) {
                const SubPoint end = rays.point_at(direction, depth.far);
                statements_[index_of(end)] = ZG_STATEMENT_OCCUPIED;
            }
        });
    }

    [[nodiscard]] std::size_t count(std::uint8_t statement) const {
        std::size_t found = 0;
        for (const auto cell : statements_) {
            found += cell == statement ? 1U : 0U;
        }
        return found;
    }

private:
    template <class Visit>
    static void for_each_pixel(const ImageRays& rays, Visit&& visit) {
        std::size_t pixel = 0;
        for (std::int32_t v_px = 0; v_px < rays.height_px; ++v_px) {
            for (std::int32_t u_px = 0; u_px < rays.width_px; ++u_px, ++pixel) {
                if (rays.depths[pixel].near >= 0) {
                    visit(rays.direction(u_px, v_px), rays.depths[pixel]);
                }
            }
        }
    }

    [[nodiscard]] std::size_t index_of(const SubPoint& point) const {
        const auto cell = [](std::int32_t sub) {
            return static_cast<std::size_t>(sub >> ZG_SUB_BITS);
        };
        const auto edge = static_cast<std::size_t>(edge_);
        return (cell(point.z) * edge + cell(point.y)) * edge + cell(point.x);
    }

    void walk(const SubPoint& start, const SubPoint& end) {
        struct Pen {
            std::uint8_t* cell;
            std::ptrdiff_t step_x;
            std::ptrdiff_t step_y;
            std::ptrdiff_t step_z;
            std::int32_t left;
            void cross_x() { cell += step_x; }
            void cross_y() { cell += step_y; }
            void cross_z() { cell += step_z; }
            bool arrive() {
                if (--left < 0) {
                    return false;
                }
                *cell = ZG_STATEMENT_FREE;
                return true;
            }
        };
        const Segment segment(start, end);
        const std::ptrdiff_t edge = edge_;
        std::uint8_t* const first = statements_.data() + index_of(start);
        *first = ZG_STATEMENT_FREE;
        walk_segment(segment, Pen{first, segment.x.sign, segment.y.sign * edge,
                                  segment.z.sign * edge * edge, segment.crossings()});
    }

    std::int32_t edge_;
    std::vector<std::uint8_t> statements_;
};

std::size_t count(const LocalMap& local_map, std::uint8_t statement) {
    const auto edge = static_cast<std::size_t>(local_map.window().zone_edge());
    std::vector<std::uint8_t> statements(edge * edge * edge);
    std::size_t found = 0;
    for (const auto place : local_map.zones()) {
        local_map.copy_zone(place, statements);
        found += static_cast<std::size_t>(std::ranges::count(statements, statement));
    }
    return found;
}

double cell_m_of(const benchmark::State& state) {
    return static_cast<double>(state.range(0)) / 100.0;
}

/// Reference and dense walk must say the same of the same number of cells.
std::string problem_with(const Field& field) {
    LocalMap local_map(field.window);
    reference::integrate_image(field.rays, local_map);
    DenseWalk dense(field.window);
    dense.draw(field.rays);
    for (const auto statement :
         {std::uint8_t{ZG_STATEMENT_FREE}, std::uint8_t{ZG_STATEMENT_OCCUPIED}}) {
        if (count(local_map, statement) != dense.count(statement)) {
            return "the zoned and the dense walk disagree";
        }
    }
    return "";
}

void integrate_image_dense_walk(benchmark::State& state) {
    const Field field(cell_m_of(state), SensorModel::line);
    if (const auto problem = problem_with(field); !problem.empty()) {
        state.SkipWithError(problem.c_str());
        return;
    }
    DenseWalk dense(field.window);
    for (auto _ : state) {
        dense.draw(field.rays);
    }
}

void integrate_image_reference(benchmark::State& state, SensorModel model) {
    const Field field(cell_m_of(state), model);
    LocalMap local_map(field.window);
    for (auto _ : state) {
        local_map.clear();
        reference::integrate_image(field.rays, local_map);
    }
    state.counters["zones"] = static_cast<double>(local_map.zones().size());
}

/// Cells that a device's local map says are free and occupied.
std::array<std::size_t, 2> count_on(device::Device& device, const ops::DeviceLocalMap& local_map,
                                    std::size_t zones, std::uint32_t plane_words) {
    std::vector<std::uint32_t> words((zones + 1) * 2 * plane_words);
    device.download(local_map.planes(), 0, std::as_writable_bytes(std::span(words)));
    std::array<std::size_t, 2> found{};
    for (std::size_t slot = 1; slot <= zones; ++slot) {
        for (std::size_t i = 0; i < plane_words; ++i) {
            const auto free = words[2 * slot * plane_words + i];
            const auto occupied = words[(2 * slot + 1) * plane_words + i];
            found[0] += static_cast<std::size_t>(std::popcount(free & ~occupied));
            found[1] += static_cast<std::size_t>(std::popcount(occupied));
        }
    }
    return found;
}

/// Everything that a device needs for an image's local map: the zones it may reach, upload, kernel.
void integrate_image_device(benchmark::State& state, const std::string& name, SensorModel model) {
    const Field field(cell_m_of(state), model);
    LocalMap expected(field.window);
    reference::integrate_image(field.rays, expected);
    const auto device = device::open_device(name, {.timestamps = true, .unified_memory = true});
    ops::IntegrateImage operation(*device);
    ops::DeviceLocalMap local_map(*device, field.window);
    std::size_t zones = 0;
    const auto integrate = [&] {
        const auto places = ops::reached_zones(field.rays, field.window);
        zones = places.size();
        local_map.reserve(places);
        operation.dispatch(field.rays, local_map);
        local_map.check();
    };
    integrate();
    const auto found = count_on(*device, local_map, zones, local_map.params().plane_words);
    if (found[0] != count(expected, ZG_STATEMENT_FREE) ||
        found[1] != count(expected, ZG_STATEMENT_OCCUPIED)) {
        state.SkipWithError("the device and the reference disagree");
        return;
    }
    static_cast<void>(device->take_times());
    for (auto _ : state) {
        integrate();
    }
    std::map<std::string, double> kernel_s;
    for (const auto& time : device->take_times()) {
        kernel_s["kernels"] += time.seconds;
        kernel_s[time.kernel.substr(time.kernel.find('.') + 1)] += time.seconds;
    }
    for (const auto& [kernel, seconds] : kernel_s) {
        state.counters[kernel + "_ms"] = 1e3 * seconds / static_cast<double>(state.iterations());
    }
    state.counters["zones_reserved"] = static_cast<double>(zones);
}

void walk_sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("cell_cm")->Arg(100)->Arg(50)->Arg(25)->Arg(10)->Unit(
        benchmark::kMillisecond);
}

BENCHMARK(integrate_image_dense_walk)->Apply(walk_sizes);
BENCHMARK_CAPTURE(integrate_image_reference, line, SensorModel::line)->Apply(walk_sizes)->Arg(5);
BENCHMARK_CAPTURE(integrate_image_reference, span, SensorModel::span)->Apply(walk_sizes);

/// Devices are known only when the program runs.
const bool devices_registered = [] {
    for (const auto& info : device::list_devices().devices) {
        if (info.refusal.empty()) {
            for (const auto& [name, model] :
                 {std::pair{"line", SensorModel::line}, std::pair{"span", SensorModel::span}}) {
                benchmark::RegisterBenchmark(
                    ("integrate_image_device/" + info.id() + "/" + name).c_str(),
                    integrate_image_device, info.id(), model)
                    ->Apply(walk_sizes)
                    ->UseRealTime();
            }
        }
    }
    return true;
}();

} // namespace
} // namespace zonegrid::bench
