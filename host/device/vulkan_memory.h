#pragma once

#include "device/vulkan_context.h"

#include <cstddef>
#include <cstdint>

namespace zonegrid::device {

/// Where a buffer lies.
enum class VulkanPlace {
    device,  ///< the device's own memory; the host cannot reach it
    unified, ///< memory of both
    staging  ///< the host's memory, which the device copies from or to
};

/// A buffer with memory of its own: buffers here are few and large.
class VulkanBuffer {
public:
    VulkanBuffer(const VulkanContext& context, std::uint64_t bytes, VulkanPlace place);
    VulkanBuffer(const VulkanBuffer&) = delete;
    VulkanBuffer& operator=(const VulkanBuffer&) = delete;
    ~VulkanBuffer();

    [[nodiscard]] VkBuffer get() const { return buffer_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    /// Where the host sees it; null if it does not.
    [[nodiscard]] std::byte* mapped() const { return mapped_; }

private:
    VulkanBuffer(const VulkanContext& context, std::uint64_t bytes);
    void check(VkResult code, const char* call, VulkanPlace place) const;
    void allocate(VulkanPlace place);

    const VulkanContext& context_;
    std::uint64_t bytes_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    std::byte* mapped_ = nullptr;
};

} // namespace zonegrid::device
