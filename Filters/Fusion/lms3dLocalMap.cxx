// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dLocalMap.h"

#include "Casting/lms3dRayCaster.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace
{
// The packets of a task.
constexpr std::size_t GrainSize = 64;

lms3dTriangleMesh ReadMesh(vtkPolyData* map)
{
  lms3dTriangleMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(map->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    map->GetPoint(i, mesh.Points[i].data());
  }
  const auto cells = vtk::TakeSmartPointer(map->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    mesh.Triangles.push_back({ static_cast<std::uint32_t>(ids[0]),
      static_cast<std::uint32_t>(ids[1]), static_cast<std::uint32_t>(ids[2]) });
  }
  return mesh;
}

/// Casts the beams of the returns from `first` on, at most 16.
void CastPacket(const lms3dRayCaster& caster, lms3dMappedReturn* returns, std::size_t count,
  const lms3dSeenRanges& ranges, double maximumError)
{
  lms3dFreePacket packet;
  packet.Active = 0;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    const lms3dMappedReturn& mapped = returns[std::min<std::size_t>(i, count - 1)];
    const lms3dVector start = ranges.GetStart(mapped.BeamId);
    for (int axis = 0; axis < 3; ++axis)
    {
      packet.Origin[axis][i] = start[axis];
      packet.Direction[axis][i] = mapped.Direction[axis];
    }
    packet.Active |= static_cast<std::size_t>(i) < count ? 1U << i : 0U;
  }
  caster.CastFree(std::numeric_limits<double>::infinity(), &packet, 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isHit = packet.Triangle[i] != lms3dBeamPacket::NoTriangle &&
      std::abs(packet.Range[i] - returns[i].Range) <= maximumError;
    returns[i].Triangle = isHit ? packet.Triangle[i] : -1;
  }
}
} // namespace

lms3dLocalMap::lms3dLocalMap(
  vtkPolyData* map, const lms3dScanInput& scan, const lms3dSeenRanges& ranges, double maximumError)
  : Mesh(ReadMesh(map))
{
  vtkDataArray* const patches = map->GetCellData()->GetArray("PatchId");
  for (std::size_t i = 0; i < this->Mesh.GetNumberOfTriangles(); ++i)
  {
    this->PatchIds.push_back(static_cast<int>(patches->GetTuple1(static_cast<vtkIdType>(i))));
    this->NumberOfPatches = std::max(this->NumberOfPatches, this->PatchIds.back() + 1);
  }
  const auto count = static_cast<std::size_t>(scan.GetNumberOfReturns());
  this->Returns.resize(count);
  const std::unique_ptr<lms3dRayCaster> caster =
    lms3dRayCaster::New(lms3dRayCaster::EXACT, this->Mesh);
  constexpr std::size_t Size = lms3dBeamPacket::Size;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, (count + Size - 1) / Size, GrainSize),
    [&](const tbb::blocked_range<std::size_t>& packets)
    {
      for (std::size_t packet = packets.begin(); packet != packets.end(); ++packet)
      {
        const std::size_t first = packet * Size;
        const std::size_t end = std::min(first + Size, count);
        for (std::size_t i = first; i < end; ++i)
        {
          const int id = scan.GetBeamIds()[i];
          const double range = scan.GetRanges()[i];
          const lms3dVector direction = ranges.GetDirection(id);
          this->Returns[i] = { lms3dAdd(ranges.GetStart(id), lms3dScale(direction, range)),
            direction, range, id, -1 };
        }
        CastPacket(*caster, &this->Returns[first], end - first, ranges, maximumError);
      }
    });
  this->Returns.erase(std::remove_if(this->Returns.begin(), this->Returns.end(),
                        [](const lms3dMappedReturn& mapped) { return mapped.Triangle < 0; }),
    this->Returns.end());
}
