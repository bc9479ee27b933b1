// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reports each error of a VTK filter once.
 */
#ifndef lms3dErrorReport_h
#define lms3dErrorReport_h

#include <vtkType.h>

#include <string>

class vtkAlgorithm;
class vtkInformationVector;

/**
 * The error of a filter's last run that failed.
 *
 * An application such as ParaView updates a filter several times for one change: for each output,
 * each view, each time step. The same error is reported again only if a property or anything
 * upstream has changed since.
 */
class lms3dErrorReport
{
public:
  /// Empties the outputs, and reports the error if it is new. Returns what RequestData has to
  /// return: 1, because after 0 VTK would add an error of its own, and run the filter again at each
  /// update.
  int Report(vtkAlgorithm* filter, const std::string& error, vtkInformationVector* outputVector);

private:
  std::string Error;
  vtkMTimeType PipelineTime = 0;
};

#endif
