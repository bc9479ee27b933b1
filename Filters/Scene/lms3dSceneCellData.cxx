// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dSceneCellData.h"

#include "Scene/lms3dJoinedArrays.h"
#include "Scene/lms3dSceneLeaves.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <unordered_map>

namespace
{
lms3dTupleSource MakeSource(vtkDataSet* leaf)
{
  vtkNew<vtkCellData> arrays;
  arrays->ShallowCopy(leaf->GetCellData());
  arrays->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  if (vtkDataArray* ids = arrays->GetGlobalIds())
  {
    arrays->RemoveArray(ids->GetName());
  }
  return { arrays.Get(), leaf->GetNumberOfCells() };
}

vtkSmartPointer<vtkIdTypeArray> GetGlobalIds(vtkDataSet* leaf)
{
  vtkDataArray* ids = leaf->GetCellData()->GetGlobalIds();
  if (vtkIdTypeArray* numbers = vtkIdTypeArray::FastDownCast(ids))
  {
    return numbers;
  }
  vtkNew<vtkIdTypeArray> numbers;
  numbers->DeepCopy(ids);
  return numbers.Get();
}
} // namespace

void lms3dReplaceGlobalIds(const std::vector<vtkDataSet*>& leaves, std::vector<vtkIdType>& cells)
{
  std::unordered_map<vtkIdType, vtkIdType> numbers;
  for (vtkIdType cell : cells)
  {
    numbers.emplace(cell, -1);
  }
  vtkIdType number = 0;
  for (vtkDataSet* leaf : leaves)
  {
    const vtkSmartPointer<vtkIdTypeArray> ids = GetGlobalIds(leaf);
    const vtkIdType* id = ids->GetPointer(0);
    for (vtkIdType i = 0; i < leaf->GetNumberOfCells(); ++i, ++number)
    {
      const auto found = numbers.find(id[i]);
      if (found != numbers.end() && found->second < 0)
      {
        found->second = number;
      }
    }
  }
  for (vtkIdType& cell : cells)
  {
    cell = numbers[cell];
  }
}

void lms3dCopyCellData(
  vtkDataObject* scene, bool hasGlobalIds, std::vector<vtkIdType> cells, vtkFieldData* data)
{
  const std::vector<vtkDataSet*> leaves = lms3dGetLeavesWithCells(scene);
  std::vector<lms3dTupleSource> sources;
  std::vector<vtkIdType> firstCells;
  vtkIdType firstCell = 0;
  for (vtkDataSet* leaf : leaves)
  {
    sources.push_back(MakeSource(leaf));
    firstCells.push_back(firstCell);
    firstCell += leaf->GetNumberOfCells();
  }
  if (hasGlobalIds)
  {
    lms3dReplaceGlobalIds(leaves, cells);
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto next = std::upper_bound(firstCells.begin(), firstCells.end(), cells[i]);
    const auto leaf = std::distance(firstCells.begin(), next) - 1;
    sources[leaf].Add(cells[i] - firstCells[leaf], static_cast<vtkIdType>(i));
  }
  lms3dJoinArrays(sources, static_cast<vtkIdType>(cells.size()), data);
}
