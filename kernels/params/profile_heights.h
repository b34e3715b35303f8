// Arguments of profile_heights. Valid as C++, OpenCL C and GLSL.
#ifndef ZG_PARAMS_PROFILE_HEIGHTS_H
#define ZG_PARAMS_PROFILE_HEIGHTS_H

#define ZG_NO_HEIGHT 255 /* of a column without a cell */

#ifdef __cplusplus
#include <cstdint>
namespace zonegrid::params {
using uint = std::uint32_t;
#endif

struct ProfileHeightsParams {
    uint zones;    /* to profile */
    int zone_bits; /* edge of a zone: 2^zone_bits cells */
};

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
