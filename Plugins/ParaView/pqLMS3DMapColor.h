// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DMapColor
 * @brief shows a new local map as a green surface
 *
 * Without this class a map would inherit the colours of its scan. A map is new when it is shown in a
 * view for the first time, by the user or by Show() in the Python shell. A map that a state, undo or
 * redo restores keeps its colours.
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
