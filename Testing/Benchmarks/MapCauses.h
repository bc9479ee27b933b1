// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the triangles of a map within a bound come from.
 */
#ifndef MapCauses_h
#define MapCauses_h

#include <vtkPolyData.h>

/**
 * A patch with v vertices in its outlines, h holes and i vertices inside has v + 2 h + 2 i - 2
 * triangles. So each vertex of an outline costs one triangle in each of its patches, and each
 * vertex inside a patch costs two. The numbers of triangles by cause have the sum of all triangles,
 * if each patch is connected.
 */
struct MapCauses
{
  /// Triangles that join two patches along an offset.
  vtkIdType Strips = 0;
  /// For vertices inside patches, which the error check inserted.
  vtkIdType Inside = 0;
  /// For vertices of one patch: its border bends at a depth step, or beside a strip.
  vtkIdType Borders = 0;
  /// For vertices of two patches: a crease bends, ends or begins.
  vtkIdType Creases = 0;
  /// For vertices of three or more patches.
  vtkIdType Corners = 0;
  /// For patches and their holes: all triangles less those above, usually below 0.
  vtkIdType Patches = 0;
  /// Patches of at most four triangles, and all their triangles (which the causes above contain).
  vtkIdType SmallPatches = 0;
  vtkIdType OnSmallPatches = 0;
};

/// Counts the causes in the output of vtkLMS3DSurfaceReconstructionFilter with a MaximumError above
/// 0.
MapCauses CountMapCauses(vtkPolyData* map);

#endif
