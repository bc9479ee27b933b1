// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/lms3dErrorReport.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>

namespace
{
// The time of the last change of the filter or of anything upstream.
vtkMTimeType GetPipelineTime(vtkAlgorithm* filter)
{
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(filter->GetExecutive());
  return pipeline ? pipeline->GetPipelineMTime() : filter->GetMTime();
}
} // namespace

int lms3dErrorReport::Report(
  vtkAlgorithm* filter, const std::string& error, vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputVector->GetInformationObject(port)->Get(vtkDataObject::DATA_OBJECT())->Initialize();
  }
  const vtkMTimeType time = GetPipelineTime(filter);
  if (error != this->Error || time != this->PipelineTime)
  {
    this->Error = error;
    this->PipelineTime = time;
    vtkErrorWithObjectMacro(filter, << error);
  }
  return 1;
}
