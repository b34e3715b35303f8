#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace zonegrid {

/// How a pixel speaks for the cells around its ray (docs/model.md, section 5).
enum class SensorModel {
    line, ///< the pixel's axis only, the obstacle where the depth says
    span  ///< the pixel's whole pyramid, the obstacle spread over the depth's uncertainty
};

/// Parameters of a map; fixed for its lifetime.
struct MapperOptions {
    double cell_m = 1.0;   ///< edge of a cell, metres, > 0
    double range_m = 40.0; ///< distance along the ray up to which images make statements, > 0
    int zone = 32;         ///< edge of a zone in cells: 8, 16 or 32
    SensorModel model = SensorModel::line;
    double span_sigmas = 1.0; ///< spread of an obstacle in standard deviations of the depth, >= 0
    int hit = 2;              ///< added to a cell that an image says is occupied, 1 .. limit
    int miss = 1;             ///< taken from a cell that an image says is free, 1 .. limit
    int limit = 4;            ///< cells saturate at -limit and +limit, 1 .. 127
    int threshold = 2;        ///< a cell is occupied from this value on, 1 .. limit
    double max_gap_s = 0.05;  ///< greatest distance in time between image and navigation, >= 0
    /// How to compute: "reference" (scalar, on the processor), "opencl" or "vulkan" (the first
    /// device of it that can be used), or one device, such as "opencl:0".
    std::string backend = "reference";
    /// Most memory of the device to take, bytes, where others use it too; 0: no limit.
    std::uint64_t device_memory_bytes = 0;
    /// Whether a device that shares the processor's memory works in it without copies; false where
    /// a driver does that wrongly. No other device is affected.
    bool device_shared_memory = true;
};

/// Whether a name can be that of a backend or of one of its devices.
[[nodiscard]] bool is_backend_name(std::string_view name);

/// Throws UsageError naming the option, its value and what is allowed.
void check_options(const MapperOptions& options);

} // namespace zonegrid
