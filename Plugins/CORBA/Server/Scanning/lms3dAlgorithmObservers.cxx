// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dAlgorithmObservers.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <utility>

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

// VTK's text is "ERROR: In FILE, line N\nCLASS (ADDRESS): message".
std::string GetMessage(const char* text)
{
  const std::string all(text ? text : "");
  const std::size_t start = all.find("): ");
  std::string message = start == std::string::npos ? all : all.substr(start + 3);
  while (!message.empty() && message.back() == '\n')
  {
    message.pop_back();
  }
  return message;
}

class FirstMessage : public vtkCommand
{
public:
  static FirstMessage* New() { return new FirstMessage; }
  vtkTypeMacro(FirstMessage, vtkCommand);

  void Execute(vtkObject*, unsigned long, void* text) override
  {
    if (this->Text.empty())
    {
      this->Text = GetMessage(static_cast<const char*>(text));
    }
  }

  std::string Text;
};
} // namespace

void lms3dAbortIf(vtkAlgorithm* algorithm, const lms3dStopTest& isStopped)
{
  vtkNew<Abort> abort;
  abort->IsStopped = isStopped;
  algorithm->AddObserver(vtkCommand::ProgressEvent, abort);
}

struct lms3dAlgorithmMessages::Observers
{
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  vtkNew<FirstMessage> Error;
  vtkNew<FirstMessage> Warning;
};

lms3dAlgorithmMessages::lms3dAlgorithmMessages(vtkAlgorithm* algorithm)
  : Internals(new Observers)
{
  this->Internals->Algorithm = algorithm;
  // The executive reports errors too.
  for (vtkObject* object :
    { static_cast<vtkObject*>(algorithm), static_cast<vtkObject*>(algorithm->GetExecutive()) })
  {
    object->AddObserver(vtkCommand::ErrorEvent, this->Internals->Error);
    object->AddObserver(vtkCommand::WarningEvent, this->Internals->Warning);
  }
}

lms3dAlgorithmMessages::~lms3dAlgorithmMessages()
{
  for (vtkObject* object : { static_cast<vtkObject*>(this->Internals->Algorithm),
         static_cast<vtkObject*>(this->Internals->Algorithm->GetExecutive()) })
  {
    object->RemoveObserver(this->Internals->Error);
    object->RemoveObserver(this->Internals->Warning);
  }
}

std::string lms3dAlgorithmMessages::TakeError()
{
  return std::exchange(this->Internals->Error->Text, std::string());
}

std::string lms3dAlgorithmMessages::TakeWarning()
{
  return std::exchange(this->Internals->Warning->Text, std::string());
}
