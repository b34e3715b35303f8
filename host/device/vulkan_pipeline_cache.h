#pragma once

#include "device/device.h"
#include "device/kernel_cache.h"
#include "device/vulkan_context.h"

namespace zonegrid::device {

/// What the driver keeps of one kernel's compilation, from the user's cache and into it.
class VulkanPipelineCache {
public:
    VulkanPipelineCache(const VulkanContext& context, const KernelSpec& spec,
                        const KernelCode& code);
    VulkanPipelineCache(const VulkanPipelineCache&) = delete;
    VulkanPipelineCache& operator=(const VulkanPipelineCache&) = delete;
    ~VulkanPipelineCache();

    /// To make the pipeline with; null if the driver makes none.
    [[nodiscard]] VkPipelineCache get() const { return cache_; }

    /// Once the pipeline is made.
    void keep() const;

private:
    const VulkanContext& context_;
    KernelKey key_;
    bool found_ = false;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
};

} // namespace zonegrid::device
