// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads and writes the requests of VTK's pipeline.
 */
#ifndef lms3dPipelineRequests_h
#define lms3dPipelineRequests_h

#include <optional>
#include <vector>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

/// Returns the output whose consumer runs the filter, or the first output if the request has none.
vtkInformation* lms3dGetRequestedOutput(
  vtkInformation* request, vtkInformationVector* outputVector);

/// Returns whether the consumer of an output requests its first piece, or no piece in particular.
bool lms3dIsFirstPiece(vtkInformation* output);

/// Returns the time that the consumer of an output requests, if it requests one.
std::optional<double> lms3dGetRequestedTime(vtkInformation* output);

/// Requests piece `piece` of `pieces` of an input, without ghost levels; of a structured input the
/// extent of this piece.
void lms3dRequestPiece(int piece, int pieces, vtkInformation* input);

/// Updates a piece of an input, by default all of it, during RequestInformation, before the
/// pipeline requests data. The port must have a connection.
void lms3dUpdateInput(vtkAlgorithm* filter, int port, int piece = 0, int pieces = 1);

/// Sets TIME_STEPS and TIME_RANGE of an output. The times must increase, and there must be at least
/// one.
void lms3dSetTimeSteps(const std::vector<double>& times, vtkInformation* output);

/// Empties all outputs after work that was stopped, and marks them so that the next update runs
/// again.
void lms3dClearOutputs(vtkInformationVector* outputVector);

#endif
