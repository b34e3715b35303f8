#pragma once

#include "model/rays.h"
#include "ops/device_local_map.h"
#include "ops/growing_buffer.h"

#include <vector>

namespace zonegrid::ops {

/// Draws scans into a local map on a device (docs/model.md, section 5): equal to
/// reference::integrate_scan.
class IntegrateScan {
public:
    /// `device` lives longer.
    explicit IntegrateScan(device::Device& device,
                           std::uint32_t group_items = device::default_group_items);

    /// Draws without waiting. `local_map` holds at least `reached_zones(scan)`.
    void dispatch(const ScanRays& scan, const DeviceLocalMap& local_map);

private:
    device::Device& device_;
    device::Kernel kernel_;
    GrowingBuffer rays_;
    std::vector<std::int32_t> words_;
};

} // namespace zonegrid::ops
