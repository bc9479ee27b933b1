// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a VTK algorithm has to complain of, as text.
 */
#ifndef lms3dVTKProblems_h
#define lms3dVTKProblems_h

#include <string>

class vtkAlgorithm;

/// Keeps errors and warnings of an algorithm while it lives, in place of VTK's printing them.
class lms3dVTKProblems
{
public:
  explicit lms3dVTKProblems(vtkAlgorithm* algorithm);
  ~lms3dVTKProblems();
  lms3dVTKProblems(const lms3dVTKProblems&) = delete;
  void operator=(const lms3dVTKProblems&) = delete;

  /// The first error and the first warning since the last call; empty where all was well.
  std::string TakeError();
  std::string TakeWarning();

private:
  struct Observers;
  Observers* const Internals;
};

#endif
