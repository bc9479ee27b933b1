// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLMS3DMapFusion.h"

#include "Fusion/lms3dFusionInputs.h"
#include "Fusion/lms3dFusionOutput.h"
#include "Fusion/lms3dMapFusion.h"
#include "Pipeline/lms3dAlgorithmProgress.h"
#include "Pipeline/lms3dErrorReport.h"
#include "Pipeline/lms3dFailure.h"
#include "Pipeline/lms3dPipelineRequests.h"
#include "Pipeline/lms3dThreads.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkLMS3DMapFusion);

namespace
{
constexpr const char* WithoutMemory =
  "There is not enough memory for the map. Turn KeepReturns off, or choose a larger MaximumError.";
}

struct vtkLMS3DMapFusion::Internals
{
  /// The map, new if there is none or if a property has changed.
  lms3dMapFusion& GetMap(const vtkLMS3DMapFusion* filter);
  void Reset();
  /// Adds the scans of the connections that the map does not have. Returns false if the work was
  /// stopped.
  bool AddInputs(vtkLMS3DMapFusion* filter, vtkInformationVector** inputVector);
  void Add(vtkLMS3DMapFusion* filter, const lms3dFusionInput& input, bool& isStopped);

  lms3dThreads Threads;
  lms3dErrorReport Errors;
  lms3dFusionInputs Inputs;
  std::unique_ptr<lms3dMapFusion> Map;
  /// The numbers of the maps before this one.
  int EndOfRegions = 0;
  int Revision = 0;
};

lms3dMapFusion& vtkLMS3DMapFusion::Internals::GetMap(const vtkLMS3DMapFusion* filter)
{
  const lms3dFusionSettings settings = { filter->MaximumError, filter->KeepReturns,
    filter->ForgetSeenThrough };
  if (!(settings.MaximumError > 0.0) || !std::isfinite(settings.MaximumError))
  {
    throw std::runtime_error("MaximumError is " + std::to_string(settings.MaximumError) +
      "; a finite number of metres above 0 is expected.");
  }
  if (this->Map && !(this->Map->GetSettings() == settings))
  {
    this->Reset();
  }
  if (!this->Map)
  {
    this->Map = std::make_unique<lms3dMapFusion>(settings, this->EndOfRegions, this->Revision);
  }
  return *this->Map;
}

void vtkLMS3DMapFusion::Internals::Reset()
{
  if (this->Map)
  {
    this->EndOfRegions = this->Map->GetEndOfRegions();
    this->Revision = this->Map->GetRevision() + 1;
    this->Map.reset();
  }
  this->Inputs.Clear();
}

void vtkLMS3DMapFusion::Internals::Add(
  vtkLMS3DMapFusion* filter, const lms3dFusionInput& input, bool& isStopped)
{
  lms3dMapFusion& map = this->GetMap(filter);
  map.Check(input.Map, input.Scan);
  this->Threads.Run(filter->NumberOfThreads,
    [&] { isStopped = !map.Add(input.Map, input.Scan, lms3dReportTo(filter, 0.0, 1.0)); });
}

bool vtkLMS3DMapFusion::Internals::AddInputs(
  vtkLMS3DMapFusion* filter, vtkInformationVector** inputVector)
{
  const std::vector<lms3dFusionInput> inputs = lms3dGetFusionInputs(inputVector);
  if (inputs.empty())
  {
    this->GetMap(filter);
    return true;
  }
  if (this->Inputs.BeginNewMap(filter, inputs))
  {
    this->Reset();
    this->Inputs.BeginNewMap(filter, inputs);
  }
  this->GetMap(filter);
  bool isStopped = false;
  for (const lms3dFusionInput& input : inputs)
  {
    if (!isStopped && !this->Inputs.Has(input))
    {
      this->Add(filter, input, isStopped);
      this->Inputs.Remember(input);
    }
  }
  return !isStopped;
}

vtkLMS3DMapFusion::vtkLMS3DMapFusion()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(2);
}

