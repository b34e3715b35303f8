#pragma once

#include "device/device.h"
#include "device/kernel_cache.h"
#include "device/vulkan_api.h"
#include "device/vulkan_devices.h"

#include <string>

namespace zonegrid::device {

/// An open device: what its memory, queue and pipelines share.
class VulkanContext {
public:
    explicit VulkanContext(const DeviceInfo& info);
    VulkanContext(const VulkanContext&) = delete;
    VulkanContext& operator=(const VulkanContext&) = delete;
    ~VulkanContext();

    [[nodiscard]] const VulkanApi& api() const { return api_; }
    [[nodiscard]] VkDevice device() const { return device_; }
    [[nodiscard]] const VkPhysicalDeviceProperties& properties() const { return properties_; }
    [[nodiscard]] const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }
    [[nodiscard]] const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }
    [[nodiscard]] const VulkanQueueFamily& queue_family() const { return family_; }
    [[nodiscard]] const KernelCache& kernel_cache() const { return kernel_cache_; }
    /// Of the device and its driver; a compiled kernel is for these alone.
    [[nodiscard]] const KernelKey& device_key() const { return device_key_; }

    void check(VkResult code, const char* call) const { check_vulkan(code, call, id_); }
    void check_memory(VkResult code, const char* call) const {
        check_vulkan_memory(code, call, id_);
    }

private:
    [[nodiscard]] VkDevice open() const;

    std::string id_;
    const VulkanInstance& instance_ = VulkanInstance::get_shared();
    VkPhysicalDevice physical_;
    VulkanQueueFamily family_;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    VkDevice device_;
    VulkanApi api_;
    KernelCache kernel_cache_ = KernelCache::of_user();
    KernelKey device_key_;
};

} // namespace zonegrid::device
