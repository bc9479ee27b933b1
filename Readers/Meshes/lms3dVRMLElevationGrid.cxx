// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes/lms3dVRMLColors.h"
#include "Meshes/lms3dVRMLGeometry.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
class Grid
{
public:
  Grid(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& node)
    : Evaluator(evaluator)
    , Node(node)
    , Heights(evaluator.GetReals(node, "height"))
    , Columns(this->GetDimension("xDimension"))
    , Rows(this->GetDimension("zDimension"))
    , Colors(evaluator, node)
  {
  }

  lms3dMesh MakeMesh()
  {
    this->CheckHeights();
    lms3dMesh mesh;
    if (!this->Evaluator.CountWork(this->Node, this->Heights->size() / 2))
    {
      return mesh;
    }
    this->AddPoints(mesh);
    for (std::int64_t row = 0; row + 1 < this->Rows; ++row)
    {
      for (std::int64_t column = 0; column + 1 < this->Columns; ++column)
      {
        this->AddQuadrilateral(row, column, mesh);
      }
    }
    if (this->Lost > 0)
    {
      this->Evaluator.ReportLoss(this->Node,
        std::to_string(this->Lost) +
          (this->Lost == 1 ? " square of an ElevationGrid is"
                           : " squares of an ElevationGrid are") +
          " lost: a height is not finite");
    }
    if (!this->Evaluator.GetBool(this->Node, "ccw", true))
    {
      lms3dFlip(mesh);
    }
    return mesh;
  }

private:
  std::int64_t GetDimension(const char* name)
  {
    return static_cast<std::int64_t>(
      std::fmax(0.0, std::fmin(this->Evaluator.GetNumber(this->Node, name, 0.0), 1e9)));
  }

  double GetSpacing(const char* name)
  {
    const double spacing = this->Evaluator.GetNumber(this->Node, name, 1.0);
    if (!(spacing > 0.0))
    {
      this->Evaluator.Warn(this->Node, std::string(name) + " of ElevationGrid is not positive");
    }
    return spacing;
  }

  // Keeps complete rows only.
  void CheckHeights()
  {
    const std::int64_t given = static_cast<std::int64_t>(this->Heights->size());
    const std::int64_t wanted = this->Columns * this->Rows;
    if (given < wanted)
    {
      this->Evaluator.ReportLoss(this->Node,
        "an ElevationGrid has " + std::to_string(given) + " heights in place of " +
          std::to_string(wanted));
      this->Rows = given / this->Columns;
    }
    else if (given > wanted)
    {
      this->Evaluator.Warn(this->Node,
        "an ElevationGrid has " + std::to_string(given) + " heights for " +
          std::to_string(this->Columns) + " times " + std::to_string(this->Rows) + " points");
    }
    this->Rows = this->Columns < 2 ? 0 : this->Rows;
  }

  void AddPoints(lms3dMesh& mesh)
  {
    const double xSpacing = this->GetSpacing("xSpacing");
    const double zSpacing = this->GetSpacing("zSpacing");
    const double unused = this->GetHeightOfUnused();
    for (std::int64_t row = 0; row < this->Rows; ++row)
    {
      for (std::int64_t column = 0; column < this->Columns; ++column)
      {
        const double height = (*this->Heights)[row * this->Columns + column];
        mesh.Points.push_back({ xSpacing * static_cast<double>(column),
          std::isfinite(height) ? height : unused, zSpacing * static_cast<double>(row) });
      }
    }
  }

  // Triangles do not use points that are not finite. Their height must not affect the bounds.
  double GetHeightOfUnused() const
  {
    const auto finite = std::find_if(this->Heights->begin(), this->Heights->end(),
      [](double height) { return std::isfinite(height); });
    return finite == this->Heights->end() ? 0.0 : *finite;
  }

  void AddQuadrilateral(std::int64_t row, std::int64_t column, lms3dMesh& mesh)
  {
    const std::int64_t i = row * this->Columns + column;
    const std::array<std::int64_t, 4> corners = { i, i + this->Columns, i + this->Columns + 1,
      i + 1 };
    for (std::int64_t corner : corners)
    {
      if (!std::isfinite((*this->Heights)[corner]))
      {
        ++this->Lost;
        return;
      }
    }
    const auto narrow = [&corners](int k) { return static_cast<std::int32_t>(corners[k]); };
    mesh.Triangles.push_back({ narrow(0), narrow(1), narrow(2) });
    mesh.Triangles.push_back({ narrow(0), narrow(2), narrow(3) });
    if (this->Colors.AreGiven())
    {
      const std::int64_t face = row * (this->Columns - 1) + column;
      for (const std::array<std::int64_t, 3>& triangle :
        { std::array<std::int64_t, 3>{ corners[0], corners[1], corners[2] },
          std::array<std::int64_t, 3>{ corners[0], corners[2], corners[3] } })
      {
        mesh.Colors.push_back(
          this->Colors.ArePerVertex() ? this->Colors.GetMean(triangle) : this->Colors.Get(face));
      }
    }
  }

  lms3dVRMLEvaluator& Evaluator;
  lms3dVRMLNodeInContext Node;
  std::shared_ptr<const lms3dVRMLReals> Heights;
  std::int64_t Columns;
  std::int64_t Rows;
  lms3dVRMLColors Colors;
  std::size_t Lost = 0;
};
} // namespace

lms3dMesh lms3dMakeElevationGrid(lms3dVRMLEvaluator& evaluator, const lms3dVRMLNodeInContext& grid)
{
  return Grid(evaluator, grid).MakeMesh();
}
