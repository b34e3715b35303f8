#pragma once

#include "device/device.h"
#include "device/vulkan_context.h"

namespace zonegrid::device {

/// A kernel's pipeline and the layouts of its bindings.
class VulkanPipeline {
public:
    VulkanPipeline(const VulkanContext& context, const KernelSpec& spec, const KernelCode& code);
    VulkanPipeline(const VulkanPipeline&) = delete;
    VulkanPipeline& operator=(const VulkanPipeline&) = delete;
    ~VulkanPipeline();

    [[nodiscard]] VkPipeline get() const { return pipeline_; }
    [[nodiscard]] VkPipelineLayout layout() const { return layout_; }
    [[nodiscard]] VkDescriptorSetLayout set_layout() const { return set_layout_; }

private:
    explicit VulkanPipeline(const VulkanContext& context) : context_(context) {}
    void make_layouts(const KernelSpec& spec);
    void make_shader(const KernelCode& code);
    void make_pipeline(const KernelSpec& spec, const KernelCode& code);

    const VulkanContext& context_;
    VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkShaderModule shader_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

} // namespace zonegrid::device
