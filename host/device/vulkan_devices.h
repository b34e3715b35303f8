#pragma once

#include "device/device.h"
#include "device/vulkan_api.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace zonegrid::device {

struct VulkanDevices {
    std::vector<VkPhysicalDevice> devices; ///< in the order of `list.devices`
    DeviceList list;
};

[[nodiscard]] VulkanDevices find_vulkan_devices(const VulkanInstance& instance);

/// The queue family that computes.
struct VulkanQueueFamily {
    std::uint32_t index = 0;
    std::uint32_t timestamp_bits = 0; ///< 0: its work cannot be timed
};

[[nodiscard]] std::optional<VulkanQueueFamily> find_compute_family(const VulkanInstance& instance,
                                                                   VkPhysicalDevice device);

/// First memory type among `allowed` (a bit each) with all of `needed`, best also with `wished`.
[[nodiscard]] std::optional<std::uint32_t> find_memory_type(
    const VkPhysicalDeviceMemoryProperties& memory, std::uint32_t allowed,
    VkMemoryPropertyFlags needed, VkMemoryPropertyFlags wished);

/// What host and device both reach without a copy, coherently.
inline constexpr VkMemoryPropertyFlags host_memory =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;

} // namespace zonegrid::device
