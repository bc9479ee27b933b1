// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/LabelledScan.h"

#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

vtkSmartPointer<vtkLMS3DScanFilter> MakeLabelledScan(vtkDataObject* scene)
{
  auto scan = MakeScan(scene);
  scan->SurfaceAttributesOn();
  SetGrid(scan, 61, 72);
  return scan;
}
