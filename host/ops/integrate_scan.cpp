#include "ops/integrate_scan.h"

#include "kernels/params/integrate_scan.h"

#include <array>
#include <span>

namespace zonegrid::ops {

using params::IntegrateScanParams;

IntegrateScan::IntegrateScan(device::Device& device, std::uint32_t group_items)
    : device_(device),
      kernel_(device.make_kernel(
          {"integrate_scan", "integrate_scan", 4, sizeof(IntegrateScanParams), group_items})),
      rays_(device) {}

void IntegrateScan::dispatch(const ScanRays& scan, const DeviceLocalMap& local_map) {
    if (scan.rays.empty()) {
        return;
    }
    words_.clear();
    for (const auto& ray : scan.rays) {
        words_.insert(words_.end(), {ray.start.x, ray.start.y, ray.start.z, ray.end.x, ray.end.y,
                                     ray.end.z, ray.hit ? 1 : 0});
    }
    const auto& rays = rays_.upload(std::span<const std::int32_t>(words_));
    const IntegrateScanParams params{local_map.params(),
                                     static_cast<std::uint32_t>(scan.rays.size())};
    const auto map = local_map.bindings();
    const std::array<const device::Buffer*, 4> bindings{map[0], map[1], map[2], &rays};
    device_.dispatch(kernel_, bindings, std::as_bytes(std::span(&params, 1)),
                     kernel_.groups_for(params.rays));
}

} // namespace zonegrid::ops
