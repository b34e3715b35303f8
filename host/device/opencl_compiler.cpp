#include "device/opencl_compiler.h"

#include "device/embedded_code.h"
#include "device/opencl_devices.h"
#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <utility>

namespace zonegrid::device {

OpenClCompiler::OpenClCompiler(const OpenClApi& api, const DeviceInfo& info, cl_device_id device,
                               cl_context context)
    : api_(api), info_(info), device_(device), context_(context) {
    for (const auto& text : opencl_identity(api, device)) {
        device_key_.add(text);
    }
}

OpenClKernel OpenClCompiler::make(const KernelSpec& spec, const KernelCode& code) const {
    const auto source = only_entry(code.opencl_source, spec.entry);
    const auto options = fmt::format("-cl-std=CL1.2 -D ZG_GROUP_ITEMS={}", spec.group_items);
    if (cache_.folder().empty()) {
        return make_from_source(spec, source, options);
    }
    KernelKey key = device_key_;
    key.add(options).add(source);
    if (const auto binary = cache_.find(key)) {
        if (auto made = make_from_binary(spec, *binary, options)) {
            return std::move(*made);
        }
    }
    auto made = make_from_source(spec, source, options);
    const auto binary = binary_of(made.program.get());
    if (!binary.empty()) {
        cache_.keep(key, binary);
    }
    return made;
}

cl_int OpenClCompiler::build(cl_program program, const std::string& options) const {
    return api_.build_program(program, 1, &device_, options.c_str(), nullptr, nullptr);
}

OpenClHandle<cl_kernel> OpenClCompiler::find_kernel(cl_program program, const KernelSpec& spec,
                                                    cl_int& result) const {
    return {api_.create_kernel(program, spec.entry.c_str(), &result), api_.release_kernel};
}

std::optional<OpenClKernel> OpenClCompiler::make_from_binary(const KernelSpec& spec,
                                                             const std::vector<std::byte>& binary,
                                                             const std::string& options) const {
    const std::size_t length = binary.size();
    const auto* bytes = reinterpret_cast<const unsigned char*>(binary.data());
    cl_int result = CL_SUCCESS;
    OpenClHandle<cl_program> program(
        api_.create_program_with_binary(context_, 1, &device_, &length, &bytes, nullptr, &result),
        api_.release_program);
    if (result != CL_SUCCESS || build(program.get(), options) != CL_SUCCESS) {
        return std::nullopt; // the driver knows best: from the source, then
    }
    auto kernel = find_kernel(program.get(), spec, result);
    if (result != CL_SUCCESS) {
        return std::nullopt;
    }
    return OpenClKernel{std::move(program), std::move(kernel)};
}

OpenClKernel OpenClCompiler::make_from_source(const KernelSpec& spec, const std::string& source,
                                              const std::string& options) const {
    const char* text = source.data();
    const std::size_t length = source.size();
    cl_int result = CL_SUCCESS;
    OpenClHandle<cl_program> program(api_.create_program(context_, 1, &text, &length, &result),
                                     api_.release_program);
    check(result, "clCreateProgramWithSource");
    result = build(program.get(), options);
    if (result != CL_SUCCESS) {
        throw DeviceError(
            info_.id(),
            fmt::format("clBuildProgram failed with {} for kernels/{}.cl on {} ({}), its log: {}",
                        opencl_code_name(result), spec.operation, info_.name, info_.driver,
                        name_lines(build_log(program.get()), source)),
            "correct the kernel, or look for a newer driver");
    }
    auto kernel = find_kernel(program.get(), spec, result);
    check(result, "clCreateKernel");
    return {std::move(program), std::move(kernel)};
}

std::vector<std::byte> OpenClCompiler::binary_of(cl_program program) const {
    std::size_t size = 0; // of the program's one device
    if (api_.get_program_info(program, CL_PROGRAM_BINARY_SIZES, sizeof(size), &size, nullptr) !=
        CL_SUCCESS) {
        return {};
    }
    std::vector<std::byte> binary(size);
    auto* bytes = reinterpret_cast<unsigned char*>(binary.data());
    if (size == 0 || api_.get_program_info(program, CL_PROGRAM_BINARIES, sizeof(bytes), &bytes,
                                           nullptr) != CL_SUCCESS) {
        return {};
    }
    return binary;
}

std::string OpenClCompiler::build_log(cl_program program) const {
    std::size_t size = 0;
    if (api_.get_build_info(program, device_, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size) !=
            CL_SUCCESS ||
        size == 0) {
        return "none";
    }
    std::string log(size, '\0');
    if (api_.get_build_info(program, device_, CL_PROGRAM_BUILD_LOG, size, log.data(), nullptr) !=
        CL_SUCCESS) {
        return "none";
    }
    return opencl_text(std::move(log));
}

} // namespace zonegrid::device
