// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The array Status: why each beam of a scan gave a return, or none.
 */
#ifndef lms3dBeamStatus_h
#define lms3dBeamStatus_h

#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>

class vtkFieldData;
class vtkImageData;
class vtkMultiProcessController;

/// The values of vtkLMS3DScanFilter::BeamStatus, which documents them.
enum class lms3dBeamStatus : unsigned char
{
  Return,
  NothingMet,
  BeyondRange,
  TooWeak,
  TooNear
};

/// What decides about the status of beams. All arrays have one value for each beam of the grid.
struct lms3dBeamOutcomes
{
  /// Metres, NaN without a return.
  const double* Ranges;

  /// The range of the nearest surface without limits, metres, NaN if there is none; read only for
  /// beams without a return. Null if the limits took no return away.
  const double* Unlimited;

  /// 1 for a return that was removed because it is too weak, otherwise 0. Null if there are none.
  const unsigned char* IsWeak;

  /// The minimum range, metres.
  double Minimum;
};

/// Returns the array Status of `beams` beams. Uses the threads of the calling TBB arena.
vtkSmartPointer<vtkUnsignedCharArray> lms3dMakeStatus(
  const lms3dBeamOutcomes& outcomes, std::size_t beams);

/// Adds the array to the field data of a scan, in shared memory. ParaView does not offer it for
/// colouring.
void lms3dAddStatus(vtkUnsignedCharArray* status, vtkFieldData* data);

/// Adds the array, or, if the image is a part of the grid, a copy of this part, to the point data
/// of a range image with `beams` beams in each turn.
void lms3dAddStatus(vtkUnsignedCharArray* status, int beams, vtkImageData* image);

/// Replaces each of the values by the largest of all processes. All processes must have the same
/// number of values. Null stands for this process alone. Collective.
void lms3dReduceToLargest(
  vtkMultiProcessController* controller, unsigned char* values, std::size_t count);

#endif
