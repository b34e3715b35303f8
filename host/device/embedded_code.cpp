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

std::string only_entry(std::string_view source, std::string_view entry) {
    const auto head = fmt::format(" void {}(", entry);
    std::string text;
    bool keep = true;
    while (!source.empty()) {
        const auto line = source.substr(0, std::min(source.find('\n'), source.size() - 1) + 1);
        source.remove_prefix(line.size());
        if (line.starts_with("__kernel ")) {
            keep = line.find(head) != std::string_view::npos;
        }
        text += keep ? line : "\n";
        keep = keep || line == "}\n";
    }
    return text;
}

} // namespace zonegrid::device
