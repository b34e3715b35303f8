#include "device/embedded_code.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace zonegrid::device {

KernelCode embedded_code(std::string_view operation, std::string_view entry) {
    const auto source =
        std::ranges::find(embedded_sources(), operation, &EmbeddedSource::operation);
    const auto shader = std::ranges::find_if(embedded_shaders(), [&](const auto& candidate) {
        return candidate.operation == operation && candidate.entry == entry;
    });
    if (source == embedded_sources().end() || shader == embedded_shaders().end()) {
        throw UsageError(fmt::format(
            "kernel {}.{} is not in the library: name a kernel of kernels/", operation, entry));
    }
    return {source->text, shader->words};
}

} // namespace zonegrid::device
