#pragma once

#include "device/device.h"

#include <cstdint>
#include <span>
#include <string>
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

/// The source without the kernels of other entries, line for line: so that a driver compiles, and
/// the cache keeps, what runs and nothing else. Each begins with a line `__kernel ... void NAME(`
/// and ends with the first line `}` after that.
[[nodiscard]] std::string only_entry(std::string_view source, std::string_view entry);

/// A driver's build log with `<kernel>:LINE` replaced by file and line: NVIDIA's driver counts the
/// lines of the whole text and does not follow its #line directives.
[[nodiscard]] std::string name_lines(std::string_view log, std::string_view source);

} // namespace zonegrid::device
