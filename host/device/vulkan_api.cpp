#include "device/vulkan_api.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace zonegrid::device {

namespace {

Symbol require(PFN_vkVoidFunction address, const char* function) {
    if (address == nullptr) {
        throw DeviceError("vulkan", fmt::format("the driver has no function {}", function),
                          "install a driver for Vulkan 1.1 or later");
    }
    return Symbol(address);
}

VkInstance make_instance(const VulkanLoader& loader) {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "zonegrid";
    // The newest version of which a structure is used; devices of 1.1 are welcome.
    application.apiVersion = VK_API_VERSION_1_2;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance instance = nullptr;
    const VkResult code = loader.create_instance(&info, nullptr, &instance);
    if (code == VK_ERROR_INCOMPATIBLE_DRIVER) {
        throw DeviceError("vulkan", "no driver is installed, or none that is can be used",
                          "install the one of your device, or mesa-vulkan-drivers for the CPU; "
                          "with VK_LOADER_DEBUG=error,warn,driver the loader says what it tried");
    }
    check_vulkan(code, "vkCreateInstance", "vulkan");
    return instance;
}

bool is_memory_code(VkResult code) {
    return code == VK_ERROR_OUT_OF_HOST_MEMORY || code == VK_ERROR_OUT_OF_DEVICE_MEMORY ||
           code == VK_ERROR_TOO_MANY_OBJECTS;
}

const char* remedy_for(VkResult code) {
    if (code == VK_ERROR_DEVICE_LOST) {
        return "the device was reset, removed, or stopped a shader that ran too long: start a new "
               "map; if it is lost again, see the system's log, look for a newer driver or choose "
               "another device";
    }
    return is_memory_code(code) ? "take larger cells, a shorter range or a device with more memory"
                                : "look for a newer driver or choose another device";
}

} // namespace

VulkanInstance::VulkanInstance() : instance_(make_instance(loader_)) {}

const VulkanInstance& VulkanInstance::get_shared() {
    struct Kept {
        std::mutex lock;
        std::map<std::string, std::unique_ptr<const VulkanInstance>> by_loader;
    };
    // Never destroyed: drivers have exit handlers of their own, and the order is not known.
    static Kept& kept = *std::make_unique<Kept>().release();
    const std::lock_guard guard(kept.lock);
    auto& instance = kept.by_loader[VulkanLoader().name()];
    if (!instance) {
        instance.reset(new VulkanInstance);
    }
    return *instance;
}

Symbol VulkanInstance::find(const char* function) const {
    return require(loader_.get_instance_function(instance_, function), function);
}

Symbol VulkanApi::find(const char* function) const {
    return require(instance_.get_device_function(device_, function), function);
}

std::string vulkan_code_name(VkResult code) {
    switch (code) {
        case VK_NOT_READY:
            return "VK_NOT_READY";
        case VK_TIMEOUT:
            return "VK_TIMEOUT";
        case VK_INCOMPLETE:
            return "VK_INCOMPLETE";
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return "VK_ERROR_OUT_OF_HOST_MEMORY";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
        case VK_ERROR_INITIALIZATION_FAILED:
            return "VK_ERROR_INITIALIZATION_FAILED";
        case VK_ERROR_DEVICE_LOST:
            return "VK_ERROR_DEVICE_LOST";
        case VK_ERROR_MEMORY_MAP_FAILED:
            return "VK_ERROR_MEMORY_MAP_FAILED";
        case VK_ERROR_LAYER_NOT_PRESENT:
            return "VK_ERROR_LAYER_NOT_PRESENT";
        case VK_ERROR_EXTENSION_NOT_PRESENT:
            return "VK_ERROR_EXTENSION_NOT_PRESENT";
        case VK_ERROR_FEATURE_NOT_PRESENT:
            return "VK_ERROR_FEATURE_NOT_PRESENT";
        case VK_ERROR_INCOMPATIBLE_DRIVER:
            return "VK_ERROR_INCOMPATIBLE_DRIVER";
        case VK_ERROR_TOO_MANY_OBJECTS:
            return "VK_ERROR_TOO_MANY_OBJECTS";
        case VK_ERROR_FRAGMENTED_POOL:
            return "VK_ERROR_FRAGMENTED_POOL";
        case VK_ERROR_OUT_OF_POOL_MEMORY:
            return "VK_ERROR_OUT_OF_POOL_MEMORY";
        case VK_ERROR_UNKNOWN:
            return "VK_ERROR_UNKNOWN";
        default:
            return fmt::format("code {}", static_cast<int>(code));
    }
}

void check_vulkan(VkResult code, const char* call, const std::string& device) {
    if (code == VK_SUCCESS) {
        return;
    }
    throw DeviceError(device, fmt::format("{} failed with {}", call, vulkan_code_name(code)),
                      remedy_for(code));
}

void check_vulkan_memory(VkResult code, const char* call, const std::string& device) {
    if (is_memory_code(code)) {
        throw CapacityError(fmt::format("{} has no more memory: {} failed with {}", device, call,
                                        vulkan_code_name(code)));
    }
    check_vulkan(code, call, device);
}

} // namespace zonegrid::device
