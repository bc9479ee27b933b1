// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How the distances of returns from a triangle depend on the ranges of its corners.
 */
#ifndef lms3dTriangleSums_h
#define lms3dTriangleSums_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dTriangleBeams.h"

#include <array>

/**
 * A beam meets the triangle at the inverse range sum(s_i x_i), where x_i are the inverse ranges of
 * the corners and s_i their shares (lms3dTriangleBeams). A return at the range r is then about
 * r^2 |sum(s_i x_i) - 1 / r| away, along its beam. So the sum of the squared distances, each with
 * the weight w of lms3dTriangleBeams::GetSum(), is
 *
 *     sum(A_ij x_i x_j) - 2 sum(b_i x_i) + constant
 *     A_ij = sum(w r^4 s_i s_j),  b_i = sum(w r^3 s_i)
 *
 * The weight is that of the plane before the corners move.
 *
 * Only returns within the bound count. (Beams beside a depth step can hit a triangle of the other
 * side.) Of a large triangle, every second or third beam, and so on, stands for all.
 */
class lms3dTriangleSums
{
public:
  /// Sums of no beams.
  lms3dTriangleSums() = default;

  /// Takes the inverse ranges of the corners, 1/metre. If the triangle is flat, no beam counts.
  lms3dTriangleSums(const lms3dBeamDemands& demands, const lms3dTriangleBeams& beams,
    const std::array<double, 3>& inverses);

  /// A_ij and b_i, with metres as the unit of ranges.
  double GetSquare(int i, int j) const { return this->Squares[i][j]; }
  double GetProduct(int i) const { return this->Products[i]; }

  /// The sum of the squared distances without the constant, for any inverse ranges of the corners.
  double GetSum(const std::array<double, 3>& inverses) const;

  /// The largest share that a corner has in one of the beams. 0 if there is none.
  double GetLargestShare(int i) const { return this->LargestShares[i]; }

private:
  using Shares = lms3dTriangleBeams::Shares;

  /// Sums over the beams of a column. A beam is the cosine of its row times the horizontal
  /// direction of the column, plus the sine of its row times the z axis.
  struct ColumnSums
  {
    /// The sums of w r^4 times cosine or sine times cosine or sine.
    double CosineCosine = 0.0;
    double CosineSine = 0.0;
    double SineSine = 0.0;
    /// The sums of w r^3 times cosine or sine.
    double Cosine = 0.0;
    double Sine = 0.0;
  };

  /// Sums over all beams, of w r^4 times d d^T and of w r^3 times d.
  struct BeamSums
  {
    void Add(const ColumnSums& column, double weight, const std::array<double, 2>& horizontal);

    std::array<lms3dVector, 3> Squares = {};
    lms3dVector Products = {};
  };

  ColumnSums AddUp(const lms3dBeamDemands& demands, const lms3dTriangleBeams::Span& span, int step,
    const Shares& shares, const lms3dVector& plane);
  void SetSums(const BeamSums& beams, const Shares& shares);

  std::array<std::array<double, 3>, 3> Squares = {};
  std::array<double, 3> Products = {};
  std::array<double, 3> LargestShares = {};
};

#endif
