// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dFusionInputs.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkDataArray.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkFieldData.h>
#include <vtkInformationVector.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{
// FNV-1a (Fowler, Noll and Vo 1991) of 8 bytes at a time.
std::uint64_t Mix(std::uint64_t hash, std::uint64_t value)
{
  constexpr std::uint64_t Prime = 0x100000001b3;
  hash = (hash ^ value) * Prime;
  return hash ^ (hash >> 29);
}

std::uint64_t MixArray(std::uint64_t hash, vtkDataArray* array)
{
  hash = Mix(hash, array ? static_cast<std::uint64_t>(array->GetNumberOfValues()) : 0);
  const vtkIdType components = array ? array->GetNumberOfComponents() : 0;
  for (vtkIdType i = 0; components > 0 && i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = Mix(hash, bits);
  }
  return hash;
}

std::uint64_t GetKey(const lms3dFusionInput& input)
{
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char* name : { "SensorToWorld", "AlphaAngles", "BetaAngles" })
  {
    hash = MixArray(hash, input.Scan->GetFieldData()->GetArray(name));
  }
  for (const char* name : { "Range", "BeamId" })
  {
    hash = MixArray(hash, input.Scan->GetPointData()->GetArray(name));
  }
  return hash;
}
} // namespace

std::vector<lms3dFusionInput> lms3dGetFusionInputs(vtkInformationVector** inputVector)
{
  const int maps = inputVector[0]->GetNumberOfInformationObjects();
  const int scans = inputVector[1]->GetNumberOfInformationObjects();
  if (maps != scans)
  {
    throw std::runtime_error("There are " + std::to_string(maps) + " local maps and " +
      std::to_string(scans) +
      " scans. Connect the scan of each local map to the second input, in the same order.");
  }
  std::vector<lms3dFusionInput> inputs;
  inputs.reserve(maps);
  for (int i = 0; i < maps; ++i)
  {
    inputs.push_back(
      { vtkPolyData::GetData(inputVector[0], i), vtkPolyData::GetData(inputVector[1], i) });
  }
  return inputs;
}

bool lms3dFusionInputs::BeginNewMap(
  vtkAlgorithm* filter, const std::vector<lms3dFusionInput>& inputs)
{
  std::vector<vtkMTimeType> times;
  for (int port = 0; port < 2; ++port)
  {
    for (std::size_t i = 0; i < inputs.size(); ++i)
    {
      vtkAlgorithmOutput* const output = filter->GetInputConnection(port, static_cast<int>(i));
      auto* const executive =
        vtkDemandDrivenPipeline::SafeDownCast(output->GetProducer()->GetExecutive());
      times.push_back(executive ? executive->GetPipelineMTime() : 0);
    }
  }
  const bool isNew = times != this->UpstreamTimes && !this->Known.empty();
  this->UpstreamTimes = std::move(times);
  return isNew;
}

bool lms3dFusionInputs::Has(const lms3dFusionInput& input) const
{
  return this->Known.count(GetKey(input)) > 0;
}

void lms3dFusionInputs::Remember(const lms3dFusionInput& input)
{
  this->Known.insert(GetKey(input));
}

void lms3dFusionInputs::Clear()
{
  this->Known.clear();
  this->UpstreamTimes.clear();
}
