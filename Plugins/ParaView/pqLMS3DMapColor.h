// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DMapColor
 * @brief shows a new local map as a green surface
 *
 * Without it a map takes over the colours of its scan and looks like it. A map is new when it is first
 * shown in a view, by the mouse or by Show() in the window's Python shell; what a state, undo or redo
 * brings back keeps the colours that it had.
 */

#ifndef pqLMS3DMapColor_h
#define pqLMS3DMapColor_h

#include <QObject>

class pqRepresentation;

class pqLMS3DMapColor : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqLMS3DMapColor(QObject* parent = nullptr);

  void startup();
  void shutdown();

private Q_SLOTS:
  void color(pqRepresentation* added);

private:
  Q_DISABLE_COPY(pqLMS3DMapColor)
};

#endif
