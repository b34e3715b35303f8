#include "ops/integrate_image.h"

#include "kernels/params/integrate_image.h"

#include <algorithm>
#include <array>
#include <span>

namespace zonegrid::ops {

namespace {

using params::IntegrateImageParams;
static_assert(sizeof(IntegrateImageParams) <= device::max_params_bytes);

// The kernel reads these as two and three words.
static_assert(sizeof(PixelDepth) == 8 && sizeof(Direction) == 12);

/// Uploads to a buffer that grows to what it must hold; at least one element, since a kernel's
/// buffers must exist.
template <class Element>
void upload(device::Device& device, std::optional<device::Buffer>& buffer,
            std::span<const Element> elements) {
    const std::uint64_t bytes = std::max(elements.size_bytes(), sizeof(Element));
    if (!buffer || buffer->bytes() < bytes) {
        buffer.emplace(device.make_buffer(bytes));
    }
    if (!elements.empty()) {
        device.upload(*buffer, 0, std::as_bytes(elements));
    }
}

} // namespace

IntegrateImage::IntegrateImage(device::Device& device, std::uint32_t group_items)
    : device_(device),
      kernel_(device.make_kernel(
          {"integrate_image", "integrate_image", 5, sizeof(IntegrateImageParams), group_items})) {}

void IntegrateImage::dispatch(const ImageRays& rays, const DeviceLocalMap& local_map) {
    upload(device_, depths_, std::span(rays.depths));
    upload(device_, directions_, std::span(rays.directions));
    const IntegrateImageParams params{local_map.params(),
                                      rays.width_px,
                                      static_cast<std::uint32_t>(rays.depths.size()),
                                      {rays.origin.x, rays.origin.y, rays.origin.z},
                                      {rays.a.x, rays.a.y, rays.a.z},
                                      {rays.u.x, rays.u.y, rays.u.z},
                                      {rays.v.x, rays.v.y, rays.v.z},
                                      rays.directions.empty() ? 0U : 1U,
                                      rays.spanned ? 1U : 0U,
                                      rays.spacing};
    const auto map = local_map.bindings();
    const std::array<const device::Buffer*, 5> bindings{map[0], map[1], map[2], &*depths_,
                                                        &*directions_};
    device_.dispatch(kernel_, bindings, std::as_bytes(std::span(&params, 1)),
                     kernel_.groups_for(params.pixels));
}

} // namespace zonegrid::ops
