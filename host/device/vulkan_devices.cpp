#include "device/vulkan_devices.h"

#include "device/backends.h"

#include <fmt/format.h>

#include <algorithm>

namespace zonegrid::device {

namespace {

constexpr std::uint32_t all_memory_types = ~0U;

std::string type_name(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "CPU";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated GPU";
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete GPU";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual GPU";
        default:
            return "other";
    }
}

/// A discrete GPU may let the host reach its memory too, but reading it back that way is slow.
bool has_unified_memory(const VkPhysicalDeviceProperties& properties,
                        const VkPhysicalDeviceMemoryProperties& memory) {
    return (properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ||
            properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU) &&
           find_memory_type(memory, all_memory_types,
                            host_memory | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0)
               .has_value();
}

std::uint64_t device_memory_bytes(const VkPhysicalDeviceMemoryProperties& memory) {
    std::uint64_t bytes = 0;
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
        if ((memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0) {
            bytes = std::max<std::uint64_t>(bytes, memory.memoryHeaps[i].size);
        }
    }
    return bytes;
}

/// Largest allocation, and the driver's name and version: the structures of Vulkan 1.1 and 1.2.
void describe_version_1_1(const VulkanInstance& instance, VkPhysicalDevice device,
                          const VkPhysicalDeviceProperties& properties, DeviceInfo& info) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceMaintenance3Properties allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
    const bool names_driver = properties.apiVersion >= VK_API_VERSION_1_2;
    allocation.pNext = names_driver ? &driver : nullptr;
    VkPhysicalDeviceProperties2 more{};
    more.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    more.pNext = &allocation;
    instance.get_properties_2(device, &more);
    info.limits.buffer_bytes =
        std::min<std::uint64_t>(info.limits.buffer_bytes, allocation.maxMemoryAllocationSize);
    if (names_driver) {
        info.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
    }
}

std::string refusal_of(const VkPhysicalDeviceProperties& properties, bool computes) {
    if (properties.apiVersion < VK_API_VERSION_1_1) {
        return "Vulkan 1.1 is needed";
    }
    return computes ? "" : "it has no queue that computes";
}

DeviceInfo describe(const VulkanInstance& instance, VkPhysicalDevice device) {
    VkPhysicalDeviceProperties properties{};
    instance.get_properties(device, &properties);
    VkPhysicalDeviceMemoryProperties memory{};
    instance.get_memory_properties(device, &memory);
    const auto family = find_compute_family(instance, device);
    const auto& limits = properties.limits;

    DeviceInfo info;
    info.backend = "vulkan";
    info.name = properties.deviceName;
    info.type = type_name(properties.deviceType);
    info.driver = fmt::format("driver version {:#x}", properties.driverVersion);
    info.api = fmt::format("Vulkan {}.{}", VK_API_VERSION_MAJOR(properties.apiVersion),
                           VK_API_VERSION_MINOR(properties.apiVersion));
    info.limits.buffer_bytes = limits.maxStorageBufferRange;
    info.limits.memory_bytes = device_memory_bytes(memory);
    info.limits.group_items =
        std::min(limits.maxComputeWorkGroupInvocations, limits.maxComputeWorkGroupSize[0]);
    info.limits.local_bytes = limits.maxComputeSharedMemorySize;
    info.limits.kernel_buffers =
        std::min({limits.maxPerStageDescriptorStorageBuffers, limits.maxDescriptorSetStorageBuffers,
                  max_kernel_buffers});
    info.limits.unified_memory = has_unified_memory(properties, memory);
    info.limits.timestamps = family && family->timestamp_bits != 0;
    info.refusal = refusal_of(properties, family.has_value());
    if (properties.apiVersion >= VK_API_VERSION_1_1) {
        describe_version_1_1(instance, device, properties, info);
    }
    // Buffers are made of whole words.
    info.limits.buffer_bytes -= info.limits.buffer_bytes % 4;
    return info;
}

} // namespace

std::optional<VulkanQueueFamily> find_compute_family(const VulkanInstance& instance,
                                                     VkPhysicalDevice device) {
    std::uint32_t count = 0;
    instance.get_queue_families(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    instance.get_queue_families(device, &count, families.data());
    for (std::uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) {
            return VulkanQueueFamily{i, families[i].timestampValidBits};
        }
    }
    return std::nullopt;
}

std::optional<std::uint32_t> find_memory_type(const VkPhysicalDeviceMemoryProperties& memory,
                                              std::uint32_t allowed, VkMemoryPropertyFlags needed,
                                              VkMemoryPropertyFlags wished) {
    for (const auto flags : {needed | wished, needed}) {
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
            if ((allowed >> i & 1U) != 0 &&
                (memory.memoryTypes[i].propertyFlags & flags) == flags) {
                return i;
            }
        }
    }
    return std::nullopt;
}

VulkanDevices find_vulkan_devices(const VulkanInstance& instance) {
    VulkanDevices found;
    std::uint32_t count = 0;
    check_vulkan(instance.enumerate_devices(instance.get(), &count, nullptr),
                 "vkEnumeratePhysicalDevices", "vulkan");
    found.devices.resize(count);
    check_vulkan(instance.enumerate_devices(instance.get(), &count, found.devices.data()),
                 "vkEnumeratePhysicalDevices", "vulkan");
    for (std::uint32_t i = 0; i < count; ++i) {
        auto info = describe(instance, found.devices[i]);
        info.index = i;
        found.list.devices.push_back(std::move(info));
    }
    if (count == 0) {
        found.list.missing.emplace_back(
            "vulkan: no driver finds a device; install mesa-vulkan-drivers for the CPU");
    }
    return found;
}

DeviceList list_vulkan_devices() {
    return find_vulkan_devices(VulkanInstance::get_shared()).list;
}

} // namespace zonegrid::device
