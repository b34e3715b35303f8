#include "device/opencl_api.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace zonegrid::device {

std::string opencl_code_name(cl_int code) {
    switch (code) {
        case CL_DEVICE_NOT_FOUND:
            return "CL_DEVICE_NOT_FOUND";
        case CL_DEVICE_NOT_AVAILABLE:
            return "CL_DEVICE_NOT_AVAILABLE";
        case CL_COMPILER_NOT_AVAILABLE:
            return "CL_COMPILER_NOT_AVAILABLE";
        case CL_MEM_OBJECT_ALLOCATION_FAILURE:
            return "CL_MEM_OBJECT_ALLOCATION_FAILURE";
        case CL_OUT_OF_RESOURCES:
            return "CL_OUT_OF_RESOURCES";
        case CL_OUT_OF_HOST_MEMORY:
            return "CL_OUT_OF_HOST_MEMORY";
        case CL_PROFILING_INFO_NOT_AVAILABLE:
            return "CL_PROFILING_INFO_NOT_AVAILABLE";
        case CL_BUILD_PROGRAM_FAILURE:
            return "CL_BUILD_PROGRAM_FAILURE";
        case CL_INVALID_VALUE:
            return "CL_INVALID_VALUE";
        case CL_INVALID_DEVICE:
            return "CL_INVALID_DEVICE";
        case CL_INVALID_CONTEXT:
            return "CL_INVALID_CONTEXT";
        case CL_INVALID_QUEUE_PROPERTIES:
            return "CL_INVALID_QUEUE_PROPERTIES";
        case CL_INVALID_COMMAND_QUEUE:
            return "CL_INVALID_COMMAND_QUEUE";
        case CL_INVALID_MEM_OBJECT:
            return "CL_INVALID_MEM_OBJECT";
        case CL_INVALID_BINARY:
            return "CL_INVALID_BINARY";
        case CL_INVALID_BUILD_OPTIONS:
            return "CL_INVALID_BUILD_OPTIONS";
        case CL_INVALID_PROGRAM:
            return "CL_INVALID_PROGRAM";
        case CL_INVALID_PROGRAM_EXECUTABLE:
            return "CL_INVALID_PROGRAM_EXECUTABLE";
        case CL_INVALID_KERNEL_NAME:
            return "CL_INVALID_KERNEL_NAME";
        case CL_INVALID_KERNEL_DEFINITION:
            return "CL_INVALID_KERNEL_DEFINITION";
        case CL_INVALID_KERNEL:
            return "CL_INVALID_KERNEL";
        case CL_INVALID_ARG_INDEX:
            return "CL_INVALID_ARG_INDEX";
        case CL_INVALID_ARG_VALUE:
            return "CL_INVALID_ARG_VALUE";
        case CL_INVALID_ARG_SIZE:
            return "CL_INVALID_ARG_SIZE";
        case CL_INVALID_KERNEL_ARGS:
            return "CL_INVALID_KERNEL_ARGS";
        case CL_INVALID_WORK_GROUP_SIZE:
            return "CL_INVALID_WORK_GROUP_SIZE";
        case CL_INVALID_OPERATION:
            return "CL_INVALID_OPERATION";
        case CL_INVALID_BUFFER_SIZE:
            return "CL_INVALID_BUFFER_SIZE";
        case CL_INVALID_GLOBAL_WORK_SIZE:
            return "CL_INVALID_GLOBAL_WORK_SIZE";
        case -1001:
            return "CL_PLATFORM_NOT_FOUND_KHR";
        default:
            return fmt::format("code {}", code);
    }
}

namespace {

bool is_memory_code(cl_int code) {
    return code == CL_MEM_OBJECT_ALLOCATION_FAILURE || code == CL_OUT_OF_RESOURCES ||
           code == CL_OUT_OF_HOST_MEMORY;
}

const char* remedy_for(cl_int code) {
    if (code == CL_OUT_OF_RESOURCES) {
        // Drivers say so of memory, of a kernel that they stopped, and of a device that is gone.
        return "if it is out of memory, take larger cells, a shorter range or a device with more; "
               "if "
               "it was reset or a kernel was stopped, which the system's log tells, start a new "
               "map";
    }
    return is_memory_code(code) ? "take larger cells, a shorter range or a device with more memory"
                                : "look for a newer driver or choose another device";
}

} // namespace

std::string opencl_text(std::string buffer) {
    buffer.erase(std::min(buffer.find('\0'), buffer.size()));
    return buffer;
}

void check_opencl(cl_int code, const char* call, const std::string& device) {
    if (code == CL_SUCCESS) {
        return;
    }
    throw DeviceError(device, fmt::format("{} failed with {}", call, opencl_code_name(code)),
                      remedy_for(code));
}

void check_opencl_memory(cl_int code, const char* call, const std::string& device) {
    if (is_memory_code(code)) {
        throw CapacityError(fmt::format("{} has no more memory: {} failed with {}", device, call,
                                        opencl_code_name(code)));
    }
    check_opencl(code, call, device);
}

} // namespace zonegrid::device
