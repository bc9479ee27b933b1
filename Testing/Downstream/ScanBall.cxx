// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include <vtkLMS3DScanFilter.h>
#include <vtkVRMLImporterSource.h>

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <iostream>

/// Scans the VRML file that the first argument names; all beams must return.
int main(int argc, char* argv[])
{
  vtkNew<vtkVRMLImporterSource> scene;
  scene->SetFileName(argc > 1 ? argv[1] : "");
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputConnection(scene->GetOutputPort());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->Update();
  std::cout << scan->GetOutput()->GetNumberOfPoints() << " returns\n";
  return scan->GetOutput()->GetNumberOfPoints() == 129960 ? 0 : 1;
}
