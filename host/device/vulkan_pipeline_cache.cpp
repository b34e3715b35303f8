#include "device/vulkan_pipeline_cache.h"

#include <array>
#include <cstring>
#include <span>
#include <vector>

namespace zonegrid::device {

namespace {

/// Drivers may trust what stands behind this head, so it must be their own.
bool is_of_driver(std::span<const std::byte> bytes, const VkPhysicalDeviceProperties& properties) {
    VkPipelineCacheHeaderVersionOne head{};
    if (bytes.size() < sizeof(head)) {
        return false;
    }
    std::memcpy(&head, bytes.data(), sizeof(head));
    return head.headerSize == sizeof(head) &&
           head.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           head.vendorID == properties.vendorID && head.deviceID == properties.deviceID &&
           std::memcmp(static_cast<const void*>(head.pipelineCacheUUID),
                       static_cast<const void*>(properties.pipelineCacheUUID), VK_UUID_SIZE) == 0;
}

} // namespace

VulkanPipelineCache::VulkanPipelineCache(const VulkanContext& context, const KernelSpec& spec,
                                         const KernelCode& code)
    : context_(context), key_(context.device_key()) {
    const std::array layout{spec.group_items, spec.buffers,
                            static_cast<std::uint32_t>(spec.params_bytes)};
    key_.add(std::as_bytes(std::span(layout))).add(std::as_bytes(code.spirv));
    const auto kept = context_.kernel_cache().find(key_);
    found_ = kept && is_of_driver(*kept, context_.properties());
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = found_ ? kept->size() : 0;
    info.pInitialData = found_ ? kept->data() : nullptr;
    if (context_.api().create_pipeline_cache(context_.device(), &info, nullptr, &cache_) !=
        VK_SUCCESS) {
        cache_ = VK_NULL_HANDLE;
    }
}

VulkanPipelineCache::~VulkanPipelineCache() {
    context_.api().destroy_pipeline_cache(context_.device(), cache_, nullptr);
}

void VulkanPipelineCache::keep() const {
    if (found_ || cache_ == VK_NULL_HANDLE) {
        return;
    }
    const auto& api = context_.api();
    std::size_t size = 0;
    if (api.get_pipeline_cache(context_.device(), cache_, &size, nullptr) != VK_SUCCESS) {
        return;
    }
    std::vector<std::byte> bytes(size);
    if (api.get_pipeline_cache(context_.device(), cache_, &size, bytes.data()) == VK_SUCCESS) {
        context_.kernel_cache().keep(key_, std::span(bytes).first(size));
    }
}

} // namespace zonegrid::device
