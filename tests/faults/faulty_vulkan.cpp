#include "faulty_call.h"

#include <vulkan/vulkan_core.h>

#include <dlfcn.h>

#include <string_view>

// Functions are asked for by name: those that may fail are replaced on the way.

namespace {

PFN_vkGetDeviceProcAddr real_device_function = nullptr;
PFN_vkQueueSubmit real_submit = nullptr;
PFN_vkAllocateMemory real_allocate = nullptr;
PFN_vkCreateFence real_create_fence = nullptr;
PFN_vkCmdPipelineBarrier real_barrier = nullptr;

VkResult faulty_submit(VkQueue queue, uint32_t count, const VkSubmitInfo* infos, VkFence fence) {
    int fault = 0;
    return zonegrid::is_faulty("vkQueueSubmit", fault) ? static_cast<VkResult>(fault)
                                                       : real_submit(queue, count, infos, fence);
}

VkResult faulty_allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                         const VkAllocationCallbacks* callbacks, VkDeviceMemory* memory) {
    int fault = 0;
    return zonegrid::is_faulty("vkAllocateMemory", fault)
               ? static_cast<VkResult>(fault)
               : real_allocate(device, info, callbacks, memory);
}

/// With a fault: of no structure type, which drivers do not look at.
VkResult faulty_create_fence(VkDevice device, const VkFenceCreateInfo* info,
                             const VkAllocationCallbacks* callbacks, VkFence* fence) {
    VkFenceCreateInfo wrong = *info;
    wrong.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    int fault = 0;
    return real_create_fence(device, zonegrid::is_faulty("vkCreateFence", fault) ? &wrong : info,
                             callbacks, fence);
}

/// With a fault: none.
void faulty_barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to,
                    VkDependencyFlags flags, uint32_t count, const VkMemoryBarrier* barriers,
                    uint32_t buffer_count, const VkBufferMemoryBarrier* buffers,
                    uint32_t image_count, const VkImageMemoryBarrier* images) {
    int fault = 0;
    if (!zonegrid::is_faulty("vkCmdPipelineBarrier", fault)) {
        real_barrier(commands, from, to, flags, count, barriers, buffer_count, buffers, image_count,
                     images);
    }
}

template <class Function>
PFN_vkVoidFunction replace(PFN_vkVoidFunction function, Function& real, Function faulty) {
    real = reinterpret_cast<Function>(function);
    return reinterpret_cast<PFN_vkVoidFunction>(faulty);
}

PFN_vkVoidFunction device_function(VkDevice device, const char* name) {
    auto* const function = real_device_function(device, name);
    const std::string_view wanted = name;
    if (wanted == "vkQueueSubmit") {
        return replace(function, real_submit, &faulty_submit);
    }
    if (wanted == "vkAllocateMemory") {
        return replace(function, real_allocate, &faulty_allocate);
    }
    if (wanted == "vkCreateFence") {
        return replace(function, real_create_fence, &faulty_create_fence);
    }
    if (wanted == "vkCmdPipelineBarrier") {
        return replace(function, real_barrier, &faulty_barrier);
    }
    return function;
}

} // namespace

extern "C" PFN_vkVoidFunction vkGetInstanceProcAddr(VkInstance instance, const char* name) {
    const auto real =
        reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(RTLD_NEXT, "vkGetInstanceProcAddr"));
    auto* const function = real(instance, name);
    if (std::string_view(name) == "vkGetDeviceProcAddr") {
        real_device_function = reinterpret_cast<PFN_vkGetDeviceProcAddr>(function);
        return reinterpret_cast<PFN_vkVoidFunction>(&device_function);
    }
    return function;
}
