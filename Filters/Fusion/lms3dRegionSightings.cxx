// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dRegionSightings.h"

namespace
{
/// The sightings of the block around a point, or of the nearest block if no return lies in this one.
lms3dSightings GetSightings(const lms3dRaster& raster, const lms3dPoint2& point)
{
  const int number = raster.Find(lms3dRaster::GetBlockOf(static_cast<std::int32_t>(point[0])),
    lms3dRaster::GetBlockOf(static_cast<std::int32_t>(point[1])));
  if (number >= 0 && raster.GetBlock(number).Sightings.ScanCount > 0)
  {
    return raster.GetBlock(number).Sightings;
  }
  const double u = point[0] / lms3dRaster::Size - 0.5;
  const double v = point[1] / lms3dRaster::Size - 0.5;
  const lms3dRasterBlock* best = nullptr;
  double least = 0.0;
  for (int i = 0; i < raster.GetNumberOfBlocks(); ++i)
  {
    const lms3dRasterBlock& block = raster.GetBlock(i);
    const double distance = (block.U - u) * (block.U - u) + (block.V - v) * (block.V - v);
    if (block.Sightings.ScanCount > 0 && (!best || distance < least))
    {
      best = &block;
      least = distance;
    }
  }
  return best ? best->Sightings : lms3dSightings();
}
} // namespace

void lms3dSetSightings(lms3dFusedPlane& plane)
{
  lms3dFusedMesh& mesh = plane.Mesh;
  mesh.Sightings.clear();
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    const lms3dVector centre =
      lms3dScale(lms3dAdd(mesh.Points[a], lms3dAdd(mesh.Points[b], mesh.Points[c])), 1.0 / 3.0);
    mesh.Sightings.push_back(GetSightings(plane.Raster, plane.Frame.ToCells(centre)));
  }
}
