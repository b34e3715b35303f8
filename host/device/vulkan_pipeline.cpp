#include "device/vulkan_pipeline.h"

#include "device/vulkan_pipeline_cache.h"

#include <vector>

namespace zonegrid::device {

// Delegates, so that the destructor cleans up if a later step throws.
VulkanPipeline::VulkanPipeline(const VulkanContext& context, const KernelSpec& spec,
                               const KernelCode& code)
    : VulkanPipeline(context) {
    make_layouts(spec);
    make_shader(code);
    make_pipeline(spec, code);
}

VulkanPipeline::~VulkanPipeline() {
    const auto& api = context_.api();
    api.destroy_pipeline(context_.device(), pipeline_, nullptr);
    api.destroy_shader(context_.device(), shader_, nullptr);
    api.destroy_pipeline_layout(context_.device(), layout_, nullptr);
    api.destroy_set_layout(context_.device(), set_layout_, nullptr);
}

void VulkanPipeline::make_layouts(const KernelSpec& spec) {
    const auto& api = context_.api();
    std::vector<VkDescriptorSetLayoutBinding> bindings(spec.buffers);
    for (std::uint32_t i = 0; i < spec.buffers; ++i) {
        bindings[i].binding = i;
        bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        bindings[i].descriptorCount = 1;
        bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
    }
    VkDescriptorSetLayoutCreateInfo set{};
    set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set.bindingCount = spec.buffers;
    set.pBindings = bindings.data();
    context_.check(api.create_set_layout(context_.device(), &set, nullptr, &set_layout_),
                   "vkCreateDescriptorSetLayout");

    const VkPushConstantRange params{VK_SHADER_STAGE_COMPUTE_BIT, 0,
                                     static_cast<std::uint32_t>(spec.params_bytes)};
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &set_layout_;
    layout.pushConstantRangeCount = spec.params_bytes == 0 ? 0 : 1;
    layout.pPushConstantRanges = &params;
    context_.check(api.create_pipeline_layout(context_.device(), &layout, nullptr, &layout_),
                   "vkCreatePipelineLayout");
}

void VulkanPipeline::make_shader(const KernelCode& code) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = code.spirv.size_bytes();
    info.pCode = code.spirv.data();
    context_.check(context_.api().create_shader(context_.device(), &info, nullptr, &shader_),
                   "vkCreateShaderModule");
}

void VulkanPipeline::make_pipeline(const KernelSpec& spec, const KernelCode& code) {
    // Specialization constant 0 of every shader is the number of items in a work-group.
    const VkSpecializationMapEntry group_items{0, 0, sizeof(spec.group_items)};
    const VkSpecializationInfo constants{1, &group_items, sizeof(spec.group_items),
                                         &spec.group_items};
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = shader_;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &constants;
    info.layout = layout_;
    const VulkanPipelineCache cache(context_, spec, code);
    context_.check(context_.api().create_pipelines(context_.device(), cache.get(), 1, &info,
                                                   nullptr, &pipeline_),
                   "vkCreateComputePipelines");
    cache.keep();
}

} // namespace zonegrid::device
