// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dLogWindow.h"

#include "Common/lms3dLog.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace
{
class LogWindow : public vtkOutputWindow
{
public:
  static LogWindow* New();
  vtkTypeMacro(LogWindow, vtkOutputWindow);

  void DisplayText(const char* text) override { lms3dLog(lms3dLogKind::VTK, text); }
};

vtkStandardNewMacro(LogWindow);
} // namespace

void lms3dLogVTKMessages()
{
  vtkNew<LogWindow> window;
  vtkOutputWindow::SetInstance(window);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}
