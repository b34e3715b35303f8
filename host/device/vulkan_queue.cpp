#include "device/vulkan_queue.h"

#include <exception>
#include <limits>
#include <utility>

namespace zonegrid::device {

namespace {

constexpr std::uint32_t sets_per_batch = 128;
constexpr std::uint64_t staging_alignment = 64;
constexpr std::uint64_t no_timeout = std::numeric_limits<std::uint64_t>::max();

VkCommandPool make_pool(const VulkanContext& context) {
    VkCommandPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    info.queueFamilyIndex = context.queue_family().index;
    VkCommandPool pool = VK_NULL_HANDLE;
    context.check(context.api().create_command_pool(context.device(), &info, nullptr, &pool),
                  "vkCreateCommandPool");
    return pool;
}

void record_barrier(const VulkanContext& context, VkCommandBuffer commands,
                    VkPipelineStageFlags stages, VkAccessFlags access) {
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = access;
    context.api().record_barrier(
        commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT, stages, 0,
        1, &barrier, 0, nullptr, 0, nullptr);
}

} // namespace

VulkanQueue::VulkanQueue(const VulkanContext& context, VkCommandPool pool)
    : context_(context), pool_(pool) {}

// Delegates, so that the destructor cleans up if a later step throws.
VulkanQueue::VulkanQueue(const VulkanContext& context, bool timestamps)
    : VulkanQueue(context, make_pool(context)) {
    context_.api().get_queue(context_.device(), context_.queue_family().index, 0, &queue_);
    for (auto& batch : batches_) {
        make_batch(batch, timestamps);
    }
}

VulkanQueue::~VulkanQueue() {
    context_.api().wait_idle(context_.device());
    for (auto& batch : batches_) {
        destroy_batch(batch);
    }
    context_.api().destroy_command_pool(context_.device(), pool_, nullptr);
}

void VulkanQueue::make_batch(Batch& batch, bool timestamps) {
    const auto& api = context_.api();
    VkCommandBufferAllocateInfo commands{};
    commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    commands.commandPool = pool_;
    commands.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    commands.commandBufferCount = 1;
    context_.check(api.allocate_commands(context_.device(), &commands, &batch.commands),
                   "vkAllocateCommandBuffers");

    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    context_.check(api.create_fence(context_.device(), &fence, nullptr, &batch.fence),
                   "vkCreateFence");

    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                    sets_per_batch * max_kernel_buffers};
    VkDescriptorPoolCreateInfo sets{};
    sets.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    sets.maxSets = sets_per_batch;
    sets.poolSizeCount = 1;
    sets.pPoolSizes = &size;
    context_.check(api.create_set_pool(context_.device(), &sets, nullptr, &batch.sets),
                   "vkCreateDescriptorPool");

    if (timestamps) {
        VkQueryPoolCreateInfo times{};
        times.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
        times.queryType = VK_QUERY_TYPE_TIMESTAMP;
        times.queryCount = 2 * sets_per_batch;
        context_.check(api.create_query_pool(context_.device(), &times, nullptr, &batch.times),
                       "vkCreateQueryPool");
    }
}

void VulkanQueue::destroy_batch(Batch& batch) {
    const auto& api = context_.api();
    api.destroy_query_pool(context_.device(), batch.times, nullptr);
    api.destroy_set_pool(context_.device(), batch.sets, nullptr);
    api.destroy_fence(context_.device(), batch.fence, nullptr);
}

void VulkanQueue::open_batch() {
    const std::uint64_t next = batch_ + 1;
    Batch& batch = slot_of(next);
    if (next > batches_.size()) {
        wait(next - batches_.size());
    }
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    context_.check(context_.api().begin_commands(batch.commands, &info), "vkBeginCommandBuffer");
    if (batch.times != VK_NULL_HANDLE) {
        context_.api().record_query_reset(batch.commands, batch.times, 0, 2 * sets_per_batch);
    }
    batch_ = next;
    open_ = true;
}

VkCommandBuffer VulkanQueue::next_command() {
    context_.check(failure_, "vkQueueSubmit");
    if (open_ && slot_of(batch_).set_count == sets_per_batch) {
        submit();
    }
    if (!open_) {
        open_batch();
    }
    VkCommandBuffer commands = slot_of(batch_).commands;
    // Commands of earlier batches count as earlier commands of the queue.
    record_barrier(context_, commands,
                   VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                   VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                       VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT);
    return commands;
}

