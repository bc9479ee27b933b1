// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DTimeSteps
 * @brief lets ParaView's animation play a trajectory that a scan is given, or that changes, later
 *
 * ParaView asks a filter for its time steps when the filter is new and not again. A trajectory comes
 * later, by Edit > Change Input; without this class the animation would not know of its times.
 */

#ifndef pqLMS3DTimeSteps_h
#define pqLMS3DTimeSteps_h

#include <QObject>

class pqPipelineSource;

class pqLMS3DTimeSteps : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqLMS3DTimeSteps(QObject* parent = nullptr);

  void startup();
  void shutdown();

private Q_SLOTS:
  void askAgain(pqPipelineSource* updated);

private:
  Q_DISABLE_COPY(pqLMS3DTimeSteps)
};

#endif
