// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A plane with the frame of its raster.
 */
#ifndef lms3dPlaneFrame_h
#define lms3dPlaneFrame_h

#include "Fusion/Cells/lms3dRaster.h"
#include "Fusion/Scans/lms3dWorldBox.h"
#include "Geometry/lms3dVector.h"
#include "Triangulation/lms3dOrientation.h"

#include <cmath>

class lms3dPlaneFrame
{
public:
  /// A plane through a point with a normal of length 1. `cell` is the size of a cell, metres. Walls
  /// have horizontal rows, so the raster follows the edges of most rooms. The first cell is near
  /// the foot of `middle`, whole blocks from the foot of the world's origin. Along an axis on which
  /// this would be more than 1e8 cells, it is at the foot of the origin, so that 32 bits can number
  /// all cells.
  lms3dPlaneFrame(
    const lms3dVector& point, const lms3dVector& normal, double cell, const lms3dVector& middle)
    : Offset(lms3dDot(normal, point))
    , Cell(cell)
    , Normal(normal)
    , U(lms3dNormalize(std::abs(normal[2]) > 0.9 ? lms3dCross({ 0.0, 1.0, 0.0 }, normal)
                                                 : lms3dCross({ 0.0, 0.0, 1.0 }, normal)))
    , V(lms3dCross(normal, this->U))
    , Origin({ GetOrigin(lms3dDot(this->U, middle) / cell),
        GetOrigin(lms3dDot(this->V, middle) / cell) })
  {
  }

  const lms3dVector& GetNormal() const { return this->Normal; }
  double GetCell() const { return this->Cell; }

  /// The distance in front of the plane, metres.
  double GetHeight(const lms3dVector& point) const
  {
    return lms3dDot(this->Normal, point) - this->Offset;
  }

  /// Whether a box is nearer than a distance, metres.
  bool IsNear(const lms3dWorldBox& box, double distance) const
  {
    double nearest = std::abs(this->GetHeight(lms3dScale(lms3dAdd(box.Low, box.High), 0.5)));
    for (int axis = 0; axis < 3; ++axis)
    {
      nearest -= 0.5 * std::abs(this->Normal[axis]) * (box.High[axis] - box.Low[axis]);
    }
    return nearest <= distance;
  }

  /// The corner of the first cell. It is the middle of the first tile.
  lms3dVector GetMiddle() const { return this->ToWorld({ 0.0, 0.0 }); }

  /// The foot of a point, cells.
  lms3dPoint2 ToCells(const lms3dVector& point) const
  {
    return { lms3dDot(this->U, point) / this->Cell - this->Origin[0],
      lms3dDot(this->V, point) / this->Cell - this->Origin[1] };
  }

  lms3dVector ToWorld(const lms3dPoint2& cells) const
  {
    return lms3dAdd(lms3dScale(this->Normal, this->Offset),
      lms3dAdd(lms3dScale(this->U, (cells[0] + this->Origin[0]) * this->Cell),
        lms3dScale(this->V, (cells[1] + this->Origin[1]) * this->Cell)));
  }

private:
  /// Cells: the size of a block.
  static constexpr double Step = lms3dRaster::Size;
  /// Cells.
  static constexpr double FarthestOrigin = 1e8;

  static double GetOrigin(double middle)
  {
    return std::abs(middle) <= FarthestOrigin ? Step * std::round(middle / Step) : 0.0;
  }

  double Offset;
  double Cell;
  lms3dVector Normal;
  lms3dVector U;
  lms3dVector V;
  /// Cells: where the first cell is from the foot of the world's origin.
  lms3dPoint2 Origin;
};

#endif
