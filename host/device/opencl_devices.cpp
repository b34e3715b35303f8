#include "device/opencl_devices.h"

#include "device/backends.h"

#include <fmt/format.h>

#include <charconv>
#include <utility>

namespace zonegrid::device {

namespace {

constexpr const char* backend = "opencl";

std::string platform_text(const OpenClApi& api, cl_platform_id platform, cl_platform_info what) {
    std::size_t size = 0;
    check_opencl(api.get_platform_info(platform, what, 0, nullptr, &size), "clGetPlatformInfo",
                 backend);
    std::string text(size, '\0');
    check_opencl(api.get_platform_info(platform, what, size, text.data(), nullptr),
                 "clGetPlatformInfo", backend);
    return opencl_text(std::move(text));
}

std::string device_text(const OpenClApi& api, cl_device_id device, cl_device_info what) {
    std::size_t size = 0;
    check_opencl(api.get_device_info(device, what, 0, nullptr, &size), "clGetDeviceInfo", backend);
    std::string text(size, '\0');
    check_opencl(api.get_device_info(device, what, size, text.data(), nullptr), "clGetDeviceInfo",
                 backend);
    return opencl_text(std::move(text));
}

template <class Value>
Value device_value(const OpenClApi& api, cl_device_id device, cl_device_info what) {
    Value value{};
    check_opencl(api.get_device_info(device, what, sizeof(value), &value, nullptr),
                 "clGetDeviceInfo", backend);
    return value;
}

std::string type_name(cl_device_type type, bool unified_memory) {
    if ((type & CL_DEVICE_TYPE_CPU) != 0) {
        return "CPU";
    }
    if ((type & CL_DEVICE_TYPE_GPU) != 0) {
        return unified_memory ? "integrated GPU" : "discrete GPU";
    }
    return "other";
}

/// "OpenCL 3.0 PoCL ..." -> 300; 0 if it is no version.
int version_number(std::string_view text) {
    constexpr std::string_view prefix = "OpenCL ";
    int major = 0;
    int minor = 0;
    if (!text.starts_with(prefix)) {
        return 0;
    }
    const char* const end = text.data() + text.size();
    const auto [dot, major_error] = std::from_chars(text.data() + prefix.size(), end, major);
    if (major_error != std::errc{} || dot == end || *dot != '.') {
        return 0;
    }
    const auto [rest, minor_error] = std::from_chars(dot + 1, end, minor);
    return minor_error == std::errc{} ? major * 100 + minor : 0;
}

std::string refusal_of(const OpenClApi& api, cl_device_id device, std::string_view version) {
    if (version_number(version) < 102) {
        return fmt::format("it is \"{}\", OpenCL 1.2 is needed", version);
    }
    if (device_value<cl_bool>(api, device, CL_DEVICE_AVAILABLE) == CL_FALSE) {
        return "its driver says that it is not available";
    }
    if (device_value<cl_bool>(api, device, CL_DEVICE_COMPILER_AVAILABLE) == CL_FALSE) {
        return "its driver has no compiler";
    }
    if (device_value<cl_bool>(api, device, CL_DEVICE_ENDIAN_LITTLE) == CL_FALSE) {
        return "its bytes are in big-endian order";
    }
    cl_int code = CL_SUCCESS;
    const OpenClHandle<cl_context> context(
        api.create_context(nullptr, 1, &device, nullptr, nullptr, &code), api.release_context);
    return code == CL_SUCCESS
               ? ""
               : fmt::format("clCreateContext failed with {}", opencl_code_name(code));
}

DeviceInfo describe(const OpenClApi& api, cl_platform_id platform, cl_device_id device) {
    DeviceInfo info;
    info.backend = backend;
    info.name = device_text(api, device, CL_DEVICE_NAME);
    const bool unified = device_value<cl_bool>(api, device, CL_DEVICE_HOST_UNIFIED_MEMORY) != 0;
    info.type = type_name(device_value<cl_device_type>(api, device, CL_DEVICE_TYPE), unified);
    info.driver = platform_text(api, platform, CL_PLATFORM_NAME) + " " +
                  device_text(api, device, CL_DRIVER_VERSION);
    const auto version = device_text(api, device, CL_DEVICE_VERSION);
    info.api =
        fmt::format("OpenCL {}.{}", version_number(version) / 100, version_number(version) % 100);
    info.limits.buffer_bytes = device_value<cl_ulong>(api, device, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
    info.limits.memory_bytes = device_value<cl_ulong>(api, device, CL_DEVICE_GLOBAL_MEM_SIZE);
    info.limits.group_items = static_cast<std::uint32_t>(
        device_value<std::size_t>(api, device, CL_DEVICE_MAX_WORK_GROUP_SIZE));
    info.limits.local_bytes =
        static_cast<std::uint32_t>(device_value<cl_ulong>(api, device, CL_DEVICE_LOCAL_MEM_SIZE));
    info.limits.kernel_buffers = max_kernel_buffers; // of 1024 bytes of arguments, OpenCL's least
    info.limits.unified_memory = unified;
    info.limits.timestamps = true;
    info.refusal = refusal_of(api, device, version);
    return info;
}

void add_platform(const OpenClApi& api, cl_platform_id platform, OpenClDevices& found) {
    const auto name = platform_text(api, platform, CL_PLATFORM_NAME);
    cl_uint count = 0;
    const cl_int code = api.get_device_ids(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count);
    if (code == CL_DEVICE_NOT_FOUND || (code == CL_SUCCESS && count == 0)) {
        found.list.missing.push_back(fmt::format(
            "opencl: the driver \"{}\" finds no device; connect one that it knows", name));
        return;
    }
    check_opencl(code, "clGetDeviceIDs", backend);
    std::vector<cl_device_id> devices(count);
    check_opencl(api.get_device_ids(platform, CL_DEVICE_TYPE_ALL, count, devices.data(), nullptr),
                 "clGetDeviceIDs", backend);
    for (cl_device_id device : devices) {
        auto info = describe(api, platform, device);
        info.index = static_cast<std::uint32_t>(found.devices.size());
        found.devices.push_back(device);
        found.list.devices.push_back(std::move(info));
    }
}

} // namespace

OpenClDevices find_opencl_devices(const OpenClApi& api) {
    OpenClDevices found;
    cl_uint count = 0;
    const cl_int code = api.get_platform_ids(0, nullptr, &count);
    constexpr cl_int platform_not_found = -1001; // of the loader's extension cl_khr_icd
    if (code == platform_not_found || (code == CL_SUCCESS && count == 0)) {
        found.list.missing.emplace_back(
            "opencl: no driver is installed; install the one of your device, or pocl-opencl-icd "
            "for the CPU");
        return found;
    }
    check_opencl(code, "clGetPlatformIDs", backend);
    std::vector<cl_platform_id> platforms(count);
    check_opencl(api.get_platform_ids(count, platforms.data(), nullptr), "clGetPlatformIDs",
                 backend);
    for (cl_platform_id platform : platforms) {
        try {
            add_platform(api, platform, found);
        } catch (const std::exception& error) {
            found.list.missing.emplace_back(error.what());
        }
    }
    return found;
}

std::vector<std::string> opencl_identity(const OpenClApi& api, cl_device_id device) {
    auto* const platform = device_value<cl_platform_id>(api, device, CL_DEVICE_PLATFORM);
    return {backend,
            platform_text(api, platform, CL_PLATFORM_NAME),
            platform_text(api, platform, CL_PLATFORM_VERSION),
            device_text(api, device, CL_DEVICE_VENDOR),
            device_text(api, device, CL_DEVICE_NAME),
            device_text(api, device, CL_DEVICE_VERSION),
            device_text(api, device, CL_DRIVER_VERSION),
            std::to_string(device_value<cl_uint>(api, device, CL_DEVICE_VENDOR_ID)),
            std::to_string(device_value<cl_uint>(api, device, CL_DEVICE_ADDRESS_BITS))};
}

DeviceList list_opencl_devices() {
    const OpenClApi api;
    return find_opencl_devices(api).list;
}

} // namespace zonegrid::device
