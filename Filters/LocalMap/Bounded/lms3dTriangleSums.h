// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How the distances of returns from a triangle depend on the ranges of its corners.
 */
#ifndef lms3dTriangleSums_h
#define lms3dTriangleSums_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"

#include <array>

/**
 * A beam in the direction d meets the triangle at the inverse range sum(s_i x_i), where x_i are the
 * inverse ranges of the corners. The *share* s_i = d.o_i of a corner is linear in d, 1 at the
 * corner and 0 on the opposite edge. A return at the range r is then about
 * r^2 |sum(s_i x_i) - 1 / r| away, along its beam. So the sum of the squared distances is
 *
 *     sum(A_ij x_i x_j) - 2 sum(b_i x_i) + constant,   A_ij = sum(r^4 s_i s_j),  b_i = sum(r^3 s_i)
 *
 * Only returns within the bound count. (Beams beside a depth step can hit a triangle of the other
 * side.) Of a large triangle, every second or third beam, and so on, stands for all.
 */
class lms3dTriangleSums
{
public:
  /// A triangle that faces the sensor.
  struct Triangle
  {
    /// The positions of the corners are unit vectors.
    std::array<const lms3dTriangleCorner*, 3> Corners;
    /// The inverse ranges of the corners, 1/metre.
    std::array<double, 3> Inverses;
  };

  /// Sums of no beams.
  lms3dTriangleSums() = default;

  /// If the corners lie in one plane with the sensor, no beam counts.
  lms3dTriangleSums(const lms3dBeamDemands& demands, const Triangle& triangle);

  /// A_ij and b_i, with metres as the unit of ranges.
  double GetSquare(int i, int j) const { return this->Squares[i][j]; }
  double GetProduct(int i) const { return this->Products[i]; }

  /// The sum of the squared distances without the constant, for any inverse ranges of the corners.
  double GetSum(const std::array<double, 3>& inverses) const;

  /// The largest share that a corner has in one of the beams. 0 if there is none.
  double GetLargestShare(int i) const { return this->LargestShares[i]; }

  /// Whether all beams that hit a triangle meet it where their returns demand.
  static bool IsWithinBound(const lms3dBeamDemands& demands, const Triangle& triangle);

private:
  using Vectors = std::array<lms3dVector, 3>;

  /// The beams of a column that hit, rows included.
  struct Span
  {
    int Column;
    int First;
    int Last;
  };

  /// Sums over the beams of a column. A beam is the cosine of its row times the horizontal
  /// direction of the column, plus the sine of its row times the z axis.
  struct ColumnSums
  {
    /// The sums of r^4 times cosine or sine times cosine or sine.
    double CosineCosine = 0.0;
    double CosineSine = 0.0;
    double SineSine = 0.0;
    /// The sums of r^3 times cosine or sine.
    double Cosine = 0.0;
    double Sine = 0.0;
  };

  /// Sums over all beams, of r^4 times d d^T and of r^3 times d.
  struct BeamSums
  {
    void Add(const ColumnSums& column, double weight, const std::array<double, 2>& horizontal);

    Vectors Squares = {};
    lms3dVector Products = {};
  };

  static double GetVolume(const Triangle& triangle);
  static Vectors GetShares(const Triangle& triangle);
  static lms3dVector GetPlane(const Vectors& shares, const Triangle& triangle);
  ColumnSums AddUp(const lms3dBeamDemands& demands, const Span& span, int step,
    const Vectors& shares, const lms3dVector& plane);
  void SetSums(const BeamSums& beams, const Vectors& shares);
  static bool IsColumnWithinBound(
    const lms3dBeamDemands& demands, const Span& span, double level, double up);

  std::array<std::array<double, 3>, 3> Squares = {};
  std::array<double, 3> Products = {};
  std::array<double, 3> LargestShares = {};
};

#endif
