// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dAbort.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkNew.h>

namespace
{
class Abort : public vtkCommand
{
public:
  static Abort* New() { return new Abort; }
  vtkTypeMacro(Abort, vtkCommand);

  void Execute(vtkObject* algorithm, unsigned long, void*) override
  {
    if (this->IsStopped())
    {
      static_cast<vtkAlgorithm*>(algorithm)->SetAbortExecute(1);
    }
  }

  lms3dStopTest IsStopped;
};
} // namespace

void lms3dAbortIf(vtkAlgorithm* algorithm, const lms3dStopTest& isStopped)
{
  vtkNew<Abort> abort;
  abort->IsStopped = isStopped;
  algorithm->AddObserver(vtkCommand::ProgressEvent, abort);
}
