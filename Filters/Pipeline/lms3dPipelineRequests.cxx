// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/lms3dPipelineRequests.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkExecutive.h>
#include <vtkExtentTranslator.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;
} // namespace

vtkInformation* lms3dGetRequestedOutput(vtkInformation* request, vtkInformationVector* outputVector)
{
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  return outputVector->GetInformationObject(port);
}

bool lms3dIsFirstPiece(vtkInformation* output)
{
  const auto piece = Pipeline::UPDATE_PIECE_NUMBER();
  return !output->Has(piece) || output->Get(piece) <= 0;
}

std::optional<double> lms3dGetRequestedTime(vtkInformation* output)
{
  const auto time = Pipeline::UPDATE_TIME_STEP();
  return output->Has(time) ? std::optional<double>(output->Get(time)) : std::nullopt;
}

void lms3dRequestPiece(int piece, int pieces, vtkInformation* input)
{
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    int extent[6];
    vtkNew<vtkExtentTranslator> translator;
    translator->PieceToExtentThreadSafe(piece, pieces, 0, input->Get(Pipeline::WHOLE_EXTENT()),
      extent, vtkExtentTranslator::BLOCK_MODE, 0);
    input->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
  }
}

void lms3dUpdateInput(vtkAlgorithm* filter, int port, int piece, int pieces)
{
  int output;
  vtkAlgorithm* producer = filter->GetInputAlgorithm(port, 0, output);
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(output + 1);
  lms3dRequestPiece(piece, pieces, requests->GetInformationObject(output));
  producer->Update(output, requests);
}

void lms3dSetTimeSteps(const std::vector<double>& times, vtkInformation* output)
{
  const double range[2] = { times.front(), times.back() };
  output->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  output->Set(Pipeline::TIME_RANGE(), range, 2);
}

// By default VTK regards the outputs of a stopped filter as up to date.
void lms3dClearOutputs(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* output = outputVector->GetInformationObject(port);
    output->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
    output->Get(vtkDataObject::DATA_OBJECT())->ReleaseData();
  }
}
