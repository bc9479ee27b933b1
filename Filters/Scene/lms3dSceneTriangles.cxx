// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dSceneTriangles.h"

#include "Scene/lms3dSceneLeaves.h"
#include "Scene/lms3dSurfaceTriangles.h"

#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkGenericCell.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>
#include <vector>

namespace
{
// Points of skipped cells can have larger coordinates.
constexpr double MaximumCoordinate = 1e18;

bool HasVolumeCells(vtkDataSet* data)
{
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    cell->SetCellType(data->GetCellType(i));
    if (cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}

class Collector
{
public:
  explicit Collector(const std::string& name)
    : Surfaces(this->Scene.Mesh, name)
  {
  }

  /// Returns false if `progress` stopped the work.
  bool Append(vtkDataObject* scene, const std::function<bool(double)>& progress)
  {
    const std::vector<vtkDataSet*> leaves = lms3dGetLeaves(scene);
    const double count = static_cast<double>(leaves.size());
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      const auto report = [&progress, i, count](double done)
      { return progress((static_cast<double>(i) + done) / count); };
      if (leaves[i] && !this->AppendLeaf(leaves[i], report))
      {
        return false;
      }
    }
    this->Scene.SkippedCells = this->Surfaces.GetSkippedCells();
    this->Scene.CrossedCells = this->Surfaces.GetCrossedCells();
    this->Scene.FirstCrossedCell = this->Surfaces.GetFirstCrossedCell();
    this->Scene.HiddenCells = this->Surfaces.GetHiddenCells();
    return true;
  }

  // No triangle uses these points. Finite coordinates need no special case later.
  void ClearUnusable()
  {
    for (std::array<double, 3>& point : this->Scene.Mesh.Points)
    {
      for (double& x : point)
      {
        x = std::abs(x) <= MaximumCoordinate ? x : 0.0;
      }
    }
  }

  // Sorts the triangles by global id, so that their order does not depend on the order of the
  // cells.
  void UseGlobalIds()
  {
    this->Scene.NumberOfCells = this->FirstCell;
    this->Scene.HasGlobalIds = !this->GlobalIds.empty() &&
      this->GlobalIds.size() == static_cast<std::size_t>(this->FirstCell);
    std::vector<std::int64_t>& cells = this->Scene.Mesh.Cells;
    if (!this->Scene.HasGlobalIds)
    {
      return;
    }
    const auto [minimum, maximum] =
      std::minmax_element(this->GlobalIds.begin(), this->GlobalIds.end());
    this->Scene.MinimumGlobalId = *minimum;
    this->Scene.MaximumGlobalId = *maximum;
    this->Scene.Mesh.ListCells();
    for (std::int64_t& cell : cells)
    {
      cell = this->GlobalIds[cell];
    }
    if (this->Scene.CrossedCells > 0)
    {
      this->Scene.FirstCrossedCell = this->GlobalIds[this->Scene.FirstCrossedCell];
    }
    if (!std::is_sorted(cells.begin(), cells.end()))
    {
      this->SortByCell();
    }
  }

  // If each triangle is a cell of its own, in order, the list of cells is not needed.
  void DropTrivialCells()
  {
    std::vector<std::int64_t>& cells = this->Scene.Mesh.Cells;
    std::int64_t number = 0;
    if (std::all_of(
          cells.begin(), cells.end(), [&number](std::int64_t cell) { return cell == number++; }))
    {
      cells = {};
    }
  }

  void FreeUnusedMemory()
  {
    this->Scene.Mesh.Points.shrink_to_fit();
    this->Scene.Mesh.Triangles.shrink_to_fit();
    this->Scene.Mesh.Cells.shrink_to_fit();
  }

  lms3dSceneTriangles Scene;

private:
  void SortByCell()
  {
    lms3dTriangleMesh& mesh = this->Scene.Mesh;
    std::vector<std::size_t> order(mesh.Cells.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
      [&mesh](std::size_t a, std::size_t b) { return mesh.Cells[a] < mesh.Cells[b]; });
    lms3dTriangleIndices triangles;
    std::vector<std::int64_t> cells;
    triangles.reserve(order.size());
    cells.reserve(order.size());
    for (std::size_t triangle : order)
    {
      triangles.push_back(mesh.Triangles[triangle]);
      cells.push_back(mesh.Cells[triangle]);
    }
    mesh.Triangles = std::move(triangles);
    mesh.Cells = std::move(cells);
  }

  bool AppendLeaf(vtkDataSet* leaf, const lms3dSurfaceTriangles::Progress& progress)
  {
    bool isComplete = false;
    if (vtkPolyData* surface = vtkPolyData::SafeDownCast(leaf))
    {
      isComplete = this->Surfaces.Append(surface, nullptr, this->FirstCell, progress);
    }
    else
    {
      this->Scene.HasVolume = this->Scene.HasVolume || HasVolumeCells(leaf);
      vtkNew<vtkDataSetSurfaceFilter> filter;
      filter->SetInputData(leaf);
      filter->PassThroughCellIdsOn();
      filter->Update();
      auto* originalCells = vtkIdTypeArray::SafeDownCast(
        filter->GetOutput()->GetCellData()->GetArray(filter->GetOriginalCellIdsName()));
      isComplete =
        this->Surfaces.Append(filter->GetOutput(), originalCells, this->FirstCell, progress);
    }
    const vtkIdType cells = leaf->GetNumberOfCells();
    this->AppendGlobalIds(leaf->GetCellData()->GetGlobalIds(), cells);
    this->FirstCell += cells;
    return isComplete;
  }

  void AppendGlobalIds(vtkDataArray* ids, vtkIdType cells)
  {
    if (ids && ids->GetNumberOfTuples() >= cells)
    {
      vtkNew<vtkIdTypeArray> numbers;
      numbers->DeepCopy(ids);
      const vtkIdType* first = numbers->GetPointer(0);
      this->GlobalIds.insert(this->GlobalIds.end(), first, first + cells);
    }
  }

  lms3dSurfaceTriangles Surfaces;
  // Used only if all cells have one.
  std::vector<std::int64_t> GlobalIds;
  std::int64_t FirstCell = 0;
};
} // namespace

lms3dSceneTriangles lms3dCollectTriangles(
  vtkDataObject* scene, const std::string& name, const std::function<bool(double)>& progress)
{
  Collector collector(name);
  if (!collector.Append(scene, progress))
  {
    lms3dSceneTriangles stopped;
    stopped.IsComplete = false;
    return stopped;
  }
  collector.UseGlobalIds();
  collector.DropTrivialCells();
  collector.ClearUnusable();
  collector.FreeUnusedMemory();
  return std::move(collector.Scene);
}

std::string lms3dDescribeSkippedCells(const lms3dSceneTriangles& triangles, const std::string& name)
{
  std::ostringstream text;
  if (triangles.SkippedCells > 0)
  {
    text << name << ": cells with a point that is not finite or exceeds 1e18 m are left out: "
         << triangles.SkippedCells << ". ";
  }
  if (triangles.CrossedCells > 0)
  {
    text << name << ": polygons that have too many corners for their shape, or cross themselves: "
         << triangles.CrossedCells << ". The first is cell " << triangles.FirstCrossedCell
         << ". Their triangles may overlap or extend beyond them; split these polygons. All other "
            "cells are complete. ";
  }
  return text.str();
}
