// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DPythonStates.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>

#include <QFile>
#include <QTimer>

#include <vtkSMProxy.h>

namespace
{
bool IsOfLMS3D(vtkSMProxy* source)
{
  const QString name = source->GetXMLName();
  return name == "vrmlreader" || name.startsWith("LMS3D");
}

// By name, so that the plugin does not link ParaView's Python.
QObject* FindPythonManager()
{
  for (QObject* child : pqApplicationCore::instance()->children())
  {
    if (child->inherits("pqPythonManager"))
    {
      return child;
    }
  }
  return nullptr;
}
} // namespace

//------------------------------------------------------------------------------
void pqLMS3DPythonStates::startup()
{
  this->listen(pqApplicationCore::instance()->getServerManagerModel(),
    SIGNAL(sourceAdded(pqPipelineSource*)), SLOT(prepare(pqPipelineSource*)));
}

//------------------------------------------------------------------------------
// Later, because Python must not start while ParaView adds the source.
void pqLMS3DPythonStates::prepare(pqPipelineSource* added)
{
  if (IsOfLMS3D(added->getProxy()))
  {
    QTimer::singleShot(0, this, SLOT(run()));
  }
}

//------------------------------------------------------------------------------
void pqLMS3DPythonStates::run()
{
  QFile script(":/LMS3D/lms3d_states.py");
  QObject* python = FindPythonManager();
  if (!this->HasRun && python && script.open(QIODevice::ReadOnly))
  {
    this->HasRun =
      QMetaObject::invokeMethod(python, "executeCode", Q_ARG(QByteArray, script.readAll()));
  }
  if (this->HasRun)
  {
    this->shutdown(); // once is enough
  }
}
