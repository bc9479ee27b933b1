// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DPythonStates
 * @brief makes Python states of ParaView's window load the plugin
 *
 * ParaView's Python states do not load plugins. Once the pipeline has a reader or a filter of
 * LMS3D, this class runs Python/lms3d_states.py, which adds the missing line to each state that is
 * saved later. Does nothing if ParaView has no Python. If the script cannot start, the next reader
 * or filter starts it.
 */

#ifndef pqLMS3DPythonStates_h
#define pqLMS3DPythonStates_h

#include "lms3dAutoStart.h"

class pqPipelineSource;

class pqLMS3DPythonStates : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;

private Q_SLOTS:
  void prepare(pqPipelineSource* added);
  void run();

private:
  bool HasRun = false;
};

#endif
