#include "device/backends.h"
#include "device/vulkan_context.h"
#include "device/vulkan_memory.h"
#include "device/vulkan_pipeline.h"
#include "device/vulkan_queue.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace zonegrid::device {

namespace {

/// A buffer, and the last batch that uses it: until that is done it can neither be touched nor go.
class VulkanMemory : public Buffer::Memory {
public:
    VulkanMemory(VulkanQueue& queue, const VulkanContext& context, std::uint64_t bytes,
                 VulkanPlace place)
        : buffer(context, bytes, place), queue_(queue) {}
    ~VulkanMemory() override { queue_.settle(last_batch); }
    VulkanMemory(const VulkanMemory&) = delete;
    VulkanMemory& operator=(const VulkanMemory&) = delete;

    VulkanBuffer buffer;
    std::uint64_t last_batch = 0;

private:
    VulkanQueue& queue_;
};

class VulkanProgram : public Kernel::Program {
public:
    VulkanProgram(VulkanQueue& queue, const VulkanContext& context, const KernelSpec& spec,
                  const KernelCode& code)
        : pipeline(context, spec, code), queue_(queue) {}
    ~VulkanProgram() override { queue_.settle(last_batch); }
    VulkanProgram(const VulkanProgram&) = delete;
    VulkanProgram& operator=(const VulkanProgram&) = delete;

    VulkanPipeline pipeline;
    std::uint64_t last_batch = 0;

private:
    VulkanQueue& queue_;
};

VulkanMemory& memory_of(const Buffer& buffer) {
    return static_cast<VulkanMemory&>(buffer.memory());
}

class VulkanDevice : public Device {
public:
    VulkanDevice(const DeviceInfo& info, const DeviceOptions& chosen)
        : Device(info, chosen),
          place_(info.limits.unified_memory && chosen.unified_memory ? VulkanPlace::unified
                                                                     : VulkanPlace::device),
          context_(info),
          queue_(context_, chosen.timestamps) {}

private:
    std::unique_ptr<Buffer::Memory> do_make_buffer(std::uint64_t bytes) override {
        return std::make_unique<VulkanMemory>(queue_, context_, bytes, place_);
    }

    std::unique_ptr<Kernel::Program> do_make_kernel(KernelSpec& spec,
                                                    const KernelCode& code) override {
        return std::make_unique<VulkanProgram>(queue_, context_, spec, code);
    }

    void do_upload(Buffer& buffer, std::uint64_t offset,
                   std::span<const std::byte> bytes) override {
        auto& memory = memory_of(buffer);
        if (place_ == VulkanPlace::unified) {
            queue_.wait(memory.last_batch);
            std::memcpy(memory.buffer.mapped() + offset, bytes.data(), bytes.size());
            return;
        }
        while (!bytes.empty()) {
            const auto piece =
                bytes.first(std::min<std::size_t>(bytes.size(), VulkanQueue::staging_bytes));
            const auto commands = queue_.next_command();
            const auto staging = queue_.make_staging(piece.size());
            std::memcpy(staging.mapped, piece.data(), piece.size());
            const VkBufferCopy copy{staging.offset, offset, piece.size()};
            context_.api().record_copy(commands, staging.buffer, memory.buffer.get(), 1, &copy);
            memory.last_batch = queue_.batch();
            offset += piece.size();
            bytes = bytes.subspan(piece.size());
            if (!bytes.empty()) {
                queue_.submit(); // so that few staging buffers serve a long upload
            }
        }
    }

    void do_download(const Buffer& buffer, std::uint64_t offset,
                     std::span<std::byte> bytes) override {
        auto& memory = memory_of(buffer);
        if (place_ == VulkanPlace::unified) {
            queue_.wait(memory.last_batch);
            std::memcpy(bytes.data(), memory.buffer.mapped() + offset, bytes.size());
            return;
        }
        while (!bytes.empty()) {
            const auto piece =
                bytes.first(std::min<std::size_t>(bytes.size(), VulkanQueue::staging_bytes));
            const auto commands = queue_.next_command();
            const auto staging = queue_.make_staging(piece.size());
            const VkBufferCopy copy{offset, staging.offset, piece.size()};
            context_.api().record_copy(commands, memory.buffer.get(), staging.buffer, 1, &copy);
            memory.last_batch = queue_.batch();
            queue_.wait(memory.last_batch);
            std::memcpy(piece.data(), staging.mapped, piece.size());
            offset += piece.size();
            bytes = bytes.subspan(piece.size());
        }
    }

    void do_fill(Buffer& buffer, std::uint64_t offset, std::uint64_t bytes,
                 std::uint32_t word) override {
        auto& memory = memory_of(buffer);
        context_.api().record_fill(queue_.next_command(), memory.buffer.get(), offset, bytes, word);
        memory.last_batch = queue_.batch();
    }

    void do_dispatch(const Kernel& kernel, std::span<const Buffer* const> buffers,
                     std::span<const std::byte> params, std::uint32_t groups) override {
        const auto& api = context_.api();
        auto& program = static_cast<VulkanProgram&>(kernel.program());
        const auto& pipeline = program.pipeline;
        const auto commands = queue_.next_command();
        const auto set = make_set(pipeline, buffers);
        api.record_pipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
        api.record_sets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.layout(), 0, 1, &set, 0,
                        nullptr);
        if (!params.empty()) {
            api.record_params(commands, pipeline.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                              static_cast<std::uint32_t>(params.size()), params.data());
        }
        queue_.start_timing(commands, kernel.spec().operation + "." + kernel.spec().entry);
        // A row of groups too long for one axis is folded; the kernels drop those past the end.
        const auto rows = (groups - 1) / context_.limits().maxComputeWorkGroupCount[0] + 1;
        api.record_dispatch(commands, (groups - 1) / rows + 1, rows, 1);
        queue_.stop_timing(commands);
        program.last_batch = queue_.batch();
        for (const Buffer* buffer : buffers) {
            memory_of(*buffer).last_batch = queue_.batch();
        }
    }

    VkDescriptorSet make_set(const VulkanPipeline& pipeline,
                             std::span<const Buffer* const> buffers) {
        const auto set = queue_.make_set(pipeline.set_layout());
        std::vector<VkDescriptorBufferInfo> infos(buffers.size());
        std::vector<VkWriteDescriptorSet> writes(buffers.size());
        for (std::size_t i = 0; i < buffers.size(); ++i) {
            infos[i] = {memory_of(*buffers[i]).buffer.get(), 0, VK_WHOLE_SIZE};
            writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
            writes[i].dstSet = set;
            writes[i].dstBinding = static_cast<std::uint32_t>(i);
            writes[i].descriptorCount = 1;
            writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            writes[i].pBufferInfo = &infos[i];
        }
        context_.api().update_sets(context_.device(), static_cast<std::uint32_t>(writes.size()),
                                   writes.data(), 0, nullptr);
        return set;
    }

    void do_finish() override { queue_.finish(); }

    std::vector<DispatchTime> do_take_times() override { return queue_.take_times(); }

    VulkanPlace place_;
    VulkanContext context_;
    VulkanQueue queue_;
};

} // namespace

std::unique_ptr<Device> open_vulkan_device(const DeviceInfo& info, const DeviceOptions& options) {
    return std::make_unique<VulkanDevice>(info, options);
}

} // namespace zonegrid::device