vtkLMS3DMapFusion::~vtkLMS3DMapFusion() = default;

int vtkLMS3DMapFusion::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkLMS3DMapFusion::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      lms3dRequestPiece(0, 1, inputVector[port]->GetInformationObject(i));
    }
  }
  return 1;
}

int vtkLMS3DMapFusion::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Without SetErrorCode(), which modifies the filter, so that every update would run it again.
  this->ErrorCode = vtkErrorCode::NoError;
  if (!lms3dIsFirstPiece(lms3dGetRequestedOutput(request, outputVector)))
  {
    return 1;
  }
  bool isDone = true;
  const std::string failure = lms3dRunAndGetError(
    [&]
    {
      isDone = this->Internal->AddInputs(this, inputVector);
      if (isDone && this->Internal->Map)
      {
        this->Internal->Map->Fill(-1, vtkPolyData::GetData(outputVector));
      }
    },
    WithoutMemory);
  if (!failure.empty())
  {
    this->ErrorCode = vtkErrorCode::UserError;
    this->Internal->Reset();
    return this->Internal->Errors.Report(this, failure, outputVector);
  }
  if (!isDone)
  {
    this->Internal->Reset();
    lms3dClearOutputs(outputVector);
  }
  return 1;
}

bool vtkLMS3DMapFusion::AddScan(vtkPolyData* map, vtkPolyData* scan)
{
  bool isStopped = false;
  const std::string failure = lms3dRunAndGetError(
    [&]
    {
      if (this->GetNumberOfInputConnections(0) + this->GetNumberOfInputConnections(1) > 0)
      {
        throw std::runtime_error("AddScan needs a filter without connections. Either connect the "
                                 "maps and scans, or add them one by one.");
      }
      if (!map || !scan)
      {
        throw std::runtime_error("AddScan needs a local map and the scan from which it was made.");
      }
      this->Internal->Add(this, { map, scan }, isStopped);
    },
    WithoutMemory);
  this->ErrorCode = failure.empty() ? vtkErrorCode::NoError : vtkErrorCode::UserError;
  if (!failure.empty())
  {
    vtkErrorMacro(<< failure);
    return false;
  }
  if (isStopped)
  {
    this->Internal->Reset();
  }
  this->Modified();
  return !isStopped;
}

void vtkLMS3DMapFusion::Reset()
{
  this->Internal->Reset();
  this->Modified();
}

int vtkLMS3DMapFusion::GetNumberOfScans() const
{
  return this->Internal->Map ? this->Internal->Map->GetNumberOfScans() : 0;
}

int vtkLMS3DMapFusion::GetRevision() const
{
  return this->Internal->Map ? this->Internal->Map->GetRevision() : this->Internal->Revision;
}

void vtkLMS3DMapFusion::GetChanges(int sinceRevision, vtkPolyData* delta)
{
  if (!delta)
  {
    vtkErrorMacro("GetChanges needs a vtkPolyData for the changes.");
    return;
  }
  delta->Initialize();
  const lms3dMapFusion* map = this->Internal->Map.get();
  std::vector<int> changed;
  if (sinceRevision < this->Internal->Revision)
  {
    changed.resize(static_cast<std::size_t>(this->Internal->EndOfRegions));
    std::iota(changed.begin(), changed.end(), 0);
  }
  if (map)
  {
    map->Fill(sinceRevision, delta);
    const std::vector<int> regions = map->GetChangedRegions(sinceRevision);
    changed.insert(changed.end(), regions.begin(), regions.end());
  }
  lms3dAddFusionField("ChangedRegions", changed, delta);
}

void vtkLMS3DMapFusion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumError: " << this->MaximumError << '\n';
  os << indent << "KeepReturns: " << this->KeepReturns << '\n';
  os << indent << "ForgetSeenThrough: " << this->ForgetSeenThrough << '\n';
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << '\n';
  os << indent << "NumberOfScans: " << this->GetNumberOfScans() << '\n';
  os << indent << "Revision: " << this->GetRevision() << '\n';
}
