// Numbers of docs/model.md that more than one language needs. Plain defines: valid as C++, OpenCL C
// and GLSL.
#ifndef ZG_CONSTANTS_H
#define ZG_CONSTANTS_H

#define ZG_SUB_BITS 8            /* a cell is 2^8 sub-cells wide */
#define ZG_SUB_PER_CELL 256      /* 1 << ZG_SUB_BITS */
#define ZG_DIRECTION_BITS 28     /* fixed point of ray directions */
#define ZG_MAX_WINDOW_CELLS 2048 /* an axis: keeps window-relative sub-cells below 2^19 */
#define ZG_MAX_SPLIT_LEVEL 4     /* at most 16 x 16 sub-rays a pixel */
#define ZG_MAX_SPACING 67108864  /* 2^26: shifted by the split level it stays below 2^31 */

#define ZG_VIEW_PER_CELL 16    /* unit of a view: 1/16 cell */
#define ZG_VIEW_NORMAL_BITS 14 /* fixed point of the normals of its sides */
#define ZG_VIEW_MARGIN 3       /* so far inside of each bound: more than the rounding here */

#define ZG_STATEMENT_NOTHING 0
#define ZG_STATEMENT_FREE 1
#define ZG_STATEMENT_OCCUPIED 2

#define ZG_FREE_PLANE 0 /* planes of a device's local map, in this order */
#define ZG_OCCUPIED_PLANE 1

#endif
