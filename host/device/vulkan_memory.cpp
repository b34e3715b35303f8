#include "device/vulkan_memory.h"

namespace zonegrid::device {

namespace {

std::uint32_t choose_memory_type(const VulkanContext& context, std::uint32_t allowed,
                                 VulkanPlace place) {
    constexpr VkMemoryPropertyFlags own = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    constexpr VkMemoryPropertyFlags cached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    const auto type = place == VulkanPlace::device
                          ? find_memory_type(context.memory(), allowed, 0, own)
                      : place == VulkanPlace::unified
                          ? find_memory_type(context.memory(), allowed, host_memory | own, cached)
                          : find_memory_type(context.memory(), allowed, host_memory, cached);
    // Vulkan promises a type that the host reaches for any buffer.
    context.check(type ? VK_SUCCESS : VK_ERROR_FEATURE_NOT_PRESENT, "choosing a memory type");
    return *type;
}

} // namespace

VulkanBuffer::VulkanBuffer(const VulkanContext& context, std::uint64_t bytes)
    : context_(context), bytes_(bytes) {}

// Delegates, so that the destructor cleans up if a later step throws.
VulkanBuffer::VulkanBuffer(const VulkanContext& context, std::uint64_t bytes, VulkanPlace place)
    : VulkanBuffer(context, (bytes + 3) / 4 * 4) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes_;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                 VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    check(context_.api().create_buffer(context_.device(), &info, nullptr, &buffer_),
          "vkCreateBuffer", place);
    allocate(place);
}

VulkanBuffer::~VulkanBuffer() {
    context_.api().destroy_buffer(context_.device(), buffer_, nullptr);
    context_.api().free_memory(context_.device(), memory_, nullptr);
}

void VulkanBuffer::check(VkResult code, const char* call, VulkanPlace place) const {
    if (place == VulkanPlace::staging) {
        context_.check(code, call); // in the middle of work: not a buffer that somebody asked for
    } else {
        context_.check_memory(code, call);
    }
}

void VulkanBuffer::allocate(VulkanPlace place) {
    const auto& api = context_.api();
    VkMemoryRequirements needs{};
    api.get_memory_needs(context_.device(), buffer_, &needs);
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = choose_memory_type(context_, needs.memoryTypeBits, place);
    check(api.allocate_memory(context_.device(), &info, nullptr, &memory_), "vkAllocateMemory",
          place);
    context_.check(api.bind_memory(context_.device(), buffer_, memory_, 0), "vkBindBufferMemory");
    if (place != VulkanPlace::device) {
        void* mapped = nullptr;
        check(api.map_memory(context_.device(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped),
              "vkMapMemory", place);
        mapped_ = static_cast<std::byte*>(mapped);
    }
}

} // namespace zonegrid::device
