#include "zonegrid/options.h"

#include "zonegrid/errors.h"

#include <fmt/format.h>

#include <cmath>

namespace zonegrid {

namespace {

template <class Value>
void require(bool allowed, const char* name, const Value& value, const std::string& rule) {
    if (!allowed) {
        throw UsageError(fmt::format("{} is {}: it must be {}", name, value, rule));
    }
}

} // namespace

bool is_backend_name(std::string_view name) {
    const auto is_of = [name](std::string_view backend) {
        if (!name.starts_with(backend)) {
            return false;
        }
        const std::string_view rest = name.substr(backend.size());
        return rest.empty() || (rest.size() > 1 && rest.front() == ':' &&
                                rest.find_first_not_of("0123456789", 1) == rest.npos);
    };
    return name == "reference" || is_of("opencl") || is_of("vulkan");
}

void check_options(const MapperOptions& options) {
    const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
    require(positive(options.cell_m), "cell", options.cell_m, "a length above 0 in metres");
    require(positive(options.range_m), "range", options.range_m, "a distance above 0 in metres");
    require(options.zone == 8 || options.zone == 16 || options.zone == 32, "zone", options.zone,
            "8, 16 or 32 cells");
    require(std::isfinite(options.span_sigmas) && options.span_sigmas >= 0.0, "span-sigmas",
            options.span_sigmas, "0 or more");
    require(options.limit >= 1 && options.limit <= 127, "limit", options.limit, "in 1 .. 127");
    const auto in_limit = fmt::format("in 1 .. limit ({})", options.limit);
    require(options.hit >= 1 && options.hit <= options.limit, "hit", options.hit, in_limit);
    require(options.miss >= 1 && options.miss <= options.limit, "miss", options.miss, in_limit);
    require(options.threshold >= 1 && options.threshold <= options.limit, "threshold",
            options.threshold, in_limit);
    require(std::isfinite(options.max_gap_s) && options.max_gap_s >= 0.0, "max-gap",
            options.max_gap_s, "0 or more seconds");
    require(is_backend_name(options.backend), "backend", options.backend,
            "reference, opencl or vulkan, or one of their devices, such as opencl:0");
}

} // namespace zonegrid
