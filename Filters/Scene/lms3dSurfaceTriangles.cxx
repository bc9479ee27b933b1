// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dSurfaceTriangles.h"

#include "Scene/lms3dPlainTriangles.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace
{
// Embree and the packets number triangles by 32 bits.
constexpr std::size_t MaximumNumberOfTriangles = std::numeric_limits<std::int32_t>::max();

// The number of corners of cells between two reports of progress.
constexpr vtkIdType WorkPerReport = 1 << 16;

// A composite calls once for each leaf, so the memory grows by at least a half.
template <typename Vector>
void ReserveMore(Vector& vector, std::size_t more)
{
  const std::size_t needed = vector.size() + more;
  if (needed > vector.capacity())
  {
    vector.reserve(std::max(needed, vector.capacity() + vector.capacity() / 2));
  }
}

template <typename ArrayT>
void CopyPoints(ArrayT* array, lms3dTrianglePoints& points)
{
  const auto* value = array->GetPointer(0);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i, value += 3)
  {
    points.push_back({ static_cast<double>(value[0]), static_cast<double>(value[1]),
      static_cast<double>(value[2]) });
  }
}

void AppendPoints(vtkPoints* points, lms3dTrianglePoints& out)
{
  if (!points)
  {
    return;
  }
  ReserveMore(out, points->GetNumberOfPoints());
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

[[noreturn]] void RefuseTriangles(const std::string& name)
{
  throw std::runtime_error(
    name + " has more triangles than 31 bits can number; split it or simplify it.");
}
} // namespace

bool lms3dSurfaceTriangles::Append(vtkPolyData* surface, vtkIdTypeArray* originalCells,
  std::int64_t firstCell, const Progress& progress)
{
  vtkCellArray* polygons = surface->GetPolys();
  vtkCellArray* strips = surface->GetStrips();
  if (polygons->GetNumberOfCells() + strips->GetNumberOfCells() == 0)
  {
    return true;
  }
  this->FirstPoint = this->Mesh.Points.size();
  AppendPoints(surface->GetPoints(), this->Mesh.Points);
  ReserveMore(this->Mesh.Triangles, polygons->GetNumberOfCells());
  if (this->Mesh.Points.size() > std::numeric_limits<std::uint32_t>::max())
  {
    throw std::runtime_error(this->Name + " has more points than 32 bits can number; split it.");
  }
  this->Ghosts = surface->GetCellGhostArray();
  this->Reporter = &progress;
  this->IsStopped = false;
  this->FirstCell = firstCell;
  this->TotalWork = polygons->GetNumberOfConnectivityIds() + strips->GetNumberOfConnectivityIds();
  this->WorkDone = 0;
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  if (originalCells || this->Ghosts || !this->AppendTriangles(polygons, cell))
  {
    this->AppendCells(polygons, cell, originalCells, &lms3dSurfaceTriangles::AppendPolygon);
  }
  cell += polygons->GetNumberOfCells();
  this->AppendCells(strips, cell, originalCells, &lms3dSurfaceTriangles::AppendStrip);
  this->Reporter = nullptr;
  return !this->IsStopped;
}

bool lms3dSurfaceTriangles::ReportProgress()
{
  const double total = static_cast<double>(std::max<vtkIdType>(this->TotalWork, 1));
  this->IsStopped =
    this->IsStopped || !(*this->Reporter)(static_cast<double>(this->WorkDone) / total);
  return !this->IsStopped;
}

bool lms3dSurfaceTriangles::AppendTriangles(vtkCellArray* cells, vtkIdType firstCell)
{
  const std::int64_t before = static_cast<std::int64_t>(this->Mesh.Triangles.size());
  const bool isListed = !this->Mesh.Cells.empty() || this->FirstCell + firstCell != before;
  if (isListed)
  {
    this->Mesh.ListCells();
  }
  if (!lms3dAppendPlainTriangles(cells, this->FirstPoint, this->Mesh))
  {
    return false;
  }
  if (isListed)
  {
    this->Mesh.Cells.resize(this->Mesh.Triangles.size());
    std::iota(
      this->Mesh.Cells.begin() + before, this->Mesh.Cells.end(), this->FirstCell + firstCell);
  }
  this->WorkDone += cells->GetNumberOfConnectivityIds();
  if (this->WorkDone >= WorkPerReport)
  {
    this->ReportProgress();
  }
  return true;
}

