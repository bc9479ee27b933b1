// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dBruteForceCaster.h"

namespace
{
/// T. Moeller, B. Trumbore, "Fast, minimum storage ray/triangle intersection", JGT 2(1), 1997.
class MollerTrumboreTest
{
public:
  explicit MollerTrumboreTest(const lms3dSeenTriangle& triangle)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->FirstEdge[axis] = triangle.Corner[1][axis] - triangle.Corner[0][axis];
      this->SecondEdge[axis] = triangle.Corner[2][axis] - triangle.Corner[0][axis];
      this->ToSensor[axis] = -triangle.Corner[0][axis];
    }
    Cross(this->ToSensor, this->FirstEdge, this->Q);
  }

  double GetRange(const double direction[3]) const
  {
    double p[3];
    Cross(direction, this->SecondEdge, p);
    const double determinant = Dot(this->FirstEdge, p);
    const double u = Dot(this->ToSensor, p) / determinant;
    const double v = Dot(direction, this->Q) / determinant;
    const bool isInside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    return isInside ? Dot(this->SecondEdge, this->Q) / determinant : 0.0;
  }

private:
  static void Cross(const double p[3], const double q[3], double out[3])
  {
    out[0] = p[1] * q[2] - p[2] * q[1];
    out[1] = p[2] * q[0] - p[0] * q[2];
    out[2] = p[0] * q[1] - p[1] * q[0];
  }

  static double Dot(const double p[3], const double q[3])
  {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  }

  double FirstEdge[3];
  double SecondEdge[3];
  double ToSensor[3];
  double Q[3];
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewMollerTrumboreCaster(
  lms3dTriangleMesh mesh, const lms3dProgress&)
{
  return std::make_unique<lms3dBruteForceCaster<MollerTrumboreTest>>(std::move(mesh));
}
