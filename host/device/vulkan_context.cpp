#include "device/vulkan_context.h"

#include "zonegrid/errors.h"

#include <array>
#include <span>

namespace zonegrid::device {

namespace {

VkPhysicalDevice find_physical(const VulkanInstance& instance, const DeviceInfo& info) {
    const auto found = find_vulkan_devices(instance);
    if (info.index >= found.devices.size()) {
        throw DeviceError(info.id(), "the device is gone since it was listed",
                          "list the devices again");
    }
    return found.devices[info.index];
}

} // namespace

VulkanContext::VulkanContext(const DeviceInfo& info)
    : id_(info.id()),
      physical_(find_physical(instance_, info)),
      family_(find_compute_family(instance_, physical_).value()),
      device_(open()),
      api_(instance_, device_) {
    instance_.get_properties(physical_, &properties_);
    instance_.get_memory_properties(physical_, &memory_);
    const std::array numbers{properties_.apiVersion, properties_.driverVersion,
                             properties_.vendorID, properties_.deviceID};
    device_key_.add(info.backend)
        .add(info.name)
        .add(info.driver)
        .add(std::as_bytes(std::span(numbers)))
        .add(std::as_bytes(std::span(properties_.pipelineCacheUUID)));
}

VulkanContext::~VulkanContext() {
    api_.destroy_device(device_, nullptr);
}

VkDevice VulkanContext::open() const {
    const float priority = 1.0F;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = family_.index;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    VkDevice device = nullptr;
    check(instance_.create_device(physical_, &info, nullptr, &device), "vkCreateDevice");
    return device;
}

} // namespace zonegrid::device
