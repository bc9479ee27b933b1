// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dBruteForceCaster.h"
#include "Geometry/lms3dVector.h"

namespace
{
/// Source: T. Moeller, B. Trumbore, "Fast, minimum storage ray/triangle intersection", JGT 2(1),
/// 1997.
class MollerTrumboreTest
{
public:
  explicit MollerTrumboreTest(const lms3dSensorFrameTriangle& triangle)
  {
    const double* a = triangle.Corner[0];
    this->FirstEdge = lms3dSubtract(triangle.Corner[1], a);
    this->SecondEdge = lms3dSubtract(triangle.Corner[2], a);
    this->ToSensor = { -a[0], -a[1], -a[2] };
    this->Q = lms3dCross(this->ToSensor, this->FirstEdge);
  }

  double GetRange(const lms3dVector& direction) const
  {
    const lms3dVector p = lms3dCross(direction, this->SecondEdge);
    const double determinant = lms3dDot(this->FirstEdge, p);
    const double u = lms3dDot(this->ToSensor, p) / determinant;
    const double v = lms3dDot(direction, this->Q) / determinant;
    const bool isInside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    return isInside ? lms3dDot(this->SecondEdge, this->Q) / determinant : 0.0;
  }

private:
  lms3dVector FirstEdge;
  lms3dVector SecondEdge;
  lms3dVector ToSensor;
  lms3dVector Q;
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewMollerTrumboreCaster(
  lms3dTriangleMesh mesh, const lms3dProgress&)
{
  return std::make_unique<lms3dBruteForceCaster<MollerTrumboreTest>>(std::move(mesh));
}
