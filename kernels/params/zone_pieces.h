// Arguments of what works on the pieces of zones: label_components, measure_objects, encode_octree,
// encode_prism. Valid as C++, OpenCL C and GLSL.
#ifndef ZG_PARAMS_ZONE_PIECES_H
#define ZG_PARAMS_ZONE_PIECES_H

/* Words that measure_objects leaves of a piece: 0 its cells; 1, 2, 3 the greatest distance of a
   cell from the zone's last one along x, y, z; 4, 5, 6 the greatest x, y, z; 7, 8, 9 sums of x, y,
   z; 10 all ones less the least cell by x, y, z. So all may begin with 0. */
#define ZG_MEASURE_WORDS 11

#ifdef __cplusplus
#include <cstdint>
namespace zonegrid::params {
using uint = std::uint32_t;
#endif

struct ZonePiecesParams {
    uint items;    /* zones or pieces to work on, one a work-group */
    int zone_bits; /* edge of a zone: 2^zone_bits cells */
};

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
