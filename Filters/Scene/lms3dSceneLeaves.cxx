// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dSceneLeaves.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <algorithm>

std::vector<vtkDataSet*> lms3dGetLeaves(vtkDataObject* scene)
{
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(scene);
  if (!composite)
  {
    return { vtkDataSet::SafeDownCast(scene) };
  }
  std::vector<vtkDataSet*> leaves;
  auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    leaves.push_back(vtkDataSet::SafeDownCast(it->GetCurrentDataObject()));
  }
  return leaves;
}

std::vector<vtkDataSet*> lms3dGetLeavesWithCells(vtkDataObject* scene)
{
  std::vector<vtkDataSet*> leaves = lms3dGetLeaves(scene);
  leaves.erase(std::remove_if(leaves.begin(), leaves.end(),
                 [](vtkDataSet* leaf) { return !leaf || leaf->GetNumberOfCells() == 0; }),
    leaves.end());
  return leaves;
}
