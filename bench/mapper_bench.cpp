#include "zonegrid/mapper.h"

#include "device/device.h"
#include "field_scene.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace zonegrid::bench {
namespace {

/// The whole job: images of the field scene from a vehicle that flies on, as a recording would give
/// them, and the objects after the last one.
class Flight {
public:
    static constexpr int images = 10;

    Flight(double cell_m, const std::string& backend) : scene_(make_field_scene()) {
        options_.cell_m = cell_m;
        options_.backend = backend;
        scene_.camera.body_from_camera = scene_.world_from_camera;
        scene_.camera.body_from_camera.translation().setZero();
    }

    [[nodiscard]] Mapper mapper() const { return Mapper(options_, scene_.camera); }

    /// Adds the images; returns the seconds of each stage.
    std::map<std::string, double> fly(Mapper& mapper, double start_s) const {
        std::map<std::string, double> stages;
        for (int image = 0; image < images; ++image) {
            const double time_s = start_s + image / 30.0;
            NavigationSample sample;
            sample.time_s = time_s;
            sample.position_m = scene_.world_from_camera.translation();
            sample.position_m.x() += 10.0 * time_s; // 10 m/s ahead
            mapper.add_navigation(sample);
            const auto result = mapper.add_image({time_s, scene_.depth_m});
            stages["prepare_ms"] += 1e3 * (result.prepare_s + result.window_s) / images;
            stages["integrate_ms"] += 1e3 * result.integrate_s / images;
            stages["fuse_ms"] += 1e3 * result.fuse_s / images;
        }
        return stages;
    }

private:
    FieldScene scene_;
    MapperOptions options_;
};

double cell_m_of(const benchmark::State& state) {
    return static_cast<double>(state.range(0)) / 100.0;
}

/// Time of ten images; the stages' are those of one.
void map_flight(benchmark::State& state, const std::string& backend) {
    const Flight flight(cell_m_of(state), backend);
    Mapper mapper = flight.mapper();
    double start_s = 0.0;
    static_cast<void>(flight.fly(mapper, start_s)); // memory is taken, kernels are built
    std::map<std::string, double> stages;
    for (auto _ : state) {
        start_s += 1.0;
        for (const auto& [stage, ms] : flight.fly(mapper, start_s)) {
            stages[stage] += ms;
        }
    }
    for (const auto& [stage, ms] : stages) {
        state.counters[stage] = ms / static_cast<double>(state.iterations());
    }
}

/// Objects after each flight of ten images: what changed is described again.
void describe_objects(benchmark::State& state, const std::string& backend) {
    const Flight flight(cell_m_of(state), backend);
    Mapper mapper = flight.mapper();
    double start_s = 0.0;
    std::size_t objects = 0;
    for (auto _ : state) {
        state.PauseTiming();
        start_s += 1.0;
        static_cast<void>(flight.fly(mapper, start_s));
        state.ResumeTiming();
        objects = mapper.objects().size();
    }
    state.counters["objects"] = static_cast<double>(objects);
}

const bool backends_registered = [] {
    std::vector<std::string> backends{"reference"};
    for (const auto& info : device::list_devices().devices) {
        if (info.refusal.empty()) {
            backends.push_back(info.id());
        }
    }
    const std::map<std::string, void (*)(benchmark::State&, const std::string&)> bodies{
        {"map_flight/", map_flight}, {"describe_objects/", describe_objects}};
    for (const auto& backend : backends) {
        for (const auto& [name, body] : bodies) {
            // As often for all backends: the map grows with every flight.
            benchmark::RegisterBenchmark((name + backend).c_str(), body, backend)
                ->Iterations(10)
                ->ArgName("cell_cm")
                ->Arg(100)
                ->Arg(50)
                ->Arg(25)
                ->Arg(10)
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
        }
    }
    return true;
}();

} // namespace
} // namespace zonegrid::bench
