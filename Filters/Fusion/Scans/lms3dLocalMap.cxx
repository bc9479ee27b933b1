// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Scans/lms3dLocalMap.h"

#include "Casting/lms3dRayCaster.h"
#include "Fusion/Scans/lms3dNearestCorner.h"
#include "Scan/lms3dScanner.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace
{
constexpr std::size_t BeamsOfTask = 4096;
// Smaller components of directions are 0 in single precision.
constexpr double SmallestComponent = 1e-15;

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

/// Fills a packet with the directions of returns, at most 16.
void Fill(const lms3dMappedReturn* returns, std::size_t count, lms3dBeamPacket& packet)
{
  packet.Active = 0;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    const lms3dMappedReturn& mapped = returns[std::min<std::size_t>(i, count - 1)];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double component = mapped.Direction[axis];
      packet.Direction[axis][i] = component;
      packet.NarrowDirection[axis][i] =
        std::abs(component) < SmallestComponent ? 0.0F : static_cast<float>(component);
    }
    packet.Active |= static_cast<std::size_t>(i) < count ? 1U << i : 0U;
  }
}

void SetTriangles(
  const lms3dBeamPacket& packet, std::size_t count, double maximumError, lms3dMappedReturn* returns)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isHit = packet.Triangle[i] != lms3dBeamPacket::NoTriangle &&
      std::abs(packet.Range[i] - returns[i].Range) <= maximumError;
    returns[i].Triangle = isHit ? packet.Triangle[i] : -1;
  }
}

/// Casts beams that start at points of their own.
void CastFree(const lms3dRayCaster& caster, const lms3dSeenRanges& ranges, double maximumError,
  lms3dMappedReturn* returns, std::size_t count)
{
  constexpr std::size_t Size = lms3dBeamPacket::Size;
  for (std::size_t first = 0; first < count; first += Size)
  {
    const std::size_t end = std::min(first + Size, count);
    lms3dFreePacket packet;
    Fill(returns + first, end - first, packet);
    for (std::size_t i = 0; i < Size; ++i)
    {
      const lms3dVector start = ranges.GetStart(returns[std::min(first + i, end - 1)].BeamId);
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.Origin[axis][i] = start[axis];
      }
    }
    caster.CastFree(std::numeric_limits<double>::infinity(), &packet, 1);
    SetTriangles(packet, end - first, maximumError, returns + first);
  }
}

/// Casts beams that start at the sensor's position as a scan does, which decides most of them many
/// at a time.
class CentredHits
{
public:
  CentredHits(const lms3dRayCaster& caster, const lms3dSeenRanges& ranges)
    : Ranges(static_cast<std::size_t>(ranges.GetTable().GetSize()))
    , Triangles(Ranges.size())
  {
    lms3dScan({ caster, ranges.GetTable().GetGeometry(), ranges.GetPose(),
                { 0.0, std::numeric_limits<double>::infinity() },
                { this->Ranges.data(), this->Triangles.data() } },
      [](double) { return true; });
  }

  void SetTriangles(double maximumError, lms3dMappedReturn* returns, std::size_t count) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const int id = returns[i].BeamId;
      const bool isHit = std::abs(this->Ranges[id] - returns[i].Range) <= maximumError;
      returns[i].Triangle = isHit ? this->Triangles[id] : -1;
    }
  }

private:
  /// NaN for a beam that hits nothing.
  std::vector<double> Ranges;
  std::vector<std::int32_t> Triangles;
};

/// Casts a beam again from shortly before its return, since others can be nearer to the sensor in
/// the same direction: all turns have a beam along the platform's axis.
void CastAtReturn(const lms3dRayCaster& caster, double maximumError, lms3dMappedReturn& mapped)
{
  lms3dFreePacket packet;
  Fill(&mapped, 1, packet);
  const lms3dVector start = lms3dSubtract(mapped.Point, lms3dScale(mapped.Direction, maximumError));
  for (int axis = 0; axis < 3; ++axis)
  {
    std::fill_n(packet.Origin[axis], lms3dBeamPacket::Size, start[axis]);
  }
  caster.CastFree(2.0 * maximumError, &packet, 1);
  mapped.Triangle = packet.Triangle[0];
}

std::vector<std::size_t> FindMissed(const std::vector<lms3dMappedReturn>& returns)
{
  std::vector<std::size_t> missed;
  for (std::size_t i = 0; i < returns.size(); ++i)
  {
    if (returns[i].Triangle < 0)
    {
      missed.push_back(i);
    }
  }
  return missed;
}

/// Finds triangles for returns whose beam has hit none within the bound.
void FindTrianglesOfMissed(const lms3dRayCaster& caster, const lms3dTriangleMesh& mesh,
  double maximumError, std::vector<lms3dMappedReturn>& returns)
{
  std::vector<std::size_t> missed = FindMissed(returns);
  tbb::parallel_for(std::size_t{ 0 }, missed.size(),
    [&](std::size_t i) { CastAtReturn(caster, maximumError, returns[missed[i]]); });
  missed = FindMissed(returns);
  if (missed.empty())
  {
    return;
  }
  const lms3dNearestCorner corners(mesh);
  tbb::parallel_for(std::size_t{ 0 }, missed.size(),
    [&](std::size_t i)
    {
      lms3dMappedReturn& mapped = returns[missed[i]];
      mapped.Triangle = corners.FindTriangle(mapped.Point, maximumError);
    });
}
} // namespace

lms3dLocalMap::lms3dLocalMap(vtkPolyData* map, const lms3dScanInput& scan,
  const lms3dSeenRanges& ranges, double maximumError, std::vector<lms3dMappedReturn> others)
  : Mesh(ReadMesh(map))
  , Returns(std::move(others))
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
  std::optional<CentredHits> hits;
  if (!ranges.GetTable().HasStarts())
  {
    hits.emplace(*caster, ranges);
  }
  tbb::parallel_for(std::size_t{ 0 }, (count + BeamsOfTask - 1) / BeamsOfTask,
    [&](std::size_t task)
    {
      const std::size_t first = task * BeamsOfTask;
      const std::size_t end = std::min(first + BeamsOfTask, count);
      const auto* const ids = scan.GetBeamIds();
      const double* const beamRanges = scan.GetRanges();
      for (std::size_t i = first; i < end; ++i)
      {
        const int id = ids[i];
        const double range = beamRanges[i];
        const lms3dVector direction = ranges.GetDirection(id);
        this->Returns[i] = { lms3dAdd(ranges.GetStart(id), lms3dScale(direction, range)), direction,
          range, id, -1 };
      }
      if (hits)
      {
        hits->SetTriangles(maximumError, &this->Returns[first], end - first);
      }
      else
      {
        CastFree(*caster, ranges, maximumError, &this->Returns[first], end - first);
      }
    });
  FindTrianglesOfMissed(*caster, this->Mesh, maximumError, this->Returns);
  this->Returns.erase(std::remove_if(this->Returns.begin(), this->Returns.end(),
                        [](const lms3dMappedReturn& mapped) { return mapped.Triangle < 0; }),
    this->Returns.end());
}

std::vector<lms3dMappedReturn> lms3dLocalMap::Select(const std::vector<int>& numbers) const
{
  std::vector<lms3dMappedReturn> returns;
  returns.reserve(numbers.size());
  for (const int i : numbers)
  {
    returns.push_back(this->Returns[i]);
  }
  return returns;
}
