#pragma once

#include "device/shared_library.h"

#include <CL/cl.h>

#include <memory>
#include <string>
#include <type_traits>

namespace zonegrid::device {

/// OpenCL's functions, loaded at run time so that the library starts where there is no OpenCL.
/// Throws DeviceError if there is none.
class OpenClApi {
    SharedLibrary library_{"opencl", "ZONEGRID_OPENCL_LIBRARY", "libOpenCL.so.1",
                           "install an OpenCL loader (Debian: ocl-icd-libopencl1)"};

public:
    decltype(&clGetPlatformIDs) get_platform_ids = library_.find("clGetPlatformIDs");
    decltype(&clGetPlatformInfo) get_platform_info = library_.find("clGetPlatformInfo");
    decltype(&clGetDeviceIDs) get_device_ids = library_.find("clGetDeviceIDs");
    decltype(&clGetDeviceInfo) get_device_info = library_.find("clGetDeviceInfo");
    decltype(&clCreateContext) create_context = library_.find("clCreateContext");
    decltype(&clReleaseContext) release_context = library_.find("clReleaseContext");
    decltype(&clCreateCommandQueue) create_queue = library_.find("clCreateCommandQueue");
    decltype(&clReleaseCommandQueue) release_queue = library_.find("clReleaseCommandQueue");
    decltype(&clCreateBuffer) create_buffer = library_.find("clCreateBuffer");
    decltype(&clReleaseMemObject) release_memory = library_.find("clReleaseMemObject");
    decltype(&clCreateProgramWithSource) create_program =
        library_.find("clCreateProgramWithSource");
    decltype(&clCreateProgramWithBinary) create_program_with_binary =
        library_.find("clCreateProgramWithBinary");
    decltype(&clBuildProgram) build_program = library_.find("clBuildProgram");
    decltype(&clGetProgramBuildInfo) get_build_info = library_.find("clGetProgramBuildInfo");
    decltype(&clGetProgramInfo) get_program_info = library_.find("clGetProgramInfo");
    decltype(&clReleaseProgram) release_program = library_.find("clReleaseProgram");
    decltype(&clCreateKernel) create_kernel = library_.find("clCreateKernel");
    decltype(&clGetKernelWorkGroupInfo) get_kernel_work_group_info =
        library_.find("clGetKernelWorkGroupInfo");
    decltype(&clSetKernelArg) set_kernel_argument = library_.find("clSetKernelArg");
    decltype(&clReleaseKernel) release_kernel = library_.find("clReleaseKernel");
    decltype(&clEnqueueWriteBuffer) write_buffer = library_.find("clEnqueueWriteBuffer");
    decltype(&clEnqueueReadBuffer) read_buffer = library_.find("clEnqueueReadBuffer");
    decltype(&clEnqueueFillBuffer) fill_buffer = library_.find("clEnqueueFillBuffer");
    decltype(&clEnqueueNDRangeKernel) run_kernel = library_.find("clEnqueueNDRangeKernel");
    decltype(&clFinish) finish = library_.find("clFinish");
    decltype(&clGetEventProfilingInfo) get_event_times = library_.find("clGetEventProfilingInfo");
    decltype(&clReleaseEvent) release_event = library_.find("clReleaseEvent");
};

/// An OpenCL object that is released when destroyed.
template <class Object>
using OpenClHandle = std::unique_ptr<std::remove_pointer_t<Object>, cl_int (*)(Object)>;

/// "CL_OUT_OF_RESOURCES", or the number of a code without a name.
[[nodiscard]] std::string opencl_code_name(cl_int code);

/// Text that OpenCL wrote into `buffer`, which it ends by a zero.
[[nodiscard]] std::string opencl_text(std::string buffer);

/// Throws DeviceError if `code`, which `call` returned, is a failure.
void check_opencl(cl_int code, const char* call, const std::string& device);

/// The same for calls that take memory: throws CapacityError if there is none left.
void check_opencl_memory(cl_int code, const char* call, const std::string& device);

} // namespace zonegrid::device
