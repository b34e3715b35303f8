#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// A thin layer over OpenCL 1.2 and Vulkan 1.1: what a device is, its memory, its kernels, and one
// queue that runs in order. docs/backends.md tells how to choose a device.

namespace zonegrid::device {

inline constexpr std::uint32_t default_group_items = 128;
inline constexpr std::uint32_t max_kernel_buffers = 16;
inline constexpr std::size_t max_params_bytes = 128; ///< Vulkan's least push constants

struct DeviceLimits {
    std::uint64_t buffer_bytes = 0;   ///< largest single buffer
    std::uint64_t memory_bytes = 0;   ///< of the device, or of the machine where memory is unified
    std::uint32_t group_items = 0;    ///< largest work-group
    std::uint32_t local_bytes = 0;    ///< memory shared by a work-group
    std::uint32_t kernel_buffers = 0; ///< most of a kernel, at most max_kernel_buffers
    bool unified_memory = false;      ///< host and device share memory: no copies
    bool timestamps = false;          ///< dispatches can be timed
};

struct DeviceInfo {
    std::string backend;     ///< "opencl" or "vulkan"
    std::uint32_t index = 0; ///< within the backend
    std::string name;        ///< as its driver calls it
    std::string type;        ///< "CPU", "integrated GPU", "discrete GPU", "virtual GPU" or "other"
    std::string driver;      ///< name and version
    std::string api;         ///< "OpenCL 3.0", "Vulkan 1.3"
    DeviceLimits limits;
    std::string refusal; ///< why it cannot be used; empty if it can

    /// What `open_device` takes: "opencl:0".
    [[nodiscard]] std::string id() const { return backend + ":" + std::to_string(index); }
};

struct DeviceList {
    std::vector<DeviceInfo> devices; ///< OpenCL's first; each in its drivers' order
    /// One sentence for each loader or driver that offers nothing, with the remedy.
    std::vector<std::string> missing;
};

/// All devices of this machine, the unusable ones with the reason. Never throws because of a
/// driver. The libraries of OpenCL and Vulkan are looked for when called; ZONEGRID_OPENCL_LIBRARY
/// and ZONEGRID_VULKAN_LIBRARY name others than libOpenCL.so.1 and libvulkan.so.1.
[[nodiscard]] DeviceList list_devices();

/// Memory of a device; goes back when destroyed. Its Device lives longer.
class Buffer {
public:
    /// What a backend keeps of it.
    class Memory {
    public:
        virtual ~Memory() = default;
    };

    /// What counts the bytes of a device's buffers: takes these off when the buffer goes.
    struct TakeOff {
        std::uint64_t bytes = 0;
        void operator()(std::uint64_t* held) const { *held -= bytes; }
    };
    using Share = std::unique_ptr<std::uint64_t, TakeOff>;

    Buffer(const void* owner, std::uint64_t bytes, Share share, std::unique_ptr<Memory> memory)
        : owner_(owner), bytes_(bytes), share_(std::move(share)), memory_(std::move(memory)) {}

    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    [[nodiscard]] const void* owner() const { return owner_; }
    [[nodiscard]] Memory& memory() const { return *memory_; }

private:
    const void* owner_;
    std::uint64_t bytes_;
    Share share_; ///< outlives the memory
    std::unique_ptr<Memory> memory_;
};

/// Which kernel, and what it takes. Its buffers are bindings 0, 1, ... of the shader and the first
/// arguments of the OpenCL kernel; its params are push constants, and the last argument.
struct KernelSpec {
    std::string operation;    ///< file kernels/<operation>.cl, shaders/<operation>.comp
    std::string entry;        ///< name of the kernel in the file
    std::uint32_t buffers;    ///< how many
    std::size_t params_bytes; ///< 0 .. max_params_bytes, a multiple of 4
    /// Most of a work-group. The kernel that is made tells how many it got: a device may allow
    /// fewer, and some allow fewer to a kernel than they say of themselves.
    std::uint32_t group_items = default_group_items;
};

/// The kernel in the languages of both backends.
struct KernelCode {
    std::string_view opencl_source;
    std::span<const std::uint32_t> spirv;
};

/// A kernel, ready to run on the device that made it. Its Device lives longer.
class Kernel {
public:
    /// What a backend keeps of it.
    class Program {
    public:
        virtual ~Program() = default;
    };

    Kernel(const void* owner, KernelSpec spec, std::unique_ptr<Program> program)
        : owner_(owner), spec_(std::move(spec)), program_(std::move(program)) {}

