#include "device/backends.h"
#include "device/opencl_api.h"
#include "device/opencl_compiler.h"
#include "device/opencl_devices.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zonegrid::device {

namespace {

class OpenClMemory : public Buffer::Memory {
public:
    explicit OpenClMemory(OpenClHandle<cl_mem> memory) : memory_(std::move(memory)) {}

    [[nodiscard]] cl_mem get() const { return memory_.get(); }

private:
    OpenClHandle<cl_mem> memory_;
};

class OpenClProgram : public Kernel::Program {
public:
    explicit OpenClProgram(OpenClKernel made) : made_(std::move(made)) {}

    [[nodiscard]] cl_kernel kernel() const { return made_.kernel.get(); }

private:
    OpenClKernel made_;
};

cl_mem memory_of(const Buffer& buffer) {
    return static_cast<OpenClMemory&>(buffer.memory()).get();
}

class OpenClDevice : public Device {
public:
    OpenClDevice(const DeviceInfo& info, const DeviceOptions& chosen) : Device(info, chosen) {
        const auto found = find_opencl_devices(api_);
        if (info.index >= found.devices.size()) {
            throw DeviceError(info.id(), "the device is gone since it was listed",
                              "list the devices again");
        }
        device_ = found.devices[info.index];
        cl_int code = CL_SUCCESS;
        context_.reset(api_.create_context(nullptr, 1, &device_, nullptr, nullptr, &code));
        check(code, "clCreateContext");
        queue_.reset(api_.create_queue(context_.get(), device_,
                                       chosen.timestamps ? CL_QUEUE_PROFILING_ENABLE : 0, &code));
        check(code, "clCreateCommandQueue");
        compiler_.emplace(api_, this->info(), device_, context_.get());
    }

private:
    struct TimedDispatch {
        std::string kernel;
        OpenClHandle<cl_event> event;
    };

    void check(cl_int code, const char* call) const { check_opencl(code, call, info().id()); }

    std::unique_ptr<Buffer::Memory> do_make_buffer(std::uint64_t bytes) override {
        // Memory that the host can reach too: where it is shared, nothing is copied twice.
        const bool shared = info().limits.unified_memory && options().unified_memory;
        const cl_mem_flags flags = CL_MEM_READ_WRITE | (shared ? CL_MEM_ALLOC_HOST_PTR : 0);
        cl_int code = CL_SUCCESS;
        OpenClHandle<cl_mem> memory(
            api_.create_buffer(context_.get(), flags, bytes, nullptr, &code), api_.release_memory);
        check_opencl_memory(code, "clCreateBuffer", info().id());
        return std::make_unique<OpenClMemory>(std::move(memory));
    }

    std::unique_ptr<Kernel::Program> do_make_kernel(KernelSpec& spec,
                                                    const KernelCode& code) override {
        while (true) {
            auto made = compiler_->make(spec, code);
            std::size_t most_items = 0;
            check(api_.get_kernel_work_group_info(made.kernel.get(), device_,
                                                  CL_KERNEL_WORK_GROUP_SIZE, sizeof(most_items),
                                                  &most_items, nullptr),
                  "clGetKernelWorkGroupInfo");
            if (most_items >= spec.group_items) {
                return std::make_unique<OpenClProgram>(std::move(made));
            }
            if (most_items == 0) {
                throw DeviceError(info().id(),
                                  fmt::format("kernel {}.{} fits into no work-group here",
                                              spec.operation, spec.entry),
                                  "choose another device");
            }
            spec.group_items = static_cast<std::uint32_t>(most_items); // less each time: it ends
        }
    }

    void do_upload(Buffer& buffer, std::uint64_t offset,
                   std::span<const std::byte> bytes) override {
        check(api_.write_buffer(queue_.get(), memory_of(buffer), CL_TRUE, offset, bytes.size(),
                                bytes.data(), 0, nullptr, nullptr),
              "clEnqueueWriteBuffer");
    }

    void do_download(const Buffer& buffer, std::uint64_t offset,
                     std::span<std::byte> bytes) override {
        check(api_.read_buffer(queue_.get(), memory_of(buffer), CL_TRUE, offset, bytes.size(),
                               bytes.data(), 0, nullptr, nullptr),
              "clEnqueueReadBuffer");
    }

    void do_fill(Buffer& buffer, std::uint64_t offset, std::uint64_t bytes,
                 std::uint32_t word) override {
        check(api_.fill_buffer(queue_.get(), memory_of(buffer), &word, sizeof(word), offset, bytes,
                               0, nullptr, nullptr),
              "clEnqueueFillBuffer");
    }

    void do_dispatch(const Kernel& kernel, std::span<const Buffer* const> buffers,
                     std::span<const std::byte> params, std::uint32_t groups) override {
        const auto function = static_cast<OpenClProgram&>(kernel.program()).kernel();
        cl_uint argument = 0;
        for (const Buffer* buffer : buffers) {
            cl_mem memory = memory_of(*buffer);
            check(api_.set_kernel_argument(function, argument++, sizeof(cl_mem), &memory),
                  "clSetKernelArg");
        }
        if (!params.empty()) {
            check(api_.set_kernel_argument(function, argument, params.size(), params.data()),
                  "clSetKernelArg");
        }
        const std::size_t group_items = kernel.spec().group_items;
        const std::size_t items = group_items * groups;
        cl_event event = nullptr;
        check(api_.run_kernel(queue_.get(), function, 1, nullptr, &items, &group_items, 0, nullptr,
                              options().timestamps ? &event : nullptr),
              "clEnqueueNDRangeKernel");
        if (event != nullptr) {
            timed_.push_back(
                {kernel.spec().operation + "." + kernel.spec().entry, {event, api_.release_event}});
        }
    }

    void do_finish() override { check(api_.finish(queue_.get()), "clFinish"); }

    std::vector<DispatchTime> do_take_times() override {
        do_finish();
        std::vector<DispatchTime> times;
        times.reserve(timed_.size());
        for (const auto& [kernel, event] : timed_) {
            const auto from_ns = time_ns(event.get(), CL_PROFILING_COMMAND_START);
            const auto to_ns = time_ns(event.get(), CL_PROFILING_COMMAND_END);
            times.push_back({kernel, static_cast<double>(to_ns - from_ns) * 1e-9});
        }
        timed_.clear();
        return times;
    }

    cl_ulong time_ns(cl_event event, cl_profiling_info what) const {
        cl_ulong value = 0;
        check(api_.get_event_times(event, what, sizeof(value), &value, nullptr),
              "clGetEventProfilingInfo");
        return value;
    }

    OpenClApi api_;
    cl_device_id device_ = nullptr;
    OpenClHandle<cl_context> context_{nullptr, api_.release_context};
    OpenClHandle<cl_command_queue> queue_{nullptr, api_.release_queue};
    std::optional<OpenClCompiler> compiler_;
    std::vector<TimedDispatch> timed_;
};

} // namespace

std::unique_ptr<Device> open_opencl_device(const DeviceInfo& info, const DeviceOptions& options) {
    return std::make_unique<OpenClDevice>(info, options);
}

} // namespace zonegrid::device
