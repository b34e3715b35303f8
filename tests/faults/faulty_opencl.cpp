#include "faulty_call.h"

#include <CL/cl.h>

#include <dlfcn.h>

// Calls that are not here are found in the real loader, on which this one depends.

namespace {

template <class Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, size_t size, void* host,
                      cl_int* code) {
    if (int fault = 0; zonegrid::is_faulty("clCreateBuffer", fault)) {
        *code = fault;
        return nullptr;
    }
    return real<decltype(&clCreateBuffer)>("clCreateBuffer")(context, flags, size, host, code);
}

cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                              const size_t* offset, const size_t* items, const size_t* group_items,
                              cl_uint waits, const cl_event* wait_for, cl_event* event) {
    if (int fault = 0; zonegrid::is_faulty("clEnqueueNDRangeKernel", fault)) {
        return fault;
    }
    return real<decltype(&clEnqueueNDRangeKernel)>("clEnqueueNDRangeKernel")(
        queue, kernel, dimensions, offset, items, group_items, waits, wait_for, event);
}
}
