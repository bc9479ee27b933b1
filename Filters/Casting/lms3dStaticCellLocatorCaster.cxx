// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTriangle.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>

namespace
{
// In metres. With 0 the locator misses beams on edges; with 1e-2 it hits beside triangles.
constexpr double Tolerance = 1e-9;

/// Uses vtkStaticCellLocator, for comparison.
class StaticCellLocatorCaster final : public lms3dRayCaster
{
public:
  explicit StaticCellLocatorCaster(lms3dTriangleMesh mesh)
    : lms3dRayCaster(std::move(mesh))
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const std::array<double, 3>& point : this->GetMesh().Points)
    {
      points->InsertNextPoint(point.data());
    }
    vtkNew<vtkCellArray> polygons;
    for (const std::array<std::uint32_t, 3>& triangle : this->GetMesh().Triangles)
    {
      const vtkIdType corners[3] = { triangle[0], triangle[1], triangle[2] };
      polygons->InsertNextCell(3, corners);
    }
    this->Surface->SetPoints(points);
    this->Surface->SetPolys(polygons);
    this->Surface->GetBounds(this->Bounds);
    this->Locator->SetDataSet(this->Surface);
    this->Locator->BuildLocator();
  }

  void FindNearest(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    const double length = std::min(origin.MaximumRange, this->GetMaximumLength(origin.Position));
    vtkNew<vtkGenericCell> cell;
    for (int i = 0; i < count; ++i)
    {
      lms3dSetTriangle(lms3dBeamPacket::NoTriangle, packets[i]);
      for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
      {
        if (lms3dHasBit(packets[i].Active, beam))
        {
          this->CastBeam(origin.Position, length, beam, packets[i], cell);
        }
      }
    }
  }

private:
  void CastBeam(const double origin[3], double length, int beam, lms3dBeamPacket& packet,
    vtkGenericCell* cell) const
  {
    double end[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      end[axis] = origin[axis] + length * packet.Direction[axis][beam];
    }
    const Hit hit = this->FindNearest(origin, end, cell);
    packet.Range[beam] = hit.Share * length;
    packet.Triangle[beam] = static_cast<std::int32_t>(hit.Triangle);
  }

  /// The nearest hit. Share is the position along the line, from 0 to 1.
  struct Hit
  {
    double Share = lms3dBeamPacket::NoRange;
    vtkIdType Triangle = lms3dBeamPacket::NoTriangle;
  };

  bool IsInFront(const Hit& hit, const double origin[3]) const
  {
    return hit.Share > 0.0 &&
      !lms3dIsEdgeOn(lms3dGetCorners(this->GetMesh(), hit.Triangle), origin);
  }

  Hit FindNearest(const double origin[3], const double end[3], vtkGenericCell* cell) const
  {
    Hit hit;
    double point[3], parameters[3];
    int part;
    if (!this->Locator->IntersectWithLine(
          origin, end, Tolerance, hit.Share, point, parameters, part, hit.Triangle, cell))
    {
      return {};
    }
    return this->IsInFront(hit, origin) ? hit : this->FindNearestInFront(origin, end, cell);
  }

  /// Finds all triangles along the line, which takes longer.
  Hit FindNearestInFront(const double origin[3], const double end[3], vtkGenericCell* cell) const
  {
    vtkNew<vtkIdList> triangles;
    this->Locator->IntersectWithLine(origin, end, Tolerance, nullptr, triangles, cell);
    Hit nearest;
    for (vtkIdType triangle : *triangles)
    {
      Hit hit;
      hit.Triangle = triangle;
      double point[3], parameters[3];
      int part;
      this->Surface->GetCell(triangle, cell);
      if (cell->IntersectWithLine(origin, end, Tolerance, hit.Share, point, parameters, part) &&
        hit.Share < nearest.Share && this->IsInFront(hit, origin))
      {
        nearest = hit;
      }
    }
    return nearest;
  }

  /// Returns a length beyond which beams meet nothing.
  double GetMaximumLength(const double origin[3]) const
  {
    double farthest[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      farthest[axis] = std::max(std::abs(this->Bounds[2 * axis] - origin[axis]),
        std::abs(this->Bounds[2 * axis + 1] - origin[axis]));
    }
    return 1.01 * vtkMath::Norm(farthest);
  }

  vtkNew<vtkPolyData> Surface;
  vtkNew<vtkStaticCellLocator> Locator;
  double Bounds[6];
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dNewStaticCellLocatorCaster(
  lms3dTriangleMesh mesh, const lms3dProgress&)
{
  return std::make_unique<StaticCellLocatorCaster>(std::move(mesh));
}
