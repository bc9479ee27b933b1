// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Converts the polygons and triangle strips of a vtkPolyData to triangles.
 */
#ifndef lms3dSurfaceTriangles_h
#define lms3dSurfaceTriangles_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Geometry/lms3dTriangulator.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <vtkType.h>

class vtkCellArray;
class vtkIdTypeArray;
class vtkPolyData;
class vtkUnsignedCharArray;

/// Appends surfaces to a mesh, which must outlive it.
class lms3dSurfaceTriangles
{
public:
  /// Receives the fraction of one surface that is done, 0 to 1. Returns false to stop.
  using Progress = std::function<bool(double)>;

  /// `name` begins the texts for the user, for example "The scene".
  lms3dSurfaceTriangles(lms3dTriangleMesh& mesh, std::string name)
    : Mesh(mesh)
    , Name(std::move(name))
  {
  }

  /**
   * Appends the points, the triangles and the cell of each triangle. Cells are numbered from
   * `firstCell` in the order of vtkPolyData: vertices, lines, polygons, strips. `originalCells` can
   * be null; otherwise it maps these numbers.
   *
   * Skips cells that vtkGhostType marks as HIDDENCELL, and cells with a coordinate that is not
   * finite or exceeds 1e18 m. Returns false if `progress` stopped the work; the mesh is then
   * incomplete. Triangles that lms3dAppendPlainTriangles appends come before the first report.
   * Throws std::runtime_error, with a text for the user, if a cell uses a missing point, if the
   * cells' offsets are not in order, or if there are too many points or triangles.
   */
  bool Append(vtkPolyData* surface, vtkIdTypeArray* originalCells, std::int64_t firstCell,
    const Progress& progress);

  /// Returns the number of cells that were skipped because of their coordinates.
  std::int64_t GetSkippedCells() const { return this->SkippedCells; }

  ///@{
  /// Returns the number of polygons that lms3dTriangulator did not cut exactly, and the first one's
  /// cell, -1 without any.
  std::int64_t GetCrossedCells() const { return this->CrossedCells; }
  std::int64_t GetFirstCrossedCell() const { return this->FirstCrossedCell; }
  ///@}

  /// Returns the number of cells that were skipped because vtkGhostType marks them as HIDDENCELL.
  std::int64_t GetHiddenCells() const { return this->HiddenCells; }

private:
  using AppendCell = void (lms3dSurfaceTriangles::*)(vtkIdType count, const vtkIdType* points);

  /// Appends cells that are all plain triangles. Returns false, and appends none, if they are not.
  bool AppendTriangles(vtkCellArray* cells, vtkIdType firstCell);
  void AppendCells(
    vtkCellArray* cells, vtkIdType firstCell, vtkIdTypeArray* originalCells, AppendCell append);
  void AppendTriangle(vtkIdType a, vtkIdType b, vtkIdType c);
  /// Lists the current cell for the triangle that follows, if cells have to be listed.
  void AddCellOfNextTriangle();
  void AppendStrip(vtkIdType count, const vtkIdType* points);
  void AppendPolygon(vtkIdType count, const vtkIdType* points);
  void TriangulatePolygon(vtkIdType count, const vtkIdType* points);
  /// Returns false, and counts the cell, if a coordinate is out of range.
  bool IsUsable(vtkIdType count, const vtkIdType* points);
  /// Returns true, and counts the cell, if it is hidden. `cell` is its number in the surface.
  bool IsHidden(vtkIdType cell);
  /// Reports the progress. Returns false, now and from then on, if the user stopped the work.
  bool ReportProgress();

  lms3dTriangleMesh& Mesh;
  const std::string Name;
  std::int64_t SkippedCells = 0;
  std::int64_t CrossedCells = 0;
  std::int64_t FirstCrossedCell = -1;
  std::int64_t HiddenCells = 0;

  ///@{
  /// The state of one Append().
  const Progress* Reporter = nullptr;
  bool IsStopped = false;
  /// Null if the surface has no ghost cells.
  vtkUnsignedCharArray* Ghosts = nullptr;
  std::size_t FirstPoint = 0;
  std::int64_t FirstCell = 0;
  std::int64_t Cell = 0;
  /// In corners of cells.
  vtkIdType TotalWork = 0;
  vtkIdType WorkDone = 0;
  ///@}

  std::vector<lms3dVector> Corners;
  /// Cuts quadrilaterals from corner 1 to corner 3.
  lms3dTriangulator Triangulator{ lms3dTriangulator::LAST_CORNER };
};

#endif
