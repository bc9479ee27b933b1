// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dSurfaceNormals.h"

#include "Casting/lms3dTriangle.h"
#include "Geometry/lms3dAngle.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cmath>
#include <cstddef>

namespace
{
// Enough for a whole scan of a small scene.
constexpr std::size_t NumberOfEntries = 1024;
} // namespace

lms3dSurfaceNormals::lms3dSurfaceNormals(const lms3dTriangleMesh& mesh)
  : Mesh(mesh)
  , Triangles(NumberOfEntries, lms3dBeamPacket::NoTriangle)
  , Normals(NumberOfEntries)
  , FacingTriangle(lms3dBeamPacket::NoTriangle)
{
}

const lms3dVector& lms3dSurfaceNormals::Get(std::int32_t triangle)
{
  const std::size_t entry = static_cast<std::size_t>(triangle) % NumberOfEntries;
  if (this->Triangles[entry] != triangle)
  {
    this->Triangles[entry] = triangle;
    this->Normals[entry] = this->Compute(triangle);
  }
  return this->Normals[entry];
}

lms3dVector lms3dSurfaceNormals::GetFacing(std::int32_t triangle, const lms3dVector& position)
{
  if (triangle != this->FacingTriangle || position != this->FacingPosition)
  {
    this->FacingTriangle = triangle;
    this->FacingPosition = position;
    this->IsOpposite = lms3dGetSide(lms3dGetCorners(this->Mesh, triangle), position.data()) < 0;
  }
  const lms3dVector& normal = this->Get(triangle);
  return this->IsOpposite ? lms3dScale(normal, -1.0) : normal;
}

// Double precision would lose the normals of needles.
lms3dVector lms3dSurfaceNormals::Compute(std::int32_t triangle) const
{
  const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
  const lms3dDoubleDoublePlane plane =
    lms3dGetPacketKernels().MakeDoubleDoublePlane(corners.data(), corners[0]);
  return lms3dNormalize({ plane.Normal[0].High, plane.Normal[1].High, plane.Normal[2].High });
}

// An arc cosine would lose half of the digits near 0.
double lms3dGetIncidence(const lms3dVector& direction, const lms3dVector& normal)
{
  return lms3dDegreesPerRadian *
    std::atan2(
      lms3dGetLength(lms3dCross(direction, normal)), lms3dGetIncidenceCosine(direction, normal));
}
