// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dScanInput.h"

#include "Device/lms3dScanFieldData.h"
#include "Geometry/lms3dVector.h"
#include "Geometry/lms3dWideLoops.h"

#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
// The smallest part of the loop over coordinates that a thread takes.
constexpr vtkIdType MinimumGrainSize = 16384;

[[noreturn]] void Fail(const std::string& what)
{
  throw std::runtime_error(what + " Connect the first output of vtkLMS3DScanFilter.");
}

// Returns the array itself if it has the type, or a converted copy if another filter changed the
// type.
template <typename ArrayT>
vtkSmartPointer<ArrayT> As(vtkDataArray* array)
{
  if (ArrayT* typed = ArrayT::FastDownCast(array))
  {
    return typed;
  }
  auto copy = vtkSmartPointer<ArrayT>::New();
  copy->DeepCopy(array);
  return copy;
}

template <typename ArrayT>
vtkSmartPointer<ArrayT> Take(vtkFieldData* data, const char* name, vtkIdType count)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count)
  {
    Fail(
      "The scan has no array " + std::string(name) + " of " + std::to_string(count) + " numbers.");
  }
  return As<ArrayT>(array);
}

// Counts, because compilers vectorize a loop that does not stop early.
LMS3D_WIDE_LOOPS
bool AreFinite(const double* first, const double* last)
{
  std::int64_t infinite = 0;
  for (; first != last; ++first)
  {
    infinite += std::abs(*first) <= std::numeric_limits<double>::max() ? 0 : 1;
  }
  return infinite == 0;
}

void CheckFinite(vtkDoubleArray* array, const std::string& name)
{
  const double* first = array->GetPointer(0);
  if (!AreFinite(first, first + array->GetNumberOfValues()))
  {
    Fail("The scan's field data " + name + " is not finite.");
  }
}

vtkSmartPointer<vtkDoubleArray> TakeAngles(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() == 0)
  {
    Fail("The scan has no field data " + std::string(name) + ".");
  }
  vtkSmartPointer<vtkDoubleArray> angles = As<vtkDoubleArray>(array);
  CheckFinite(angles, name);
  return angles;
}

std::vector<double> ToVector(vtkDoubleArray* array)
{
  const double* first = array->GetPointer(0);
  return { first, first + array->GetNumberOfValues() };
}

bool AreEqual(vtkDoubleArray* array, const std::vector<double>& values)
{
  const double* first = array->GetPointer(0);
  return std::equal(first, first + array->GetNumberOfValues(), values.begin(), values.end());
}
} // namespace

void lms3dThrowBadReturn(std::int64_t index, double range, int beamId, std::int64_t beams)
{
  const std::string beginning = "Return " + std::to_string(index) + " of the scan has the ";
  if (beamId < 0 || beamId >= beams)
  {
    throw std::runtime_error(beginning + "BeamId " + std::to_string(beamId) + "; 0 to " +
      std::to_string(beams - 1) + " are expected from AlphaAngles and BetaAngles.");
  }
  if (!(range > 0.0 && range <= std::numeric_limits<double>::max()))
  {
    throw std::runtime_error(beginning + "Range " + std::to_string(range) +
      "; a finite number of metres above 0 is expected. Remove beams that gave no return.");
  }
  throw std::runtime_error(beginning + "BeamId " + std::to_string(beamId) +
    " of an earlier return; at most one return for each beam is expected.");
}

std::array<double, 3> lms3dFindSensorPosition(vtkPolyData* scan)
{
  vtkDataArray* matrix = scan->GetFieldData()->GetArray("SensorToWorld");
  if (!matrix || matrix->GetNumberOfComponents() != 1 || matrix->GetNumberOfTuples() != 16)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const std::array<double, 3> position = { matrix->GetTuple1(3), matrix->GetTuple1(7),
    matrix->GetTuple1(11) };
  return lms3dIsFinite(position) ? position : std::array<double, 3>{ 0.0, 0.0, 0.0 };
}

lms3dScanInput::lms3dScanInput(vtkPolyData* scan)
{
  const vtkIdType count = scan->GetNumberOfPoints();
  if (count == 0)
  {
    return; // A scan that was stopped has no arrays.
  }
  this->Ranges = Take<vtkDoubleArray>(scan->GetPointData(), "Range", count);
  this->BeamIds = Take<vtkIntArray>(scan->GetPointData(), "BeamId", count);
  this->AlphaAngles = TakeAngles(scan->GetFieldData(), "AlphaAngles");
  this->BetaAngles = TakeAngles(scan->GetFieldData(), "BetaAngles");
  this->SensorToWorld = Take<vtkDoubleArray>(scan->GetFieldData(), "SensorToWorld", 16);
  CheckFinite(this->SensorToWorld, "SensorToWorld");
  this->Platform = lms3dGetPlatform(scan->GetFieldData());
  this->Points = As<vtkDoubleArray>(scan->GetPoints()->GetData());
  const std::int64_t beams = static_cast<std::int64_t>(this->AlphaAngles->GetNumberOfValues()) *
    this->BetaAngles->GetNumberOfValues();
  if (beams > std::numeric_limits<std::int32_t>::max())
  {
    Fail("The scan's AlphaAngles x BetaAngles are " + std::to_string(beams) + " beams.");
  }
}

void lms3dScanInput::CheckPoints() const
{
  const double* first = this->GetPoints();
  std::atomic<bool> areFinite{ true };
  const vtkIdType count = 3 * this->GetNumberOfReturns();
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, MinimumGrainSize),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      if (!AreFinite(first + range.begin(), first + range.end()))
      {
        areFinite = false;
      }
    });
  if (!areFinite)
  {
    const double* bad =
      std::find_if(first, first + count, [](double x) { return !std::isfinite(x); });
    throw std::runtime_error("Return " + std::to_string((bad - first) / 3) +
      " of the scan has the coordinate " + std::to_string(*bad) + ". Coordinates must be finite.");
  }
}

lms3dScanGeometry lms3dScanInput::GetGeometry() const
{
  return { ToVector(this->AlphaAngles), ToVector(this->BetaAngles), this->Platform };
}

lms3dPose lms3dScanInput::GetPose() const
{
  const double* matrix = this->GetSensorToWorld();
  lms3dPose pose;
  pose.Position = this->GetSensorPosition();
  for (int axis = 0; axis < 3; ++axis)
  {
    pose.Axes[axis] = { matrix[axis], matrix[4 + axis], matrix[8 + axis] };
  }
  return pose;
}

bool lms3dScanInput::HasAngles(const lms3dScanGeometry& geometry) const
{
  return AreEqual(this->AlphaAngles, geometry.GetAlphaAngles()) &&
    AreEqual(this->BetaAngles, geometry.GetBetaAngles()) &&
    this->Platform == geometry.GetPlatform();
}

std::array<double, 3> lms3dScanInput::GetSensorPosition() const
{
  const double* matrix = this->SensorToWorld->GetPointer(0);
  return { matrix[3], matrix[7], matrix[11] };
}
