// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The beams that hit a triangle, kept for several uses.
 */
#ifndef lms3dTriangleBeams_h
#define lms3dTriangleBeams_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"

#include <array>
#include <vector>

/**
 * The beams that hit a triangle while its corners keep their directions. The ranges of the corners
 * may change.
 *
 * A beam in the direction d meets the triangle at the inverse range sum(s_i x_i), where x_i are the
 * inverse ranges of the corners. The *share* s_i = d.o_i of a corner is linear in d, 1 at the
 * corner and 0 on the opposite edge.
 */
class lms3dTriangleBeams
{
public:
  /// The positions of the corners are unit vectors.
  using Corners = std::array<const lms3dTriangleCorner*, 3>;
  /// The vectors o_i.
  using Shares = std::array<lms3dVector, 3>;

  /// The beams of a column that hit, rows included.
  struct Span
  {
    int Column;
    int First;
    int Last;
  };

  /// No beams.
  lms3dTriangleBeams() = default;

  /// Beams must be regular. The triangle must face the sensor, or lie in one plane with it.
  lms3dTriangleBeams(const lms3dBeamSphere& sphere, const Corners& corners);

  /// False if the triangle lies in one plane with the sensor, and without a triangle. Then the
  /// shares are not valid.
  bool FacesSensor() const { return this->IsFacingSensor; }

  /// At most one for each column, in the order of lms3dTriangleRasterizer.
  const std::vector<Span>& GetSpans() const { return this->Spans; }
  /// The number of columns that can have beams that hit.
  int GetNumberOfColumns() const { return this->NumberOfColumns; }
  const Shares& GetShares() const { return this->SharesOfCorners; }

  /// The inverse range on the triangle, in a direction, is its product with this vector. Takes the
  /// inverse ranges of the corners, 1/metre.
  lms3dVector GetPlane(const std::array<double, 3>& inverses) const;

  /// Whether all beams meet the triangle where their returns demand.
  bool AreWithinBound(const lms3dBeamDemands& demands, const std::array<double, 3>& inverses) const;

  /**
   * The sum of the squared distances of the returns from the plane of the triangle, each times the
   * area that its beam stands for, apart from a constant. For a plane q with 1 / range = q.d, the
   * cosine of incidence is 1 / (range |q|). At the elevation e, the beam stands for an area of
   * range^2 cos(e) over this cosine, and a distance along the beam is this cosine times as far from
   * the plane. So the square of a distance along the beam has the weight range cos(e) / |q|.
   */
  double GetSum(const lms3dBeamDemands& demands, const std::array<double, 3>& inverses) const;

  ///@{
  /// The factors of that weight: 1 / |q|, which all beams share, and range cos(e).
  static double GetScale(const lms3dVector& plane) { return 1.0 / lms3dGetLength(plane); }
  static double GetWeight(double range, double cosine) { return range * cosine; }
  ///@}

private:
  static bool AreWithin(
    const lms3dBeamDemands& demands, const lms3dVector& plane, const Span* first, const Span* last);

  bool IsFacingSensor = false;
  int NumberOfColumns = 0;
  std::vector<Span> Spans;
  Shares SharesOfCorners = {};
};

#endif
