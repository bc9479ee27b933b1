// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a filter asks of VTK's pipeline, and what it is asked for.
 */
#ifndef lms3dPipelineRequests_h
#define lms3dPipelineRequests_h

#include <vector>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

/// The output whose consumer makes the filter run, the first where nobody says.
vtkInformation* lms3dGetRequestedOutput(
  vtkInformation* request, vtkInformationVector* outputVector);

/// Whether the consumer of an output asks for its first piece, or for no piece in particular.
bool lms3dIsFirstPiece(vtkInformation* output);

/// Asks for one of so many pieces of an input; of an image for the extent that goes with it.
void lms3dRequestPiece(int piece, int pieces, vtkInformation* input);

/// Brings the whole of an input up to date before the pipeline asks for data.
void lms3dUpdateInput(vtkAlgorithm* filter, int port);

/// Offers increasing times of which there is at least one.
void lms3dSetTimeSteps(const std::vector<double>& times, vtkInformation* output);

/// Empties all outputs and lets the next update run again, after work that was stopped.
void lms3dClearOutputs(vtkInformationVector* outputVector);

#endif
