// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeErrors/RangeErrorFixtures.h"

#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{
std::vector<double> ToVector(vtkDataArray* array)
{
  std::vector<double> values(array ? array->GetNumberOfTuples() : 0);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  }
  return values;
}
} // namespace

RangeErrorPipeline::RangeErrorPipeline(vtkDataObject* scene)
  : Scan(MakeScan(scene))
{
  this->Errors->SetInputConnection(this->Scan->GetOutputPort());
}

void RangeErrorPipeline::Run()
{
  EXPECT_EQ(UpdateAndGetError(this->Errors), "");
}

std::vector<double> RangeErrorPipeline::GetErrors()
{
  this->Run();
  std::vector<double> errors = GetRanges(this->Errors->GetOutput());
  const std::vector<double> truth = GetRanges(this->Scan->GetOutput());
  EXPECT_EQ(errors.size(), truth.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    errors[i] -= truth[i];
  }
  return errors;
}

vtkSmartPointer<vtkPolyData> MakeOpenScene()
{
  return Join(MakeFloor(3.0, -1.5), MakeFloor(2.0, 2.5));
}

vtkSmartPointer<vtkPolyData> CopyData(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

std::vector<double> GetRanges(vtkPolyData* scan)
{
  return ToVector(scan->GetPointData()->GetArray("Range"));
}

std::vector<double> GetRanges(vtkImageData* image)
{
  return ToVector(image->GetPointData()->GetArray("Range"));
}

void AddAllErrors(vtkLMS3DRangeErrorFilter* filter)
{
  filter->SetRangeBias(0.01);
  filter->SetRangeNoise(0.005);
  filter->SetRangeResolution(0.001);
}

void ExpectImageOfScan(vtkImageData* image, vtkPolyData* scan)
{
  const std::vector<double> grid = GetRanges(image);
  const std::vector<double> ranges = GetRanges(scan);
  std::vector<double> expected(grid.size(), NAN);
  vtkDataArray* ids = scan->GetPointData()->GetArray("BeamId");
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    expected[static_cast<std::size_t>(ids->GetTuple1(static_cast<vtkIdType>(i)))] = ranges[i];
  }
  for (std::size_t beam = 0; beam < grid.size(); ++beam)
  {
    ASSERT_TRUE(
      grid[beam] == expected[beam] || (std::isnan(grid[beam]) && std::isnan(expected[beam])))
      << beam;
  }
}

void ExpectEmpty(vtkLMS3DRangeErrorFilter* filter)
{
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(filter->GetRangeImage()->GetNumberOfPoints(), 0);
}

Moments::Moments(const std::vector<double>& values)
  : Count(static_cast<double>(values.size()))
  , Mean(std::accumulate(values.begin(), values.end(), 0.0) / Count)
{
  double sums[3] = { 0.0, 0.0, 0.0 };
  for (double value : values)
  {
    const double d = value - this->Mean;
    sums[0] += d * d;
    sums[1] += d * d * d;
    sums[2] += d * d * d * d;
  }
  this->Variance = sums[0] / this->Count;
  this->Skewness = sums[1] / this->Count / std::pow(this->Variance, 1.5);
  this->Kurtosis = sums[2] / this->Count / (this->Variance * this->Variance);
}

double GetCorrelation(const std::vector<double>& values, std::size_t lag)
{
  return GetCorrelation(
    { values.begin(), values.end() - lag }, { values.begin() + lag, values.end() });
}

double GetCorrelation(const std::vector<double>& one, const std::vector<double>& other)
{
  const Moments first(one);
  const Moments second(other);
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    sum += (one[i] - first.Mean) * (other[i] - second.Mean);
  }
  return sum / first.Count / std::sqrt(first.Variance * second.Variance);
}
