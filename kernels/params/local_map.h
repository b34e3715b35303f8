// Where a local map lies; part of the arguments of what draws into it. Valid as C++, OpenCL C and
// GLSL.
#ifndef ZG_PARAMS_LOCAL_MAP_H
#define ZG_PARAMS_LOCAL_MAP_H

#ifdef __cplusplus
#include <cstdint>
namespace zonegrid::params {
using uint = std::uint32_t;
#endif

struct LocalMapParams {
    int zone_bits;      /* edge of a zone: 2^zone_bits cells */
    int zones_per_axis; /* of the window */
    uint plane_words;   /* words of a zone's bit plane: cells of a zone / 32 */
};

#ifdef __OPENCL_VERSION__
typedef struct LocalMapParams LocalMapParams;
#endif

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
