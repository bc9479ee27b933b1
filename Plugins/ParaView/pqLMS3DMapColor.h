// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DMapColor
 * @brief shows a new local map as a green surface
 *
 * Without it a map takes over the colours of its scan and looks like it. Only what comes from the
 * mouse is coloured: a loaded state keeps its own colours.
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
