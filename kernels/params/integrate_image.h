// Arguments of integrate_image. Valid as C++, OpenCL C and GLSL.
#ifndef ZG_PARAMS_INTEGRATE_IMAGE_H
#define ZG_PARAMS_INTEGRATE_IMAGE_H

#include "kernels/params/local_map.h"

#ifdef __cplusplus
namespace zonegrid::params {
#endif

struct IntegrateImageParams {
    LocalMapParams local_map;
    int width_px;
    uint pixels;
    int origin[3];       /* camera centre, sub-cells */
    int a[3];            /* direction of pixel (0, 0) */
    int u[3];            /* added per pixel to the right */
    int v[3];            /* added per pixel down */
    uint own_directions; /* 1: each pixel's direction is given, a is not used */
    uint spanned;        /* 1: sub-rays fill the pixel's pyramid */
    int spacing;         /* depth at which neighbouring rays are one cell apart, sub-cells */
};

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
