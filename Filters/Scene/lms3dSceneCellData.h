// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cell data of a scene, by the numbers of its cells.
 */
#ifndef lms3dSceneCellData_h
#define lms3dSceneCellData_h

#include <vtkType.h>

#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkFieldData;

/**
 * Adds the cell arrays of a scene to `data`, with one tuple for each of `cells`. The numbers of
 * cells are those that lms3dCollectTriangles gives: global ids if `hasGlobalIds`.
 *
 * An array counts if all leaves with cells have it with the same type and number of components.
 * Skips vtkGhostType, the global ids, and names that `data` has already.
 */
void lms3dCopyCellData(
  vtkDataObject* scene, bool hasGlobalIds, std::vector<vtkIdType> cells, vtkFieldData* data);

/// Replaces global ids by the consecutive numbers of the cells over all `leaves`, which have cells
/// and global ids. If several cells have an id, the first one counts.
void lms3dReplaceGlobalIds(const std::vector<vtkDataSet*>& leaves, std::vector<vtkIdType>& cells);

#endif
