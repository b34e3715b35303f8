#include "io/npy.h"
#include "simulation/scene_keys.h"
#include "simulation/scene_tables.h"
#include "zonegrid/errors.h"

#include <cmath>
#include <utility>

namespace zonegrid {
namespace {

constexpr Span grid_limits{0.05, 1000.0};
constexpr double flat_spacing_m = 20.0; // small enough that a place finds its own triangles
constexpr double hill_spacing_m = 5.0;
constexpr float highest_m = 10000.0F;

Span read_extent(DescriptionTable& table, std::string_view key) {
    const std::optional<Span> extent = read_span(table, key, place_limits);
    if (!extent) {
        table.refuse_absent(key);
    }
    if (!(extent->low < extent->high)) {
        table.refuse(key, "is no extent", "give [least, most] in metres");
    }
    return *extent;
}

HeightGrid read_heights(DescriptionTable& table, const std::filesystem::path& file) {
    const Span north = read_extent(table, "north_m");
    const Span east = read_extent(table, "east_m");
    NpyArray array = read_npy(file);
    if (array.shape.size() != 2 || array.shape[0] < 2 || array.shape[1] < 2) {
        throw InputError(file.string(), "the heights are no table of at least 2 x 2",
                         "give one height per node: rows to the north, columns to the east");
    }
    for (const float height : array.values) {
        if (!std::isfinite(height)) {
            throw InputError(file.string(), "a height is not finite", "give each node a height");
        }
        if (std::abs(height) > highest_m) {
            throw InputError(file.string(), fmt::format("a height is {} m", height),
                             fmt::format("give heights in metres, -{0} to {0}", highest_m));
        }
    }
    return {{north.low, east.low},
            {north.high, east.high},
            array.shape[0],
            array.shape[1],
            std::move(array.values)};
}

} // namespace

GroundPlan read_ground(DescriptionTable& root, const std::filesystem::path& folder,
                       std::uint64_t seed) {
    std::optional<DescriptionTable> ground = root.table("ground");
    std::optional<DescriptionTable> terrain = root.table("terrain");
    if (ground && terrain) {
        root.refuse("terrain", "comes beside [ground]",
                    "describe the ground once: [ground] is flat, [terrain] is not");
    }
    GroundPlan plan{Terrain(flat_spacing_m), ground || terrain};
    if (ground) {
        plan.place = ground->place();
        plan.texture = read_texture(*ground);
        plan.terrain = Terrain(read_number(*ground, "spacing_m", grid_limits, flat_spacing_m));
        ground->require_all_read();
    }
    if (terrain) {
        plan.place = terrain->place();
        plan.texture = read_texture(*terrain);
        if (const std::optional<std::string> heights = terrain->text("heights")) {
            plan.terrain = Terrain(read_heights(*terrain, folder / *heights));
        } else {
            HillNoise noise;
            noise.relief_m = read_number(*terrain, "relief_m", {0.0, 1000.0});
            noise.wavelength_m = read_number(*terrain, "wavelength_m", {1.0, 1e5});
            noise.octaves = terrain->number("octaves") ? read_count(*terrain, "octaves", 1, 8) : 3;
            noise.seed =
                static_cast<std::uint64_t>(numbers_of(seed, Draw::terrain, 0).whole(0, 1 << 30));
            plan.terrain =
                Terrain(read_number(*terrain, "spacing_m", grid_limits, hill_spacing_m), noise);
        }
        terrain->require_all_read();
    }
    return plan;
}

} // namespace zonegrid
