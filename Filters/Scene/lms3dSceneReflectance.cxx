// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dSceneReflectance.h"

#include "Scene/lms3dSceneCellData.h"
#include "Scene/lms3dSceneLeaves.h"

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace
{
// Luminance of linear red, green and blue (ITU-R BT.709-6, item 3.2), times 10000. Whole numbers
// give white exactly 1, and grey exactly its component / 255.
constexpr int LuminanceWeights[] = { 2126, 7152, 722 };
constexpr double White = 10000.0 * 255.0;

bool IsColor(vtkAbstractArray* array)
{
  const int components = array->GetNumberOfComponents();
  return array->GetDataType() == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
}

/// The cells of one data set of the scene.
struct Leaf
{
  double GetReflectance(vtkIdType cell) const
  {
    if (!this->HasColors)
    {
      return this->Values->GetComponent(cell, 0);
    }
    int luminance = 0;
    for (int i = 0; i < 3; ++i)
    {
      luminance += LuminanceWeights[i] * static_cast<int>(this->Values->GetComponent(cell, i));
    }
    return luminance / White;
  }

  vtkDataSet* Cells;
  vtkIdType FirstCell;

  /// Null if the array is missing or not usable.
  vtkDataArray* Values;
  bool HasColors;
};

std::string ListArrays(vtkDataSet* cells)
{
  std::string list;
  for (int i = 0; i < cells->GetCellData()->GetNumberOfArrays(); ++i)
  {
    const char* name = cells->GetCellData()->GetArrayName(i);
    list += (name ? std::string(list.empty() ? "" : ", ") + name : "");
  }
  return list.empty() ? "It has no cell arrays." : "Its cell arrays are: " + list + ".";
}

// `scene` names the data set.
[[noreturn]] void ThrowBadArray(const Leaf& leaf, const std::string& name, const std::string& scene)
{
  std::ostringstream error;
  error << "ReflectanceArray is \"" << name << "\", but ";
  vtkAbstractArray* array = leaf.Cells->GetCellData()->GetAbstractArray(name.c_str());
  if (!array)
  {
    error << scene << " has no such cell array. " << ListArrays(leaf.Cells);
  }
  else if (array->GetNumberOfTuples() < leaf.Cells->GetNumberOfCells())
  {
    error << "in " << scene << " it has only " << array->GetNumberOfTuples() << " values for "
          << leaf.Cells->GetNumberOfCells() << " cells.";
  }
  else
  {
    error
      << "in " << scene << " it has components of the type " << array->GetDataTypeAsString() << ", "
      << array->GetNumberOfComponents()
      << " for each cell. One component of any number type (the reflectance), or three or four of "
         "unsigned char (a colour), are expected.";
  }
  throw std::runtime_error(error.str());
}

std::vector<Leaf> GetLeaves(const std::vector<vtkDataSet*>& leaves, const std::string& name)
{
  std::vector<Leaf> cells;
  vtkIdType first = 0;
  for (vtkDataSet* leaf : leaves)
  {
    auto* values = vtkDataArray::SafeDownCast(leaf->GetCellData()->GetAbstractArray(name.c_str()));
    const bool isGood = values && values->GetNumberOfTuples() >= leaf->GetNumberOfCells() &&
      (values->GetNumberOfComponents() == 1 || IsColor(values));
    cells.push_back({ leaf, first, isGood ? values : nullptr, isGood && IsColor(values) });
    first += leaf->GetNumberOfCells();
  }
  return cells;
}

// The numbers of the cells of all triangles, consecutive over all data sets.
std::vector<vtkIdType> GetCells(
  const std::vector<vtkDataSet*>& leaves, bool hasGlobalIds, const lms3dTriangleMesh& mesh)
{
  std::vector<vtkIdType> cells(mesh.GetNumberOfTriangles());
  for (std::size_t triangle = 0; triangle < cells.size(); ++triangle)
  {
    cells[triangle] = static_cast<vtkIdType>(mesh.GetCell(triangle));
  }
  if (hasGlobalIds)
  {
    lms3dReplaceGlobalIds(leaves, cells);
  }
  return cells;
}
} // namespace

std::vector<double> lms3dGetReflectances(
  vtkDataObject* scene, const std::string& name, bool hasGlobalIds, const lms3dTriangleMesh& mesh)
{
  const std::vector<vtkDataSet*> dataSets = lms3dGetLeavesWithCells(scene);
  const std::vector<Leaf> leaves = GetLeaves(dataSets, name);
  const std::vector<vtkIdType> cells = GetCells(dataSets, hasGlobalIds, mesh);
  std::vector<double> reflectances(cells.size());
  for (std::size_t triangle = 0; triangle < cells.size(); ++triangle)
  {
    const vtkIdType cell = cells[triangle];
    const auto next = std::upper_bound(leaves.begin(), leaves.end(), cell,
      [](vtkIdType number, const Leaf& leaf) { return number < leaf.FirstCell; });
    const Leaf& leaf = *std::prev(next);
    if (!leaf.Values)
    {
      ThrowBadArray(leaf, name,
        leaves.size() == 1 ? "the scene"
                           : "data set " + std::to_string(next - leaves.begin()) + " of the scene");
    }
    const double reflectance = leaf.GetReflectance(cell - leaf.FirstCell);
    if (!(reflectance >= 0.0 && std::isfinite(reflectance)))
    {
      std::ostringstream error;
      error << "The reflectance of cell " << mesh.GetCell(triangle) << " in \"" << name << "\" is "
            << reflectance << "; a finite number of 0 or more is expected.";
      throw std::runtime_error(error.str());
    }
    reflectances[triangle] = reflectance;
  }
  return reflectances;
}
