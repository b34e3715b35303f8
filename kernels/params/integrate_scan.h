// Arguments of integrate_scan. Valid as C++, OpenCL C and GLSL.
#ifndef ZG_PARAMS_INTEGRATE_SCAN_H
#define ZG_PARAMS_INTEGRATE_SCAN_H

#include "kernels/params/local_map.h"

#ifdef __cplusplus
namespace zonegrid::params {
#endif

struct IntegrateScanParams {
    LocalMapParams local_map;
    uint rays;
};

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
