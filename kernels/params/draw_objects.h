// Arguments of draw_objects. Valid as C++, OpenCL C and GLSL.
#ifndef ZG_PARAMS_DRAW_OBJECTS_H
#define ZG_PARAMS_DRAW_OBJECTS_H

#ifdef __cplusplus
#include <cstdint>
namespace zonegrid::params {
using uint = std::uint32_t;
#endif

struct DrawObjectsParams {
    uint cells; /* to draw */
    int value;  /* of each, at least the threshold */
};

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
