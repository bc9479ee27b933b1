// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/lms3dAlgorithmProgress.h"

#include <vtkAlgorithm.h>
#include <vtkVersionMacros.h>

namespace
{
bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}
} // namespace

lms3dProgress lms3dReportTo(vtkAlgorithm* algorithm, double first, double last)
{
  return [=](double done)
  {
    algorithm->UpdateProgress(first + done * (last - first));
    return !IsAborted(algorithm);
  };
}
