// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/MethodFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkPolyData.h>

std::string GetMethodName(const testing::TestParamInfo<int>& method)
{
  return vtkLMS3DScanFilter::GetIntersectionMethodName(method.param);
}

double GetMinimumShare(int method)
{
  switch (method)
  {
    case vtkLMS3DScanFilter::MOLLER_TRUMBORE:
    case vtkLMS3DScanFilter::STATIC_CELL_LOCATOR:
      return 0.98;
    default:
      return 1.0;
  }
}

void SetUpScan(vtkLMS3DScanFilter* scan, vtkPolyData* scene, int method)
{
  scan->SetInputData(scene);
  scan->SetIntersectionMethod(method);
  scan->SetAlphaResolution(31);
  scan->SetBetaResolution(36);
}
