// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dSceneTriangles.h"

#include "lms3dPolygon.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericCell.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{
// Sums of squares of larger coordinates leave the range of single precision.
constexpr double LargestCoordinate = 1e18;

// Embree and the packets number triangles by 32 bits.
constexpr std::size_t MostTriangles = std::numeric_limits<std::int32_t>::max();

// A composite asks once for each leaf, so room grows by at least a half.
template <typename T>
void MakeRoom(std::vector<T>& vector, std::size_t more)
{
  const std::size_t needed = vector.size() + more;
  if (needed > vector.capacity())
  {
    vector.reserve(std::max(needed, vector.capacity() + vector.capacity() / 2));
  }
}

template <typename ArrayT>
void CopyPoints(ArrayT* array, std::vector<std::array<double, 3>>& points)
{
  const auto* value = array->GetPointer(0);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i, value += 3)
  {
    points.push_back({ static_cast<double>(value[0]), static_cast<double>(value[1]),
      static_cast<double>(value[2]) });
  }
}

void AppendPoints(vtkPoints* points, std::vector<std::array<double, 3>>& out)
{
  if (!points)
  {
    return;
  }
  MakeRoom(out, points->GetNumberOfPoints());
  if (vtkFloatArray* floats = vtkFloatArray::FastDownCast(points->GetData()))
  {
    CopyPoints(floats, out);
  }
  else if (vtkDoubleArray* doubles = vtkDoubleArray::FastDownCast(points->GetData()))
  {
    CopyPoints(doubles, out);
  }
  else
  {
    vtkNew<vtkDoubleArray> copy;
    copy->DeepCopy(points->GetData());
    CopyPoints(copy.Get(), out);
  }
}

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
  void Append(vtkDataObject* scene)
  {
    if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(scene))
    {
      auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
      {
        this->AppendLeaf(vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject()));
      }
      return;
    }
    this->AppendLeaf(vtkDataSet::SafeDownCast(scene));
  }

  // Points that no triangle uses may be anything; nobody has to look at them twice.
  void ClearUnusable()
  {
    for (std::array<double, 3>& point : this->Scene.Mesh.Points)
    {
      for (double& x : point)
      {
        x = std::abs(x) <= LargestCoordinate ? x : 0.0;
      }
    }
  }

  // Triangles are numbered as their cells are, whatever order or parts the scene comes in.
  void TakeGlobalIds()
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
    for (std::int64_t& cell : cells)
    {
      cell = this->GlobalIds[cell];
    }
    if (!std::is_sorted(cells.begin(), cells.end()))
    {
      this->SortByCell();
    }
  }

  // A scene of nothing but triangles, all usable, needs no list of what cell each is a part of.
  void DropOwnNumbers()
  {
    std::vector<std::int64_t>& cells = this->Scene.Mesh.Cells;
    std::int64_t number = 0;
    if (std::all_of(
          cells.begin(), cells.end(), [&number](std::int64_t cell) { return cell == number++; }))
    {
      cells = {};
    }
  }

  void DropUnusedRoom()
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
    std::vector<std::array<std::uint32_t, 3>> triangles;
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

  void AppendLeaf(vtkDataSet* leaf)
  {
    if (!leaf)
    {
      return;
    }
    this->FirstPoint = this->Scene.Mesh.Points.size();
    if (vtkPolyData* surface = vtkPolyData::SafeDownCast(leaf))
    {
      this->AppendSurface(surface, nullptr);
    }
    else
    {
      this->Scene.HasVolume = this->Scene.HasVolume || HasVolumeCells(leaf);
      vtkNew<vtkDataSetSurfaceFilter> filter;
      filter->SetInputData(leaf);
      filter->PassThroughCellIdsOn();
      filter->Update();
      this->AppendSurface(filter->GetOutput(),
        vtkIdTypeArray::SafeDownCast(
          filter->GetOutput()->GetCellData()->GetArray(filter->GetOriginalCellIdsName())));
    }
    const vtkIdType cells = leaf->GetNumberOfCells();
    this->AppendGlobalIds(leaf->GetCellData()->GetGlobalIds(), cells);
    this->FirstCell += cells;
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

  // Cells of a vtkPolyData are numbered vertices, lines, polygons, strips.
  void AppendSurface(vtkPolyData* surface, vtkIdTypeArray* originalCells)
  {
    if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() == 0)
    {
      return;
    }
    AppendPoints(surface->GetPoints(), this->Scene.Mesh.Points);
    MakeRoom(this->Scene.Mesh.Triangles, surface->GetNumberOfPolys());
    MakeRoom(this->Scene.Mesh.Cells, surface->GetNumberOfPolys());
    if (this->Scene.Mesh.Points.size() > std::numeric_limits<std::uint32_t>::max())
    {
      throw std::runtime_error("The scene has more points than 32 bits can number; split it.");
    }
    this->OriginalCells = originalCells;
    this->Ghosts = surface->GetCellGhostArray();
    vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
    this->AppendCells(surface->GetPolys(), cell, &Collector::AppendPolygon);
    cell += surface->GetNumberOfPolys();
    this->AppendCells(surface->GetStrips(), cell, &Collector::AppendStrip);
  }

  using AppendCell = void (Collector::*)(vtkIdType count, const vtkIdType* points);

  void AppendCells(vtkCellArray* cells, vtkIdType firstCell, AppendCell append)
  {
    auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
    vtkIdType cell = firstCell;
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
    {
      vtkIdType count;
      const vtkIdType* points;
      it->GetCurrentCell(count, points);
      this->Cell =
        this->FirstCell + (this->OriginalCells ? this->OriginalCells->GetValue(cell) : cell);
      if (!this->IsHidden(cell) && this->IsUsable(count, points))
      {
        (this->*append)(count, points);
      }
    }
  }

  bool IsHidden(vtkIdType cell)
  {
    const bool isHidden = this->Ghosts && cell < this->Ghosts->GetNumberOfValues() &&
      (this->Ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0;
    this->Scene.HiddenCells += isHidden ? 1 : 0;
    return isHidden;
  }

  // Skips a cell with a point that no beam can be cast against.
  bool IsUsable(vtkIdType count, const vtkIdType* points)
  {
    const std::vector<std::array<double, 3>>& all = this->Scene.Mesh.Points;
    const vtkIdType pointsOfLeaf = static_cast<vtkIdType>(all.size() - this->FirstPoint);
    bool isFinite = true;
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (points[i] < 0 || points[i] >= pointsOfLeaf)
      {
        throw std::runtime_error("Cell " + std::to_string(this->Cell) +
          " of the scene uses point " + std::to_string(points[i]) + " of " +
          std::to_string(pointsOfLeaf) + ". Repair the cell.");
      }
      for (double x : all[this->FirstPoint + points[i]])
      {
        isFinite = isFinite && std::abs(x) <= LargestCoordinate;
      }
    }
    this->Scene.SkippedCells += isFinite ? 0 : 1;
    return isFinite;
  }

  void AppendTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (this->Scene.Mesh.Triangles.size() >= MostTriangles)
    {
      throw std::runtime_error(
        "The scene has more triangles than 31 bits can number; split it or simplify it.");
    }
    this->Scene.Mesh.Triangles.push_back({ static_cast<std::uint32_t>(this->FirstPoint + a),
      static_cast<std::uint32_t>(this->FirstPoint + b),
      static_cast<std::uint32_t>(this->FirstPoint + c) });
    this->Scene.Mesh.Cells.push_back(this->Cell);
  }

  void AppendStrip(vtkIdType count, const vtkIdType* points)
  {
    for (vtkIdType i = 0; i + 2 < count; ++i)
    {
      const vtkIdType odd = i % 2;
      this->AppendTriangle(points[i], points[i + 1 + odd], points[i + 2 - odd]);
    }
  }

  void AppendPolygon(vtkIdType count, const vtkIdType* points)
  {
    if (count == 3)
    {
      this->AppendTriangle(points[0], points[1], points[2]);
    }
    else if (count > 3)
    {
      this->AppendCut(count, points);
    }
  }

  void AppendCut(vtkIdType count, const vtkIdType* points)
  {
    this->Corners.clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Corners.push_back(this->Scene.Mesh.Points[this->FirstPoint + points[i]]);
    }
    const lms3dPolygonTriangles cut = lms3dCutPolygon(this->Corners);
    this->Scene.CrossedCells += cut.IsSimple ? 0 : 1;
    for (const std::array<int, 3>& triangle : cut.Triangles)
    {
      this->AppendTriangle(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
    }
  }

  std::vector<std::array<double, 3>> Corners;
  // As many as there are cells, or of no use.
  std::vector<std::int64_t> GlobalIds;
  vtkIdTypeArray* OriginalCells = nullptr;
  vtkUnsignedCharArray* Ghosts = nullptr;
  std::size_t FirstPoint = 0;
  std::int64_t FirstCell = 0;
  std::int64_t Cell = 0;
};
} // namespace

lms3dSceneTriangles lms3dCollectTriangles(
  vtkDataObject* scene, const std::function<bool(double)>& progress)
{
  Collector collector;
  collector.Append(scene);
  collector.TakeGlobalIds();
  collector.DropOwnNumbers();
  collector.ClearUnusable();
  collector.DropUnusedRoom();
  if (!progress(1.0))
  {
    lms3dSceneTriangles stopped;
    stopped.IsComplete = false;
    return stopped;
  }
  return std::move(collector.Scene);
}

std::string lms3dDescribeSkippedCells(const lms3dSceneTriangles& triangles, const std::string& what)
{
  std::ostringstream words;
  if (triangles.SkippedCells > 0)
  {
    words << what << ": cells with a point that is not finite, or beyond 1e18 m, are left out: "
          << triangles.SkippedCells << ". ";
  }
  if (triangles.CrossedCells > 0)
  {
    words << what << ": polygons that cross themselves are left out: " << triangles.CrossedCells
          << ". Split them to have them taken. ";
  }
  return words.str();
}
