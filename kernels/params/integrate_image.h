// Arguments of integrate_image. Valid as C++, OpenCL C and GLSL.
#ifndef ZG_PARAMS_INTEGRATE_IMAGE_H
#define ZG_PARAMS_INTEGRATE_IMAGE_H

#include "kernels/params/local_map.h"

#ifdef __cplusplus
namespace zonegrid::params {
#endif

#define ZG_WINDOW_LEVELS 6    /* windows of 1 to 32 pixels */
#define ZG_WINDOWS_AN_ITEM 32 /* that deepen_windows fills */
#define ZG_LEAST_SLICE 32     /* sub-cells that skip_tiles goes ahead at least */
#define ZG_SKIP_ROWS                                                                               \
    12000                    /* rows of cells that a tile looks at; keeps loops below 65535 rounds \
                              */
#define ZG_NEAR_CROSSINGS 48 /* how far draw_near walks */

/* Of fill_cells, in sub-cells; docs/filling.md says why those. */
#define ZG_FILL_NEAREST 64.0f /* no cell is filled whose centre is less deep */
#define ZG_FILL_ASIDE 124.0f  /* how far a ray may pass from a cell's centre on an axis */
#define ZG_FILL_DEEPER 3.0f   /* how much deeper than the centre a ray must go */
#define ZG_FILL_WINDOW \
    100.0f /* a window's rays are at most so far from its middle; any number works */

/* Of deepen_windows. */
struct DeepenWindowsParams {
    int width_px;
    int height_px;
    int level; /* to fill; the level before it is full */
};

/* Of fill_cells. A point G sub-cells from the camera centre, an exact one, lies at depth q in pixel
   (u, v), where (u q, v q, q) = rows * G. */
struct FillCellsParams {
    LocalMapParams local_map;
    uint zones; /* reserved */
    int width_px;
    int height_px;
    int deepest;   /* of all pixels, sub-cells */
    int origin[3]; /* camera centre, sub-cells */
    float rows[9];
    float right[3]; /* |U|, |V| / 2^28: what a pixel is wide, per sub-cell of depth */
    float down[3];
    float slack_px; /* more than u and v are wrong by */
};

/* Of draw_near, skip_tiles and draw_rays. */
struct IntegrateImageParams {
    LocalMapParams local_map;
    int width_px;
    int height_px;
    int origin[3];       /* camera centre, sub-cells */
    int a[3];            /* direction of pixel (0, 0) */
    int u[3];            /* added per pixel to the right */
    int v[3];            /* added per pixel down */
    uint own_directions; /* 1: each pixel's direction is given, a is not used */
    uint spanned;        /* 1: sub-rays fill the pixel's pyramid */
    int spacing;         /* depth at which neighbouring rays are one cell apart, sub-cells */
    int most_split;      /* of draw_rays: 2^most_split squared sub-rays a pixel at most */
    int tile_level;      /* size of a tile, as of a window; 0: no ray is skipped */
    int wide_level;      /* of skip_tiles: size of the tiles before these; 0: there were none */
    int slice;           /* of skip_tiles: sub-cells that it goes ahead at most */
};

#ifdef __cplusplus
} // namespace zonegrid::params
#endif

#endif
