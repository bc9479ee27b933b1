// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class lms3dAutoStart
 * @brief base of the objects that start with the plugin and listen to ParaView
 *
 * ParaView creates an object of each subclass that CMakeLists.txt lists, calls startup() when it
 * loads the plugin, and shutdown() when it ends.
 */

#ifndef lms3dAutoStart_h
#define lms3dAutoStart_h

#include <QList>
#include <QMetaObject>
#include <QObject>

class lms3dAutoStart : public QObject
{
public:
  using QObject::QObject;

  virtual void startup() = 0;
  /// Ends all connections that listen() has made.
  virtual void shutdown();

protected:
  /// Connects a slot of this object. `signal` and `slot` are written with SIGNAL() and SLOT().
  void listen(const QObject* sender, const char* signal, const char* slot);

private:
  QList<QMetaObject::Connection> Connections;
};

#endif
