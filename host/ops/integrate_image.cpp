#include "ops/integrate_image.h"

#include "kernels/params/integrate_image.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace zonegrid::ops {

namespace {

using params::DeepenWindowsParams;
using params::FillCellsParams;
using params::IntegrateImageParams;
static_assert(sizeof(DeepenWindowsParams) <= device::max_params_bytes);
static_assert(sizeof(FillCellsParams) <= device::max_params_bytes);
static_assert(sizeof(IntegrateImageParams) <= device::max_params_bytes);

// The kernels read these as two and three words.
static_assert(sizeof(PixelDepth) == 8 && sizeof(Direction) == 12);

/// A tile takes long; small groups spread the few of them over all of a device.
constexpr std::uint32_t tile_group_items = 16;

/// draw_near walks a ray of each tile of this size (a window's level: 8 pixels).
constexpr std::int32_t near_level = 3;

/// skip_tiles goes from wide tiles to small ones, the more often the wider the tile.
constexpr std::int32_t least_tile_level = 2;
constexpr std::array<std::pair<std::int32_t, std::int32_t>, 3> tile_passes{{
    {5, 8 * ZG_SUB_PER_CELL}, // size of a tile, most that it goes ahead at once
    {3, 4 * ZG_SUB_PER_CELL},
    {least_tile_level, 2 * ZG_SUB_PER_CELL},
}};

template <class Params>
std::span<const std::byte> bytes_of(const Params& params) {
    return std::as_bytes(std::span(&params, 1));
}

std::uint64_t window_count(std::int32_t pixels, std::int32_t level) {
    const std::int32_t stride = level < 2 ? 1 : 1 << (level - 1);
    return static_cast<std::uint64_t>((pixels + stride - 1) / stride);
}

std::uint32_t tile_count(const ImageRays& rays, std::int32_t level) {
    const auto along = [level](std::int32_t pixels) {
        return static_cast<std::uint32_t>((pixels + (1 << level) - 1) >> level);
    };
    return along(rays.width_px) * along(rays.height_px);
}

/// How often the pixel that is split most is split on each axis, as a power of two.
std::int32_t most_split(const ImageRays& rays) {
    std::int32_t deepest = 0;
    for (const auto& depth : rays.depths) {
        deepest = std::max(deepest, depth.near < 0 ? 0 : std::max(depth.near, depth.far));
    }
    std::int32_t level = 0;
    while (rays.spanned && level < ZG_MAX_SPLIT_LEVEL && rays.spacing << level < deepest) {
        ++level;
    }
    return level;
}

Eigen::Vector3d as_vector(const Direction& direction) {
    return Eigen::Vector3d(direction.x, direction.y, direction.z) /
           static_cast<double>(1 << ZG_DIRECTION_BITS);
}

/// Arguments of fill_cells for a camera whose pixels can be told from a point in space, else
/// nothing.
std::optional<FillCellsParams> fill_params(const ImageRays& rays, const DeviceLocalMap& local_map) {
    if (!rays.directions.empty()) {
        return std::nullopt;
    }
    const Eigen::Vector3d u = as_vector(rays.u);
    const Eigen::Vector3d v = as_vector(rays.v);
    Eigen::Matrix3d directions;
    directions << u, v, as_vector(rays.a);
    const Eigen::Matrix3d rows = directions.inverse();
    // The last row is the optical axis but for the rounding of U, V and A.
    if (!rows.allFinite() || rows.row(2).norm() > 1.5) {
        return std::nullopt;
    }
    FillCellsParams params{};
    params.local_map = local_map.params();
    params.zones = local_map.zone_count();
    params.width_px = rays.width_px;
    params.height_px = rays.height_px;
    params.origin[0] = rays.origin.x;
    params.origin[1] = rays.origin.y;
    params.origin[2] = rays.origin.z;
    for (Eigen::Index i = 0; i < 3; ++i) {
        for (Eigen::Index j = 0; j < 3; ++j) {
            params.rows[3 * i + j] = static_cast<float>(rows(i, j));
        }
        params.right[i] = static_cast<float>(std::abs(u[i]));
        params.down[i] = static_cast<float>(std::abs(v[i]));
    }
    for (const auto& depth : rays.depths) {
        params.deepest = std::max(params.deepest, depth.near);
    }
    const double most_px = std::max(rays.width_px, rays.height_px);
    const double rounding =
        (std::max(rows.row(0).norm(), rows.row(1).norm()) + 2.0 * most_px) / 65536.0;
    // A sub-ray leaves its pixel's centre by half a pixel.
    params.slack_px = static_cast<float>(rounding + (most_split(rays) > 0 ? 0.5 : 0.0));
    return params;
}

} // namespace

