// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dScanFieldData.h"

#include "Pipeline/lms3dArray.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
void AddDoubles(vtkFieldData* fieldData, const char* name, const double* values, vtkIdType count)
{
  const auto array = lms3dMakeArray<vtkDoubleArray>(name, static_cast<std::size_t>(count));
  std::copy(values, values + count, array->GetPointer(0));
  lms3dAddHiddenArray(array, fieldData);
}

std::vector<double> GetFiniteNumbers(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return {};
  }
  std::vector<double> numbers(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  }
  const bool areFinite =
    std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  return areFinite ? numbers : std::vector<double>();
}

// Returns `standard` if there is no such array.
std::vector<double> GetNumbers(
  vtkFieldData* data, const char* name, const std::vector<double>& standard)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array)
  {
    return standard;
  }
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    const int components = array->GetNumberOfComponents();
    numbers.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
  }
  const bool areFinite =
    std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  if (!areFinite || numbers.size() != standard.size())
  {
    throw std::runtime_error("The scan's field data " + std::string(name) + " is not " +
      std::to_string(standard.size()) +
      " finite numbers. Connect the first output of vtkLMS3DScanFilter.");
  }
  return numbers;
}

void AddPlatform(const lms3dPlatform& platform, vtkFieldData* fieldData)
{
  const lms3dPlatform standard;
  if (platform.Mounting != standard.Mounting)
  {
    const double mounting = static_cast<double>(platform.Mounting);
    AddDoubles(fieldData, "Mounting", &mounting, 1);
  }
  if (platform.AxisOffset != standard.AxisOffset)
  {
    AddDoubles(fieldData, "AxisOffset", platform.AxisOffset.data(), 3);
  }
  if (platform.TurnRate != standard.TurnRate)
  {
    AddDoubles(fieldData, "TurnRate", &platform.TurnRate, 1);
  }
}
} // namespace

lms3dPlatform lms3dGetPlatform(vtkFieldData* data)
{
  const double mounting = GetNumbers(data, "Mounting", { 0.0 })[0];
  if (mounting < 0.0 || mounting > 3.0 || mounting != std::floor(mounting))
  {
    throw std::runtime_error("The scan's field data Mounting is " + std::to_string(mounting) +
      "; 0, 1, 2 or 3 is expected (vtkLMS3DScanFilter::Mountings).");
  }
  const std::vector<double> offset = GetNumbers(data, "AxisOffset", { 0.0, 0.0, 0.0 });
  return { static_cast<lms3dMounting>(static_cast<int>(mounting)),
    { offset[0], offset[1], offset[2] }, GetNumbers(data, "TurnRate", { 0.0 })[0] };
}

lms3dGridAngles lms3dGetGridAngles(vtkFieldData* data)
{
  lms3dGridAngles angles = { GetFiniteNumbers(data, "AlphaAngles"),
    GetFiniteNumbers(data, "BetaAngles"), {} };
  const bool hasGrid = !angles.Alpha.empty() && !angles.Beta.empty() &&
    angles.Alpha.size() <= std::numeric_limits<int>::max() / angles.Beta.size();
  try
  {
    angles.Platform = lms3dGetPlatform(data);
  }
  catch (const std::runtime_error&)
  {
    return {};
  }
  return hasGrid ? angles : lms3dGridAngles();
}

std::array<double, 16> lms3dToMatrix(const lms3dPose& pose)
{
  std::array<double, 16> matrix{};
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = pose.Axes[column][row];
    }
    matrix[4 * row + 3] = pose.Position[row];
  }
  matrix[15] = 1.0;
  return matrix;
}

void lms3dAddFieldData(const lms3dScanGeometry& geometry, const lms3dPose& pose, vtkPolyData* scan)
{
  const std::vector<double>& alpha = geometry.GetAlphaAngles();
  const std::vector<double>& beta = geometry.GetBetaAngles();
  const std::array<double, 16> matrix = lms3dToMatrix(pose);
  vtkFieldData* fieldData = scan->GetFieldData();
  AddDoubles(fieldData, "AlphaAngles", alpha.data(), static_cast<vtkIdType>(alpha.size()));
  AddDoubles(fieldData, "BetaAngles", beta.data(), static_cast<vtkIdType>(beta.size()));
  AddDoubles(fieldData, "SensorToWorld", matrix.data(), static_cast<vtkIdType>(matrix.size()));
  AddPlatform(geometry.GetPlatform(), fieldData);
}
