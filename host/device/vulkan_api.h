#pragma once

#include "device/shared_library.h"

#include <vulkan/vulkan_core.h>

#include <string>

namespace zonegrid::device {

/// Vulkan's loader. Throws DeviceError if there is none.
class VulkanLoader {
    SharedLibrary library_{"vulkan", "ZONEGRID_VULKAN_LIBRARY", "libvulkan.so.1",
                           "install a Vulkan loader (Debian: libvulkan1)"};

public:
    PFN_vkGetInstanceProcAddr get_instance_function = library_.find("vkGetInstanceProcAddr");
    PFN_vkCreateInstance create_instance = library_.find("vkCreateInstance");

    [[nodiscard]] const std::string& name() const { return library_.name(); }
};

/// An instance and its functions, loaded at run time.
class VulkanInstance {
    VulkanLoader loader_;
    VkInstance instance_;
    [[nodiscard]] Symbol find(const char* function) const;

    VulkanInstance();

public:
    /// The process's instance of the loader that the environment names now; made at the first call
    /// and kept to the end of the process. A driver that goes with its instance cannot be loaded
    /// any number of times: NVIDIA's leaves some memory for threads behind each time, and after
    /// about ten the loader finds no driver any more.
    /// Throws DeviceError if there is no loader, or if it finds no driver.
    static const VulkanInstance& get_shared();
    VulkanInstance(const VulkanInstance&) = delete;
    VulkanInstance& operator=(const VulkanInstance&) = delete;

    [[nodiscard]] VkInstance get() const { return instance_; }

    PFN_vkEnumeratePhysicalDevices enumerate_devices = find("vkEnumeratePhysicalDevices");
    PFN_vkGetPhysicalDeviceProperties get_properties = find("vkGetPhysicalDeviceProperties");
    PFN_vkGetPhysicalDeviceProperties2 get_properties_2 = find("vkGetPhysicalDeviceProperties2");
    PFN_vkGetPhysicalDeviceMemoryProperties get_memory_properties =
        find("vkGetPhysicalDeviceMemoryProperties");
    PFN_vkGetPhysicalDeviceQueueFamilyProperties get_queue_families =
        find("vkGetPhysicalDeviceQueueFamilyProperties");
    PFN_vkCreateDevice create_device = find("vkCreateDevice");
    PFN_vkGetDeviceProcAddr get_device_function = find("vkGetDeviceProcAddr");
};

/// A device's functions.
class VulkanApi {
    const VulkanInstance& instance_;
    VkDevice device_;
    [[nodiscard]] Symbol find(const char* function) const;

public:
    VulkanApi(const VulkanInstance& instance, VkDevice device)
        : instance_(instance), device_(device) {}

    PFN_vkDestroyDevice destroy_device = find("vkDestroyDevice");
    PFN_vkGetDeviceQueue get_queue = find("vkGetDeviceQueue");
    PFN_vkDeviceWaitIdle wait_idle = find("vkDeviceWaitIdle");

    PFN_vkCreateBuffer create_buffer = find("vkCreateBuffer");
    PFN_vkDestroyBuffer destroy_buffer = find("vkDestroyBuffer");
    PFN_vkGetBufferMemoryRequirements get_memory_needs = find("vkGetBufferMemoryRequirements");
    PFN_vkAllocateMemory allocate_memory = find("vkAllocateMemory");
    PFN_vkFreeMemory free_memory = find("vkFreeMemory");
    PFN_vkBindBufferMemory bind_memory = find("vkBindBufferMemory");
    PFN_vkMapMemory map_memory = find("vkMapMemory");

