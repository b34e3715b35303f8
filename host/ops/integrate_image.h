#pragma once

#include "model/rays.h"
#include "ops/device_local_map.h"
#include "ops/growing_buffer.h"

#include <array>

namespace zonegrid::params {
struct FillCellsParams;
struct IntegrateImageParams;
} // namespace zonegrid::params

namespace zonegrid::ops {

/// Draws depth images into a local map on a device (docs/model.md, section 5): equal to
/// reference::integrate_image. Does not walk every ray: docs/filling.md.
class IntegrateImage {
public:
    /// `device` lives longer.
    explicit IntegrateImage(device::Device& device,
                            std::uint32_t group_items = device::default_group_items);

    /// Draws without waiting. `local_map` holds at least `reached_zones(rays)`, and nothing is
    /// drawn in it yet. Throws CapacityError beyond 2^32 sub-rays.
    void dispatch(const ImageRays& rays, const DeviceLocalMap& local_map);

private:
    /// Fills the cells that need no walk, and finds what that spares each tile of pixels.
    void fill(const ImageRays& rays, const DeviceLocalMap& local_map,
              const params::FillCellsParams& to_fill, params::IntegrateImageParams params);

    device::Device& device_;
    device::Kernel deepen_windows_;
    device::Kernel fill_cells_;
    device::Kernel draw_near_;
    device::Kernel skip_tiles_;
    device::Kernel draw_rays_;
    GrowingBuffer depths_;
    GrowingBuffer directions_;
    GrowingBuffer windows_;
    std::array<GrowingBuffer, 3> skips_; ///< of wide, smaller and smallest tiles
};

} // namespace zonegrid::ops
