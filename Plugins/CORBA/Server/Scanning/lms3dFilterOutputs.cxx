// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dFilterOutputs.h"

#include "Common/lms3dChecksum.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

static_assert(static_cast<int>(LMS3D::BEAM_RETURN) == vtkLMS3DScanFilter::RETURN &&
    static_cast<int>(LMS3D::BEAM_NOTHING_MET) == vtkLMS3DScanFilter::NOTHING_MET &&
    static_cast<int>(LMS3D::BEAM_BEYOND_RANGE) == vtkLMS3DScanFilter::BEYOND_RANGE &&
    static_cast<int>(LMS3D::BEAM_TOO_WEAK) == vtkLMS3DScanFilter::TOO_WEAK &&
    static_cast<int>(LMS3D::BEAM_TOO_NEAR) == vtkLMS3DScanFilter::TOO_NEAR,
  "the interface and the filter number the statuses alike");

namespace
{
// Neither to 0, which means no return, nor to infinity.
float ToFloat(double range)
{
  using Limits = std::numeric_limits<float>;
  return static_cast<float>(std::clamp<double>(range, Limits::min(), Limits::max()));
}

std::vector<float> GetRanges(vtkImageData* image)
{
  auto* ranges = vtkDoubleArray::SafeDownCast(image->GetPointData()->GetArray("Range"));
  const double* first = ranges->GetPointer(0);
  std::vector<float> floats(static_cast<std::size_t>(ranges->GetNumberOfValues()));
  std::transform(first, first + floats.size(), floats.begin(),
    [](double range) { return std::isnan(range) ? 0.0f : ToFloat(range); });
  return floats;
}

// A return that its errors have moved to 0 or less is too near.
std::vector<std::uint8_t> GetStatuses(vtkFieldData* data, const std::vector<float>& ranges)
{
  auto* computed = vtkUnsignedCharArray::SafeDownCast(data->GetArray("Status"));
  std::vector<std::uint8_t> statuses(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    const bool isReturn = ranges[i] > 0.0f;
    const std::uint8_t ideal = computed ? computed->GetPointer(0)[i]
      : isReturn                        ? LMS3D::BEAM_RETURN
                                        : LMS3D::BEAM_NOTHING_MET;
    statuses[i] = !isReturn && ideal == LMS3D::BEAM_RETURN ? LMS3D::BEAM_TOO_NEAR : ideal;
  }
  return statuses;
}

std::vector<double> GetCoordinates(vtkPolyData* map)
{
  if (map->GetNumberOfPoints() == 0)
  {
    return {};
  }
  auto* coordinates = vtkDoubleArray::SafeDownCast(map->GetPoints()->GetData());
  const double* first = coordinates->GetPointer(0);
  return { first, first + coordinates->GetNumberOfValues() };
}

template <typename Array>
std::vector<std::uint32_t> GetNumbers(Array* connectivity)
{
  const auto* first = connectivity->GetPointer(0);
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(connectivity->GetNumberOfValues()));
  std::transform(first, first + numbers.size(), numbers.begin(),
    [](auto number) { return static_cast<std::uint32_t>(number); });
  return numbers;
}

std::vector<std::uint32_t> GetTriangles(vtkPolyData* map)
{
  vtkCellArray* triangles = map->GetPolys();
  if (triangles->GetNumberOfCells() == 0)
  {
    return {};
  }
  return triangles->IsStorage64Bit() ? GetNumbers(triangles->GetConnectivityArray64())
                                     : GetNumbers(triangles->GetConnectivityArray32());
}
} // namespace

void lms3dTakeScan(vtkPolyData* scan, vtkImageData* image, lms3dSnapshot& snapshot)
{
  snapshot.Ranges = GetRanges(image);
  if (snapshot.Device.computeStatus)
  {
    snapshot.Statuses = GetStatuses(scan->GetFieldData(), snapshot.Ranges);
  }
  snapshot.Header.beams = static_cast<CORBA::ULong>(snapshot.Ranges.size());
  snapshot.Header.returns = static_cast<CORBA::ULong>(scan->GetNumberOfPoints());
  snapshot.Header.rangesChecksum = lms3dGetRangesChecksum(snapshot.Ranges);
  snapshot.Header.mapPoints = 0;
  snapshot.Header.mapTriangles = 0;
  snapshot.Header.mapChecksum = lms3dGetMapChecksum({}, {});
}

void lms3dTakeMap(vtkPolyData* map, lms3dSnapshot& snapshot)
{
  snapshot.MapPoints = GetCoordinates(map);
  snapshot.MapTriangles = GetTriangles(map);
  snapshot.Header.mapPoints = static_cast<CORBA::ULong>(snapshot.MapPoints.size() / 3);
  snapshot.Header.mapTriangles = static_cast<CORBA::ULong>(snapshot.MapTriangles.size() / 3);
  snapshot.Header.mapChecksum = lms3dGetMapChecksum(snapshot.MapPoints, snapshot.MapTriangles);
}
