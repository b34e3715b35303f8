#pragma once

#include "device/device.h"
#include "device/vulkan_context.h"
#include "device/vulkan_memory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace zonegrid::device {

/// A piece of memory between host and device.
struct VulkanStaging {
    VkBuffer buffer = VK_NULL_HANDLE;
    std::uint64_t offset = 0;
    std::byte* mapped = nullptr;
};

/// Commands in order. They are recorded into batches, which are submitted when full or waited for.
/// Batches are numbered from 1; what a batch uses must live until it is waited for.
class VulkanQueue {
public:
    static constexpr std::uint64_t staging_bytes = 4U << 20U; ///< largest staged piece

    VulkanQueue(const VulkanContext& context, bool timestamps);
    VulkanQueue(const VulkanQueue&) = delete;
    VulkanQueue& operator=(const VulkanQueue&) = delete;
    ~VulkanQueue();

    /// The open batch's commands, for one command more: it will see all that those before it wrote.
    [[nodiscard]] VkCommandBuffer next_command();

    /// The batch that `next_command` last recorded into.
    [[nodiscard]] std::uint64_t batch() const { return batch_; }

    /// For a command of the open batch.
    [[nodiscard]] VkDescriptorSet make_set(VkDescriptorSetLayout layout);
    [[nodiscard]] VulkanStaging make_staging(std::uint64_t bytes);

    /// Times what is recorded between the two. Nothing unless the queue was made with timestamps.
    void start_timing(VkCommandBuffer commands, const std::string& kernel);
    void stop_timing(VkCommandBuffer commands);

    /// Starts the open batch.
    void submit();
    /// Waits until a batch is done; 0 is done.
    void wait(std::uint64_t batch);
    /// The same for destructors: an error is left to the next call that may throw.
    void settle(std::uint64_t batch) noexcept;
    void finish() { wait(batch_); }

    [[nodiscard]] std::vector<DispatchTime> take_times();

private:
    struct Batch {
        VkCommandBuffer commands = nullptr;
        VkFence fence = VK_NULL_HANDLE;
        VkDescriptorPool sets = VK_NULL_HANDLE;
        VkQueryPool times = VK_NULL_HANDLE;
        std::uint32_t set_count = 0;
        std::vector<std::string> timed; ///< kernels
        std::vector<std::unique_ptr<VulkanBuffer>> staging;
        std::uint64_t staging_used = 0; ///< of the last of `staging`
    };

    VulkanQueue(const VulkanContext& context, VkCommandPool pool);
    void make_batch(Batch& batch, bool timestamps);
    void destroy_batch(Batch& batch);
    [[nodiscard]] Batch& slot_of(std::uint64_t batch) { return batches_[batch % batches_.size()]; }
    void open_batch();
    void retire(Batch& batch);

    const VulkanContext& context_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkQueue queue_ = nullptr;
    std::array<Batch, 3> batches_; ///< one to record, one that runs, one to come
    std::uint64_t batch_ = 0;
    std::uint64_t done_ = 0;
    bool open_ = false;             ///< batch_ is being recorded; else it was submitted
    VkResult failure_ = VK_SUCCESS; ///< of the last submission; after one there are no others
    std::vector<std::unique_ptr<VulkanBuffer>> spare_staging_;
    std::vector<DispatchTime> times_;
};

} // namespace zonegrid::device
