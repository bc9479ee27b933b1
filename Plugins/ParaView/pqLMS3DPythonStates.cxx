// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqLMS3DPythonStates.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>

#include <QFile>

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
pqLMS3DPythonStates::pqLMS3DPythonStates(QObject* parentObject)
  : Superclass(parentObject)
{
}

//------------------------------------------------------------------------------
void pqLMS3DPythonStates::startup()
{
  this->connect(pqApplicationCore::instance()->getServerManagerModel(),
    SIGNAL(sourceAdded(pqPipelineSource*)), SLOT(prepare(pqPipelineSource*)));
}

//------------------------------------------------------------------------------
void pqLMS3DPythonStates::shutdown()
{
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
}

//------------------------------------------------------------------------------
void pqLMS3DPythonStates::prepare(pqPipelineSource* added)
{
  if (!IsOfLMS3D(added->getProxy()))
  {
    return;
  }
  this->shutdown(); // once is enough
  QFile script(":/LMS3D/lms3d_states.py");
  QObject* python = FindPythonManager();
  if (python && script.open(QIODevice::ReadOnly))
  {
    QMetaObject::invokeMethod(python, "executeCode", Q_ARG(QByteArray, script.readAll()));
  }
}
