// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All packet kernels. The source of each instruction set includes this file once.
 *
 * The kernels are plain loops over arrays, which compilers turn into vector instructions. They must
 * not use inline functions with external linkage: the linker keeps only one copy of such a
 * function, perhaps the copy with instructions that the processor does not have.
 */
#ifndef lms3dPacketKernels_inl
#define lms3dPacketKernels_inl

#include "Kernels/lms3dBeamKernels.inl"
#include "Kernels/lms3dFreeKernels.inl"
#include "Kernels/lms3dInsideKernels.inl"
#include "Kernels/lms3dNarrowKernels.inl"
#include "Kernels/lms3dNormalKernels.inl"
#include "Kernels/lms3dRangeErrorKernels.inl"
#include "Kernels/lms3dRangeKernels.inl"
#include "Kernels/lms3dReturnKernels.inl"
#include "Kernels/lms3dTileBoxKernels.inl"
#include "Kernels/lms3dTileKernels.inl"
#include "Kernels/lms3dTileRangeKernels.inl"

// In the order of lms3dFreeKernels.
#define LMS3D_FREE_KERNELS                                                                   \
  NarrowDirections, LocateStarts, ShiftStarts, ClipFreeRays, UpdateFree, IntersectFreePlane, \
    IntersectFreeDoublePlane

// In the order of lms3dReturnKernels.
#define LMS3D_RETURN_KERNELS FillReturnRun, WidenTriangles, CountReturns

// In the order of lms3dPacketKernels.
#define LMS3D_PACKET_KERNELS                                                                      \
  GenerateDirections, FindInCone, ShiftOrigins, Classify, UpdateNearest, MakeNarrowTriangle,      \
    UpdateNarrow, UpdateFromCorners, NarrowRanges, ClipRays, FillTileCorners, ClassifyTiles,      \
    FindTilesOfBox, FindHits, MakeDoubleDoublePlane, MakeDoubleDoublePlanes, MakeDoublePlane,     \
    IntersectDoubleDoublePlane, IntersectTile, IntersectDoubleDoublePlanes, IntersectDoublePlane, \
    StoreRanges, RefineRanges, StoreRangesOfBeams, ApplyMinimumRange, Locate, AddStrip,           \
    DrawNormals, ReportRanges, { LMS3D_RETURN_KERNELS },                                          \
  {                                                                                               \
    LMS3D_FREE_KERNELS                                                                            \
  }

#endif
