// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/ProgressListener.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>

#include <utility>

ProgressListener::ProgressListener(vtkAlgorithm* algorithm, std::function<void(double)> react)
  : Algorithm(algorithm)
  , React(std::move(react))
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      static_cast<ProgressListener*>(data)->React(
        static_cast<vtkAlgorithm*>(caller)->GetProgress());
    });
  this->Tag = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
}

ProgressListener::~ProgressListener()
{
  this->Algorithm->RemoveObserver(this->Tag);
}
