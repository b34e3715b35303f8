#include "faulty_call.h"

#include <vulkan/vulkan_core.h>

#include <dlfcn.h>

#include <string_view>

// Functions are asked for by name: those that may fail are replaced on the way.

namespace {

PFN_vkGetDeviceProcAddr real_device_function = nullptr;
PFN_vkQueueSubmit real_submit = nullptr;
PFN_vkAllocateMemory real_allocate = nullptr;

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

PFN_vkVoidFunction device_function(VkDevice device, const char* name) {
    auto* const function = real_device_function(device, name);
    if (std::string_view(name) == "vkQueueSubmit") {
        real_submit = reinterpret_cast<PFN_vkQueueSubmit>(function);
        return reinterpret_cast<PFN_vkVoidFunction>(&faulty_submit);
    }
    if (std::string_view(name) == "vkAllocateMemory") {
        real_allocate = reinterpret_cast<PFN_vkAllocateMemory>(function);
        return reinterpret_cast<PFN_vkVoidFunction>(&faulty_allocate);
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
