// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dAutoStart.h"

//------------------------------------------------------------------------------
void lms3dAutoStart::shutdown()
{
  for (const QMetaObject::Connection& connection : this->Connections)
  {
    QObject::disconnect(connection);
  }
  this->Connections.clear();
}

//------------------------------------------------------------------------------
void lms3dAutoStart::listen(const QObject* sender, const char* signal, const char* slot)
{
  this->Connections.append(this->connect(sender, signal, slot));
}