    PFN_vkCreateShaderModule create_shader = find("vkCreateShaderModule");
    PFN_vkDestroyShaderModule destroy_shader = find("vkDestroyShaderModule");
    PFN_vkCreateDescriptorSetLayout create_set_layout = find("vkCreateDescriptorSetLayout");
    PFN_vkDestroyDescriptorSetLayout destroy_set_layout = find("vkDestroyDescriptorSetLayout");
    PFN_vkCreatePipelineLayout create_pipeline_layout = find("vkCreatePipelineLayout");
    PFN_vkDestroyPipelineLayout destroy_pipeline_layout = find("vkDestroyPipelineLayout");
    PFN_vkCreateComputePipelines create_pipelines = find("vkCreateComputePipelines");
    PFN_vkCreatePipelineCache create_pipeline_cache = find("vkCreatePipelineCache");
    PFN_vkGetPipelineCacheData get_pipeline_cache = find("vkGetPipelineCacheData");
    PFN_vkDestroyPipelineCache destroy_pipeline_cache = find("vkDestroyPipelineCache");
    PFN_vkDestroyPipeline destroy_pipeline = find("vkDestroyPipeline");

    PFN_vkCreateCommandPool create_command_pool = find("vkCreateCommandPool");
    PFN_vkDestroyCommandPool destroy_command_pool = find("vkDestroyCommandPool");
    PFN_vkAllocateCommandBuffers allocate_commands = find("vkAllocateCommandBuffers");
    PFN_vkBeginCommandBuffer begin_commands = find("vkBeginCommandBuffer");
    PFN_vkEndCommandBuffer end_commands = find("vkEndCommandBuffer");
    PFN_vkQueueSubmit submit = find("vkQueueSubmit");
    PFN_vkCreateFence create_fence = find("vkCreateFence");
    PFN_vkDestroyFence destroy_fence = find("vkDestroyFence");
    PFN_vkResetFences reset_fences = find("vkResetFences");
    PFN_vkWaitForFences wait_for_fences = find("vkWaitForFences");

    PFN_vkCreateDescriptorPool create_set_pool = find("vkCreateDescriptorPool");
    PFN_vkDestroyDescriptorPool destroy_set_pool = find("vkDestroyDescriptorPool");
    PFN_vkResetDescriptorPool reset_set_pool = find("vkResetDescriptorPool");
    PFN_vkAllocateDescriptorSets allocate_sets = find("vkAllocateDescriptorSets");
    PFN_vkUpdateDescriptorSets update_sets = find("vkUpdateDescriptorSets");

    PFN_vkCreateQueryPool create_query_pool = find("vkCreateQueryPool");
    PFN_vkDestroyQueryPool destroy_query_pool = find("vkDestroyQueryPool");
    PFN_vkGetQueryPoolResults get_query_results = find("vkGetQueryPoolResults");

    PFN_vkCmdPipelineBarrier record_barrier = find("vkCmdPipelineBarrier");
    PFN_vkCmdBindPipeline record_pipeline = find("vkCmdBindPipeline");
    PFN_vkCmdBindDescriptorSets record_sets = find("vkCmdBindDescriptorSets");
    PFN_vkCmdPushConstants record_params = find("vkCmdPushConstants");
    PFN_vkCmdDispatch record_dispatch = find("vkCmdDispatch");
    PFN_vkCmdCopyBuffer record_copy = find("vkCmdCopyBuffer");
    PFN_vkCmdFillBuffer record_fill = find("vkCmdFillBuffer");
    PFN_vkCmdResetQueryPool record_query_reset = find("vkCmdResetQueryPool");
    PFN_vkCmdWriteTimestamp record_timestamp = find("vkCmdWriteTimestamp");
};

/// "VK_ERROR_DEVICE_LOST", or the number of a code without a name.
[[nodiscard]] std::string vulkan_code_name(VkResult code);

/// Throws DeviceError if `code`, which `call` returned, is a failure.
void check_vulkan(VkResult code, const char* call, const std::string& device);

/// The same for calls that take memory: throws CapacityError if there is none left.
void check_vulkan_memory(VkResult code, const char* call, const std::string& device);

} // namespace zonegrid::device