VkDescriptorSet VulkanQueue::make_set(VkDescriptorSetLayout layout) {
    Batch& batch = slot_of(batch_);
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = batch.sets;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    VkDescriptorSet set = VK_NULL_HANDLE;
    context_.check(context_.api().allocate_sets(context_.device(), &info, &set),
                   "vkAllocateDescriptorSets");
    ++batch.set_count;
    return set;
}

VulkanStaging VulkanQueue::make_staging(std::uint64_t bytes) {
    Batch& batch = slot_of(batch_);
    if (batch.staging.empty() || batch.staging_used + bytes > staging_bytes) {
        if (spare_staging_.empty()) {
            spare_staging_.push_back(
                std::make_unique<VulkanBuffer>(context_, staging_bytes, VulkanPlace::staging));
        }
        batch.staging.push_back(std::move(spare_staging_.back()));
        spare_staging_.pop_back();
        batch.staging_used = 0;
    }
    const VulkanBuffer& buffer = *batch.staging.back();
    const VulkanStaging piece{buffer.get(), batch.staging_used,
                              buffer.mapped() + batch.staging_used};
    batch.staging_used += (bytes + staging_alignment - 1) / staging_alignment * staging_alignment;
    return piece;
}

void VulkanQueue::start_timing(VkCommandBuffer commands, const std::string& kernel) {
    Batch& batch = slot_of(batch_);
    if (batch.times != VK_NULL_HANDLE) {
        context_.api().record_timestamp(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, batch.times,
                                        static_cast<std::uint32_t>(2 * batch.timed.size()));
        batch.timed.push_back(kernel);
    }
}

void VulkanQueue::stop_timing(VkCommandBuffer commands) {
    Batch& batch = slot_of(batch_);
    if (batch.times != VK_NULL_HANDLE) {
        context_.api().record_timestamp(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, batch.times,
                                        static_cast<std::uint32_t>(2 * batch.timed.size() - 1));
    }
}

void VulkanQueue::submit() {
    if (!open_) {
        return;
    }
    const auto& api = context_.api();
    Batch& batch = slot_of(batch_);
    record_barrier(context_, batch.commands, VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
    open_ = false; // even if it fails: commands end but once
    failure_ = api.end_commands(batch.commands);
    context_.check(failure_, "vkEndCommandBuffer");
    VkSubmitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &batch.commands;
    failure_ = api.submit(queue_, 1, &info, batch.fence);
    context_.check(failure_, "vkQueueSubmit");
}

void VulkanQueue::wait(std::uint64_t batch) {
    if (batch == batch_) {
        submit();
    }
    if (done_ < batch) {
        context_.check(failure_, "vkQueueSubmit"); // its fence would never tell
    }
    while (done_ < batch) {
        Batch& next = slot_of(done_ + 1);
        context_.check(
            context_.api().wait_for_fences(context_.device(), 1, &next.fence, VK_TRUE, no_timeout),
            "vkWaitForFences");
        retire(next);
        ++done_;
    }
}

void VulkanQueue::settle(std::uint64_t batch) noexcept {
    try {
        wait(batch);
    } catch (const std::exception&) {
        context_.api().wait_idle(context_.device());
    }
}

void VulkanQueue::retire(Batch& batch) {
    const auto& api = context_.api();
    if (!batch.timed.empty()) {
        std::vector<std::uint64_t> ticks(2 * batch.timed.size());
        context_.check(
            api.get_query_results(context_.device(), batch.times, 0,
                                  static_cast<std::uint32_t>(ticks.size()),
                                  ticks.size() * sizeof(ticks[0]), ticks.data(), sizeof(ticks[0]),
                                  VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
            "vkGetQueryPoolResults");
        // Ticks wrap after so many bits.
        const std::uint64_t mask = no_timeout >> (64U - context_.queue_family().timestamp_bits);
        const double tick_s = static_cast<double>(context_.limits().timestampPeriod) * 1e-9;
        for (std::size_t i = 0; i < batch.timed.size(); ++i) {
            const std::uint64_t taken = (ticks[2 * i + 1] - ticks[2 * i]) & mask;
            times_.push_back({batch.timed[i], static_cast<double>(taken) * tick_s});
        }
        batch.timed.clear();
    }
    context_.check(api.reset_fences(context_.device(), 1, &batch.fence), "vkResetFences");
    context_.check(api.reset_set_pool(context_.device(), batch.sets, 0), "vkResetDescriptorPool");
    batch.set_count = 0;
    for (auto& buffer : batch.staging) {
        spare_staging_.push_back(std::move(buffer));
    }
    batch.staging.clear();
    batch.staging_used = 0;
}

std::vector<DispatchTime> VulkanQueue::take_times() {
    finish();
    return std::exchange(times_, {});
}

} // namespace zonegrid::device
