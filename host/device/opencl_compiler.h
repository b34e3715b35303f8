#pragma once

#include "device/device.h"
#include "device/kernel_cache.h"
#include "device/opencl_api.h"

#include <optional>
#include <string>
#include <vector>

namespace zonegrid::device {

/// A kernel and the program it is of.
struct OpenClKernel {
    OpenClHandle<cl_program> program;
    OpenClHandle<cl_kernel> kernel;
};

/// Compiles kernels for one device, or takes them from the user's cache. What it refers to lives
/// longer.
class OpenClCompiler {
public:
    OpenClCompiler(const OpenClApi& api, const DeviceInfo& info, cl_device_id device,
                   cl_context context);

    /// Throws DeviceError, with the compiler's log, if the source does not compile.
    [[nodiscard]] OpenClKernel make(const KernelSpec& spec, const KernelCode& code) const;

private:
    void check(cl_int code, const char* call) const { check_opencl(code, call, info_.id()); }
    [[nodiscard]] cl_int build(cl_program program, const std::string& options) const;
    [[nodiscard]] OpenClHandle<cl_kernel> find_kernel(cl_program program, const KernelSpec& spec,
                                                      cl_int& result) const;
    [[nodiscard]] std::optional<OpenClKernel> make_from_binary(const KernelSpec& spec,
                                                               const std::vector<std::byte>& binary,
                                                               const std::string& options) const;
    [[nodiscard]] OpenClKernel make_from_source(const KernelSpec& spec, const std::string& source,
                                                const std::string& options) const;
    [[nodiscard]] std::vector<std::byte> binary_of(cl_program program) const;
    [[nodiscard]] std::string build_log(cl_program program) const;

    const OpenClApi& api_;
    const DeviceInfo& info_;
    cl_device_id device_;
    cl_context context_;
    KernelCache cache_ = KernelCache::of_user();
    KernelKey device_key_;
};

} // namespace zonegrid::device