void lms3dSurfaceTriangles::AppendCells(
  vtkCellArray* cells, vtkIdType firstCell, vtkIdTypeArray* originalCells, AppendCell append)
{
  if (cells->GetNumberOfCells() > 0 && !cells->IsValid())
  {
    throw std::runtime_error(this->Name +
      ": the offsets of its cells do not start at 0, decrease, "
      "or do not end with the last corner. Repair them.");
  }
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  vtkIdType cell = firstCell;
  vtkIdType nextReport = this->WorkDone + WorkPerReport;
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal() && !this->IsStopped;
       it->GoToNextCell(), ++cell)
  {
    vtkIdType count;
    const vtkIdType* points;
    it->GetCurrentCell(count, points);
    this->Cell = this->FirstCell + (originalCells ? originalCells->GetValue(cell) : cell);
    if (!this->IsHidden(cell) && this->IsUsable(count, points))
    {
      (this->*append)(count, points);
    }
    this->WorkDone += count;
    if (this->WorkDone >= nextReport)
    {
      nextReport = this->WorkDone + WorkPerReport;
      this->ReportProgress();
    }
  }
}

bool lms3dSurfaceTriangles::IsHidden(vtkIdType cell)
{
  const bool isHidden = this->Ghosts && cell < this->Ghosts->GetNumberOfValues() &&
    (this->Ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0;
  this->HiddenCells += isHidden ? 1 : 0;
  return isHidden;
}

bool lms3dSurfaceTriangles::IsUsable(vtkIdType count, const vtkIdType* points)
{
  const lms3dTrianglePoints& all = this->Mesh.Points;
  const vtkIdType pointsOfSurface = static_cast<vtkIdType>(all.size() - this->FirstPoint);
  bool isFinite = true;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (points[i] < 0 || points[i] >= pointsOfSurface)
    {
      throw std::runtime_error(this->Name + ": cell " + std::to_string(this->Cell) +
        " uses point " + std::to_string(points[i]) + " of " + std::to_string(pointsOfSurface) +
        ". Repair the cell.");
    }
    isFinite = isFinite && lms3dIsUsable(all[this->FirstPoint + points[i]]);
  }
  this->SkippedCells += isFinite ? 0 : 1;
  return isFinite;
}

void lms3dSurfaceTriangles::AppendTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  if (this->Mesh.Triangles.size() >= MaximumNumberOfTriangles)
  {
    RefuseTriangles(this->Name);
  }
  this->AddCellOfNextTriangle();
  this->Mesh.Triangles.push_back({ static_cast<std::uint32_t>(this->FirstPoint + a),
    static_cast<std::uint32_t>(this->FirstPoint + b),
    static_cast<std::uint32_t>(this->FirstPoint + c) });
}

// As long as triangle i is cell i, the mesh needs no list.
void lms3dSurfaceTriangles::AddCellOfNextTriangle()
{
  const auto triangle = static_cast<std::int64_t>(this->Mesh.Triangles.size());
  if (!this->Mesh.Cells.empty() || this->Cell != triangle)
  {
    this->Mesh.ListCells();
    this->Mesh.Cells.push_back(this->Cell);
  }
}

void lms3dSurfaceTriangles::AppendStrip(vtkIdType count, const vtkIdType* points)
{
  for (vtkIdType i = 0; i + 2 < count; ++i)
  {
    const vtkIdType odd = i % 2;
    this->AppendTriangle(points[i], points[i + 1 + odd], points[i + 2 - odd]);
  }
}

void lms3dSurfaceTriangles::AppendPolygon(vtkIdType count, const vtkIdType* points)
{
  if (count == 3)
  {
    this->AppendTriangle(points[0], points[1], points[2]);
  }
  else if (count > 3)
  {
    this->TriangulatePolygon(count, points);
  }
}

void lms3dSurfaceTriangles::TriangulatePolygon(vtkIdType count, const vtkIdType* points)
{
  if (static_cast<std::size_t>(count) > MaximumNumberOfTriangles)
  {
    RefuseTriangles(this->Name);
  }
  this->Corners.clear();
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->Corners.push_back(this->Mesh.Points[this->FirstPoint + points[i]]);
  }
  const bool isSimple =
    this->Triangulator.Cut(this->Corners, [this] { return this->ReportProgress(); });
  if (!isSimple && !this->IsStopped)
  {
    this->FirstCrossedCell = this->CrossedCells == 0 ? this->Cell : this->FirstCrossedCell;
    ++this->CrossedCells;
  }
  for (const lms3dTriangulator::Triangle& triangle : this->Triangulator.GetTriangles())
  {
    this->AppendTriangle(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
  }
}
