// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Surfaces of triangles, which are copied on all threads, beside the copy of cell by cell.
 */
#include "Geometry/lms3dTriangleMesh.h"
#include "Scene/lms3dPlainTriangles.h"
#include "Scene/lms3dSurfaceTriangles.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <vector>

namespace
{
// Enough for several tasks.
constexpr vtkIdType Count = 30000;

struct Surface
{
  explicit Surface(bool is64Bit = true)
  {
    if (is64Bit)
    {
      this->Cells->Use64BitStorage();
    }
    else
    {
      this->Cells->Use32BitStorage();
    }
    this->Points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < Count + 2; ++i)
    {
      const double x = static_cast<double>(i);
      this->Points->InsertNextPoint(x, std::sin(x), std::cos(x));
    }
    for (vtkIdType i = 0; i < Count; ++i)
    {
      this->Add({ i, i + 1 + i % 2, i + 2 - i % 2 });
    }
  }

  void Add(std::initializer_list<vtkIdType> corners) { this->Cells->InsertNextCell(corners); }

  vtkSmartPointer<vtkPolyData> Get() const
  {
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(this->Points);
    surface->SetPolys(this->Cells);
    return surface;
  }

  /// The same, with an array of ghosts that hides nothing.
  vtkSmartPointer<vtkPolyData> GetWithGhosts() const
  {
    vtkSmartPointer<vtkPolyData> surface = this->Get();
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(surface->GetNumberOfCells());
    ghosts->FillValue(0);
    surface->GetCellData()->AddArray(ghosts);
    return surface;
  }

  bool AppendPlain(lms3dTriangleMesh& mesh) const
  {
    return lms3dAppendPlainTriangles(this->Cells, 0, mesh);
  }

  /// A mesh with the points alone.
  lms3dTriangleMesh MakeMesh() const
  {
    lms3dTriangleMesh mesh;
    for (vtkIdType i = 0; i < this->Points->GetNumberOfPoints(); ++i)
    {
      mesh.Points.emplace_back();
      this->Points->GetPoint(i, mesh.Points.back().data());
    }
    return mesh;
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
};

lms3dTriangleMesh Collect(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces)
{
  lms3dTriangleMesh mesh;
  lms3dSurfaceTriangles triangles(mesh, "The scene");
  std::int64_t cell = 0;
  for (vtkPolyData* surface : surfaces)
  {
    EXPECT_TRUE(triangles.Append(surface, nullptr, cell, [](double) { return true; }));
    cell += surface->GetNumberOfCells();
  }
  return mesh;
}

void ExpectSame(const lms3dTriangleMesh& mesh, const lms3dTriangleMesh& expected)
{
  EXPECT_EQ(mesh.Points, expected.Points);
  EXPECT_EQ(mesh.Triangles, expected.Triangles);
  EXPECT_EQ(mesh.Cells, expected.Cells);
}
} // namespace

TEST(PlainTriangles, AreThoseOfCellByCell)
{
  for (const bool is64Bit : { true, false })
  {
    const Surface surface(is64Bit);
    const lms3dTriangleMesh mesh = Collect({ surface.Get() });
    EXPECT_EQ(mesh.Triangles.size(), static_cast<std::size_t>(Count));
    EXPECT_TRUE(mesh.Cells.empty());
    ExpectSame(mesh, Collect({ surface.GetWithGhosts() }));
  }
}

/// Behind a surface with a vertex, triangle i is no longer cell i.
TEST(PlainTriangles, OfSeveralSurfacesKeepTheirCells)
{
  const Surface first;
  const Surface second;
  for (const bool hasVertex : { false, true })
  {
    std::vector<vtkSmartPointer<vtkPolyData>> plain = { first.Get(), second.Get(), first.Get() };
    std::vector<vtkSmartPointer<vtkPolyData>> others = { first.GetWithGhosts(),
      second.GetWithGhosts(), first.GetWithGhosts() };
    if (hasVertex)
    {
      vtkNew<vtkCellArray> vertices;
      vertices->InsertNextCell({ 0 });
      plain[1]->SetVerts(vertices);
      others[1] = plain[1]; // Only the first and the last have ghosts then.
    }
    const lms3dTriangleMesh mesh = Collect(plain);
    ExpectSame(mesh, Collect(others));
    EXPECT_EQ(mesh.Triangles.size(), static_cast<std::size_t>(3 * Count));
    EXPECT_EQ(mesh.Cells.empty(), !hasVertex);
    EXPECT_EQ(mesh.GetCell(Count), Count + (hasVertex ? 1 : 0));
    EXPECT_EQ(mesh.GetCell(3 * Count - 1), 3 * Count - (hasVertex ? 0 : 1));
  }
}

TEST(PlainTriangles, LeaveOtherCellsToTheirWay)
{
  const auto expectRefused = [](const Surface& surface)
  {
    lms3dTriangleMesh mesh = surface.MakeMesh();
    mesh.Triangles.push_back({ 0, 1, 2 });
    EXPECT_FALSE(surface.AppendPlain(mesh));
    EXPECT_EQ(mesh.Triangles.size(), 1U);
  };
  Surface quadrilateral;
  quadrilateral.Add({ 0, 1, 2, 3 });
  expectRefused(quadrilateral);
  quadrilateral.Add({ 0, 1 }); // Now three corners a cell on average.
  expectRefused(quadrilateral);
  EXPECT_EQ(Collect({ quadrilateral.Get() }).Triangles.size(), static_cast<std::size_t>(Count + 2));
  for (const double x : { 2e18, HUGE_VAL, std::nan("") })
  {
    Surface far;
    far.Points->SetPoint(Count, x, 0.0, 0.0);
    expectRefused(far);
    EXPECT_EQ(Collect({ far.Get() }).Triangles.size(), static_cast<std::size_t>(Count - 2));
  }
  for (const vtkIdType point : { vtkIdType(-1), Count + 2 })
  {
    Surface missing;
    missing.Add({ 0, 1, point });
    expectRefused(missing);
    EXPECT_THROW(Collect({ missing.Get() }), std::runtime_error);
  }
}

/// The cells from 10,000 on would begin far behind the corners.
TEST(PlainTriangles, AreRefusedWithBrokenOffsets)
{
  for (const vtkIdType gap : { 3LL, 4000000000LL })
  {
    const Surface surface;
    vtkTypeInt64Array* offsets = surface.Cells->GetOffsetsArray64();
    for (vtkIdType i = 10000; i < Count; ++i)
    {
      offsets->SetValue(i, 3 * i + gap);
    }
    lms3dTriangleMesh mesh = surface.MakeMesh();
    EXPECT_FALSE(surface.AppendPlain(mesh));
    EXPECT_TRUE(mesh.Triangles.empty());
    if (gap > 3)
    {
      EXPECT_THROW(Collect({ surface.Get() }), std::runtime_error);
    }
  }
}

TEST(PlainTriangles, OfAnEmptySurfaceAreNone)
{
  const Surface surface;
  surface.Cells->Reset();
  lms3dTriangleMesh mesh = surface.MakeMesh();
  EXPECT_TRUE(surface.AppendPlain(mesh));
  EXPECT_TRUE(mesh.Triangles.empty());
}
