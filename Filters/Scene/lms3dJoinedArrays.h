// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Joins chosen tuples of several sets of arrays.
 */
#ifndef lms3dJoinedArrays_h
#define lms3dJoinedArrays_h

#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

/// The tuples that one source contributes.
struct lms3dTupleSource
{
  /// Appends one tuple of the source and its index in the joined arrays.
  void Add(vtkIdType tuple, vtkIdType target)
  {
    this->Tuples->InsertNextId(tuple);
    this->Targets->InsertNextId(target);
  }

  vtkSmartPointer<vtkFieldData> Arrays;

  /// Arrays with fewer tuples than this are ignored.
  vtkIdType Size;

  vtkSmartPointer<vtkIdList> Tuples = vtkSmartPointer<vtkIdList>::New();
  vtkSmartPointer<vtkIdList> Targets = vtkSmartPointer<vtkIdList>::New();
};

/**
 * Adds to `joined` one array of `count` tuples for each array that all sources have with the same
 * name, type and number of components. Arrays without a name, and names that `joined` has already,
 * are skipped. If several sources contribute the same tuple, the last one wins.
 */
void lms3dJoinArrays(
  const std::vector<lms3dTupleSource>& sources, vtkIdType count, vtkFieldData* joined);

#endif
