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
};

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
