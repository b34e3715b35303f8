#pragma once

#include "model/rays.h"
#include "ops/device_local_map.h"

#include <optional>

namespace zonegrid::ops {

/// Draws depth images into a local map on a device (docs/model.md, section 5): equal to
/// reference::integrate_image.
class IntegrateImage {
public:
    /// `device` lives longer.
    explicit IntegrateImage(device::Device& device,
                            std::uint32_t group_items = device::default_group_items);

    /// Draws without waiting. `local_map` holds at least `reached_zones(rays)`.
    void dispatch(const ImageRays& rays, const DeviceLocalMap& local_map);

private:
    device::Device& device_;
    device::Kernel kernel_;
    std::optional<device::Buffer> depths_;
    std::optional<device::Buffer> directions_;
};

} // namespace zonegrid::ops