IntegrateImage::IntegrateImage(device::Device& device, std::uint32_t group_items)
    : device_(device),
      deepen_windows_(device.make_kernel(
          {"integrate_image", "deepen_windows", 2, sizeof(DeepenWindowsParams), group_items})),
      fill_cells_(device.make_kernel(
          {"integrate_image", "fill_cells", 3, sizeof(FillCellsParams), group_items})),
      draw_near_(device.make_kernel(
          {"integrate_image", "draw_near", 4, sizeof(IntegrateImageParams), tile_group_items})),
      skip_tiles_(device.make_kernel(
          {"integrate_image", "skip_tiles", 6, sizeof(IntegrateImageParams), tile_group_items})),
      draw_rays_(device.make_kernel(
          {"integrate_image", "draw_rays", 6, sizeof(IntegrateImageParams), group_items})),
      depths_(device),
      directions_(device),
      windows_(device),
      skips_{GrowingBuffer(device), GrowingBuffer(device), GrowingBuffer(device)} {}

void IntegrateImage::dispatch(const ImageRays& rays, const DeviceLocalMap& local_map) {
    depths_.upload(std::span(rays.depths));
    directions_.upload(std::span(rays.directions));
    skips_.back().reserve(tile_count(rays, least_tile_level) * sizeof(std::int32_t));
    IntegrateImageParams params{local_map.params(),
                                rays.width_px,
                                rays.height_px,
                                {rays.origin.x, rays.origin.y, rays.origin.z},
                                {rays.a.x, rays.a.y, rays.a.z},
                                {rays.u.x, rays.u.y, rays.u.z},
                                {rays.v.x, rays.v.y, rays.v.z},
                                rays.directions.empty() ? 0U : 1U,
                                rays.spanned ? 1U : 0U,
                                rays.spacing,
                                most_split(rays),
                                0,
                                0,
                                0};
    if (const auto to_fill = fill_params(rays, local_map)) {
        fill(rays, local_map, *to_fill, params);
        params.tile_level = least_tile_level;
    }
    const std::uint64_t sub_rays = rays.depths.size() << (2 * params.most_split);
    if (sub_rays > std::numeric_limits<std::uint32_t>::max()) {
        throw CapacityError(
            fmt::format("an image of {} x {} pixels has {} sub-rays at this cell "
                        "size: choose larger cells or a smaller image",
                        rays.width_px, rays.height_px, sub_rays));
    }
    const auto map = local_map.bindings();
    const std::array<const device::Buffer*, 6> bindings{
        map[0], map[1], map[2], &depths_.get(), &directions_.get(), &skips_.back().get()};
    device_.dispatch(draw_rays_, bindings, bytes_of(params),
                     draw_rays_.groups_for(static_cast<std::uint32_t>(sub_rays)));
}

void IntegrateImage::fill(const ImageRays& rays, const DeviceLocalMap& local_map,
                          const FillCellsParams& to_fill, IntegrateImageParams params) {
    // 1. The deepest pixel of each window.
    std::uint64_t windows = 0;
    for (std::int32_t level = 0; level < ZG_WINDOW_LEVELS; ++level) {
        windows += window_count(rays.width_px, level) * window_count(rays.height_px, level);
    }
    windows_.reserve(windows * sizeof(std::int32_t));
    for (std::int32_t level = 0; level < ZG_WINDOW_LEVELS; ++level) {
        const DeepenWindowsParams to_deepen{rays.width_px, rays.height_px, level};
        const auto parts =
            (window_count(rays.width_px, level) + ZG_WINDOWS_AN_ITEM - 1) / ZG_WINDOWS_AN_ITEM;
        const auto items = parts * window_count(rays.height_px, level);
        const std::array<const device::Buffer*, 2> bindings{&depths_.get(), &windows_.get()};
        device_.dispatch(deepen_windows_, bindings, bytes_of(to_deepen),
                         deepen_windows_.groups_for(static_cast<std::uint32_t>(items)));
    }

    // 2. The cells that can be told by asking windows, and those beside the camera.
    const auto map = local_map.bindings();
    const std::array<const device::Buffer*, 3> to_fill_bindings{map[0], &local_map.places(),
                                                                &windows_.get()};
    device_.dispatch(fill_cells_, to_fill_bindings, bytes_of(to_fill), to_fill.zones);
    params.tile_level = near_level;
    const std::array<const device::Buffer*, 4> near_bindings{map[0], map[1], map[2],
                                                             &depths_.get()};
    device_.dispatch(draw_near_, near_bindings, bytes_of(params),
                     draw_near_.groups_for(tile_count(rays, near_level)));

    // 3. What that spares the tiles: wide ones first, which the others go on from.
    params.wide_level = 0;
    for (std::size_t pass = 0; pass < tile_passes.size(); ++pass) {
        std::tie(params.tile_level, params.slice) = tile_passes[pass];
        const auto tiles = tile_count(rays, params.tile_level);
        skips_[pass].reserve(tiles * sizeof(std::int32_t));
        const auto& wide_skips = pass == 0 ? skips_.back() : skips_[pass - 1];
        const std::array<const device::Buffer*, 6> bindings{
            map[0], map[1], map[2], &windows_.get(), &wide_skips.get(), &skips_[pass].get()};
        device_.dispatch(skip_tiles_, bindings, bytes_of(params), skip_tiles_.groups_for(tiles));
        params.wide_level = params.tile_level;
    }
}

} // namespace zonegrid::ops
