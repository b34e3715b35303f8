// Arguments of fuse_local_map. Valid as C++, OpenCL C and GLSL.
#ifndef ZG_PARAMS_FUSE_LOCAL_MAP_H
#define ZG_PARAMS_FUSE_LOCAL_MAP_H

#ifdef __cplusplus
#include <cstdint>
namespace zonegrid::params {
using uint = std::uint32_t;
#endif

struct FuseLocalMapParams {
    uint pair_count;  /* zones to fuse */
    uint plane_words; /* words of a zone's bit plane: cells of a zone / 32 */
    int hit;          /* the fusion's numbers: docs/model.md, section 7 */
    int miss;
    int limit;
    int threshold;
    uint zone_bits;     /* a zone is 2^zone_bits cells wide */
    uint view_bounded;  /* 0: every cell is seen whole */
    int view_side_x[4]; /* the view: docs/model.md, section 3 */
    int view_side_y[4];
    int view_side_z[4];
    int view_centre[3];
    int view_radius;
};

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