    [[nodiscard]] const KernelSpec& spec() const { return spec_; }
    /// Work-groups that hold `items` items.
    [[nodiscard]] std::uint32_t groups_for(std::uint32_t items) const {
        return items / spec_.group_items + (items % spec_.group_items != 0 ? 1U : 0U);
    }
    [[nodiscard]] const void* owner() const { return owner_; }
    [[nodiscard]] Program& program() const { return *program_; }

private:
    const void* owner_;
    KernelSpec spec_;
    std::unique_ptr<Program> program_;
};

struct DispatchTime {
    std::string kernel; ///< operation.entry
    double seconds = 0; ///< on the device
};

struct DeviceOptions {
    bool timestamps = false;    ///< time every dispatch
    bool unified_memory = true; ///< false: copy as if the device had its own memory
    /// Most that its buffers hold together, so that others can use the device too; 0: no limit.
    std::uint64_t memory_limit_bytes = 0;
};

/// A device with one queue. What is asked of it runs in the order in which it was asked, and each
/// step sees all that the steps before it wrote. Not for several threads at once. All calls throw
/// DeviceError if the driver fails, and UsageError for arguments that cannot work (ranges outside a
/// buffer, buffers or kernels of another device, wrong number of buffers).
class Device {
public:
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    virtual ~Device() = default;

    [[nodiscard]] const DeviceInfo& info() const { return info_; }

    /// Contents are undefined. Throws CapacityError beyond `limits.buffer_bytes`, beyond
    /// `DeviceOptions::memory_limit_bytes`, and where the driver has no more memory. Some drivers
    /// take memory only when it is used: then a later call throws DeviceError.
    [[nodiscard]] Buffer make_buffer(std::uint64_t bytes);

    /// What the buffers hold that are alive, and what may be added to it.
    [[nodiscard]] std::uint64_t held_bytes() const { return held_bytes_; }
    [[nodiscard]] std::uint64_t spare_bytes() const;

    /// Builds a kernel that is embedded in the library.
    [[nodiscard]] Kernel make_kernel(const KernelSpec& spec);
    /// Builds any other. OpenCL's errors come with the compiler's log.
    [[nodiscard]] Kernel make_kernel(const KernelSpec& spec, const KernelCode& code);

    /// Copies to or from `buffer` at `offset` bytes; returns once `bytes` may be reused or read.
    void upload(Buffer& buffer, std::uint64_t offset, std::span<const std::byte> bytes);
    void download(const Buffer& buffer, std::uint64_t offset, std::span<std::byte> bytes);

    /// Sets `bytes` bytes from `offset` on, both multiples of 4, to a word's repetition.
    void fill(Buffer& buffer, std::uint64_t offset, std::uint64_t bytes, std::uint32_t word);

    /// Runs `groups` work-groups of `kernel.spec().group_items` items. Work may start later, but no
    /// later than at `finish` or `download`.
    void dispatch(const Kernel& kernel, std::span<const Buffer* const> buffers,
                  std::span<const std::byte> params, std::uint32_t groups);

    /// Waits for everything asked so far.
    void finish() { do_finish(); }

    /// Waits, and returns the dispatches since the last call, in order. Needs
    /// `DeviceOptions::timestamps`.
    [[nodiscard]] std::vector<DispatchTime> take_times();

protected:
    Device(DeviceInfo info, const DeviceOptions& options)
        : info_(std::move(info)), options_(options) {}

    [[nodiscard]] const DeviceOptions& options() const { return options_; }

private:
    virtual std::unique_ptr<Buffer::Memory> do_make_buffer(std::uint64_t bytes) = 0;
    /// May lower `spec.group_items`.
    virtual std::unique_ptr<Kernel::Program> do_make_kernel(KernelSpec& spec,
                                                            const KernelCode& code) = 0;
    virtual void do_upload(Buffer& buffer, std::uint64_t offset,
                           std::span<const std::byte> bytes) = 0;
    virtual void do_download(const Buffer& buffer, std::uint64_t offset,
                             std::span<std::byte> bytes) = 0;
    virtual void do_fill(Buffer& buffer, std::uint64_t offset, std::uint64_t bytes,
                         std::uint32_t word) = 0;
    virtual void do_dispatch(const Kernel& kernel, std::span<const Buffer* const> buffers,
                             std::span<const std::byte> params, std::uint32_t groups) = 0;
    virtual void do_finish() = 0;
    virtual std::vector<DispatchTime> do_take_times() = 0;

    DeviceInfo info_;
    DeviceOptions options_;
    std::uint64_t held_bytes_ = 0;
};

/// Opens a device by name: "opencl:1", or "vulkan" for the first usable one of a backend.
/// Throws DeviceError, saying what was found, if there is none or if it is refused.
[[nodiscard]] std::unique_ptr<Device> open_device(std::string_view name,
                                                  const DeviceOptions& options = {});

} // namespace zonegrid::device
