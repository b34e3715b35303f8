#pragma once

#include "device/device.h"

#include <cstdint>
#include <span>
#include <string_view>

// The kernels that cmake/embed_kernels.cmake puts into the library.

namespace zonegrid::device {

struct EmbeddedSource {
    std::string_view operation;
    std::string_view text; ///< OpenCL C, includes flattened, with #line
};

struct EmbeddedShader {
    std::string_view operation;
    std::string_view entry;
    std::span<const std::uint32_t> words; ///< SPIR-V; its entry point is "main"
};

[[nodiscard]] std::span<const EmbeddedSource> embedded_sources();
[[nodiscard]] std::span<const EmbeddedShader> embedded_shaders();

/// Throws UsageError if the library has no such kernel.
[[nodiscard]] KernelCode embedded_code(std::string_view operation, std::string_view entry);

} // namespace zonegrid::device
