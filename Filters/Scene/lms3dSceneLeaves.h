// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The data sets of a scene.
 */
#ifndef lms3dSceneLeaves_h
#define lms3dSceneLeaves_h

#include <vector>

class vtkDataObject;
class vtkDataSet;

/// Returns all leaves of a composite in the order in which their cells are numbered, or the data
/// set itself. Leaves that are not data sets are null.
std::vector<vtkDataSet*> lms3dGetLeaves(vtkDataObject* scene);

/// Returns the leaves that have cells, in the same order.
std::vector<vtkDataSet*> lms3dGetLeavesWithCells(vtkDataObject* scene);

#endif
