// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DEmptyScans
 * @brief warns in Output Messages if no beam of a scan returned
 *
 * Without the warning a user sees an empty view. Warns once, and again only after a scan with returns, so
 * that a sensor that is dragged through empty space does not fill the messages.
 */

#ifndef pqLMS3DEmptyScans_h
#define pqLMS3DEmptyScans_h

#include <QObject>
#include <QSet>

class pqPipelineSource;

class pqLMS3DEmptyScans : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqLMS3DEmptyScans(QObject* parent = nullptr);

  void startup();
  void shutdown();

private Q_SLOTS:
  void check(pqPipelineSource* updated);
  void forget(pqPipelineSource* removed);

private:
  Q_DISABLE_COPY(pqLMS3DEmptyScans)

  QSet<pqPipelineSource*> Empty;
};

#endif
