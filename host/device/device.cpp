#include "device/device.h"

#include "device/backends.h"
#include "device/device_choice.h"
#include "device/embedded_code.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace zonegrid::device {

namespace {

double megabytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / (1U << 20U);
}

void require_range(const Buffer& buffer, std::uint64_t offset, std::uint64_t bytes) {
    if (offset > buffer.bytes() || bytes > buffer.bytes() - offset) {
        throw UsageError(fmt::format("{} bytes at {} of a buffer of {} bytes: keep inside it",
                                     bytes, offset, buffer.bytes()));
    }
}

void require_owner(const void* owner, const Device& device, const char* what) {
    if (owner != &device) {
        throw UsageError(
            fmt::format("a {} of another device was handed to {}: make it with the "
                        "device that uses it",
                        what, device.info().id()));
    }
}

void require_spec(const KernelSpec& spec, const DeviceInfo& info) {
    const auto kernel = spec.operation + "." + spec.entry;
    if (spec.params_bytes > max_params_bytes || spec.params_bytes % 4 != 0) {
        throw UsageError(
            fmt::format("kernel {} has {} bytes of params: at most {}, a multiple of 4", kernel,
                        spec.params_bytes, max_params_bytes));
    }
    if (spec.group_items == 0) {
        throw UsageError(fmt::format("kernel {} has work-groups of 0 items: ask for 1", kernel));
    }
    if (spec.buffers > info.limits.kernel_buffers) {
        throw CapacityError(fmt::format("kernel {} takes {} buffers: {} allows {}", kernel,
                                        spec.buffers, info.id(), info.limits.kernel_buffers));
    }
}

} // namespace

std::unique_ptr<Device> open_device(std::string_view name, const DeviceOptions& options) {
    const DeviceInfo chosen = find_device(name);
    if (options.timestamps && !chosen.limits.timestamps) {
        throw DeviceError(chosen.id(), chosen.name + " cannot time its work",
                          "open it without timestamps");
    }
    return chosen.backend == "opencl" ? open_opencl_device(chosen, options)
                                      : open_vulkan_device(chosen, options);
}

Buffer Device::make_buffer(std::uint64_t bytes) {
    if (bytes == 0) {
        throw UsageError("a buffer of 0 bytes was asked for: ask for at least 1");
    }
    if (bytes > info_.limits.buffer_bytes) {
        throw CapacityError(fmt::format("a buffer of {} bytes was asked for: {} ({}) allows {}",
                                        bytes, info_.id(), info_.name, info_.limits.buffer_bytes));
    }
    if (bytes > spare_bytes()) {
        throw CapacityError(
            fmt::format("{} ({}) has no room for a buffer of {:.1f} MB: {:.1f} MB of its limit of "
                        "{:.1f} MB are taken",
                        info_.id(), info_.name, megabytes(bytes), megabytes(held_bytes_),
                        megabytes(options_.memory_limit_bytes)));
    }
    auto memory = do_make_buffer(bytes);
    held_bytes_ += bytes;
    return {this, bytes, Buffer::Share(&held_bytes_, {bytes}), std::move(memory)};
}

std::uint64_t Device::spare_bytes() const {
    const auto limit = options_.memory_limit_bytes;
    return limit == 0            ? std::numeric_limits<std::uint64_t>::max()
           : limit > held_bytes_ ? limit - held_bytes_
                                 : 0;
}

Kernel Device::make_kernel(const KernelSpec& spec) {
    return make_kernel(spec, embedded_code(spec.operation, spec.entry));
}

Kernel Device::make_kernel(const KernelSpec& spec, const KernelCode& code) {
    require_spec(spec, info_);
    KernelSpec made = spec;
    made.group_items = std::min(spec.group_items, info_.limits.group_items);
    auto program = do_make_kernel(made, code);
    return {this, std::move(made), std::move(program)};
}

void Device::upload(Buffer& buffer, std::uint64_t offset, std::span<const std::byte> bytes) {
    require_owner(buffer.owner(), *this, "buffer");
    require_range(buffer, offset, bytes.size());
    if (!bytes.empty()) {
        do_upload(buffer, offset, bytes);
    }
}

void Device::download(const Buffer& buffer, std::uint64_t offset, std::span<std::byte> bytes) {
    require_owner(buffer.owner(), *this, "buffer");
    require_range(buffer, offset, bytes.size());
    if (!bytes.empty()) {
        do_download(buffer, offset, bytes);
    }
}

void Device::fill(Buffer& buffer, std::uint64_t offset, std::uint64_t bytes, std::uint32_t word) {
    require_owner(buffer.owner(), *this, "buffer");
    require_range(buffer, offset, bytes);
    if (offset % 4 != 0 || bytes % 4 != 0) {
        throw UsageError(
            fmt::format("fill of {} bytes at {}: both must be multiples of 4", bytes, offset));
    }
    if (bytes != 0) {
        do_fill(buffer, offset, bytes, word);
    }
}

void Device::dispatch(const Kernel& kernel, std::span<const Buffer* const> buffers,
                      std::span<const std::byte> params, std::uint32_t groups) {
    const auto& spec = kernel.spec();
    require_owner(kernel.owner(), *this, "kernel");
    for (const Buffer* buffer : buffers) {
        require_owner(buffer->owner(), *this, "buffer");
    }
    if (buffers.size() != spec.buffers || params.size() != spec.params_bytes) {
        throw UsageError(
            fmt::format("kernel {}.{} got {} buffers and {} bytes of params: it takes {} "
                        "and {}",
                        spec.operation, spec.entry, buffers.size(), params.size(), spec.buffers,
                        spec.params_bytes));
    }
    if (groups != 0) {
        do_dispatch(kernel, buffers, params, groups);
    }
}

std::vector<DispatchTime> Device::take_times() {
    if (!options_.timestamps) {
        throw UsageError("times of a device that was opened without timestamps: open it with them");
    }
    return do_take_times();
}

} // namespace zonegrid::device
