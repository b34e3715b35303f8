#include "device/embedded_code.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

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

namespace {

/// "file:line" of each line of a text with #line directives.
std::vector<std::string> origins_of(std::string_view source) {
    static const std::regex directive(R"re(#line (\d+) "(.+)")re");
    std::vector<std::string> origins;
    std::string file;
    std::size_t line = 0;
    std::istringstream lines{std::string(source)};
    for (std::string text; std::getline(lines, text);) {
        origins.push_back(fmt::format("{}:{}", file, line));
        std::smatch match;
        if (std::regex_match(text, match, directive)) {
            line = std::stoul(match[1]);
            file = match[2];
        } else {
            ++line;
        }
    }
    return origins;
}

} // namespace

std::string name_lines(std::string_view log, std::string_view source) {
    static const std::regex place(R"(<kernel>:(\d{1,6}))");
    const auto origins = origins_of(source);
    std::string text(log);
    std::string named;
    std::smatch match;
    while (std::regex_search(text, match, place)) {
        const std::size_t line = std::stoul(match[1]);
        const bool known = line >= 1 && line <= origins.size();
        named += match.prefix().str() + (known ? origins[line - 1] : match.str());
        text = match.suffix();
    }
    return named + text;
}

} // namespace zonegrid::device
