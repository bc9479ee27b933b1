// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLMS3DQuickSearch
 * @brief finds LMS3D's filters by the words lidar, laser and range in ParaView's quick search
 *
 * The quick search (Ctrl+Space) searches the texts of the menu entries alone. This class adds the
 * words to the entries while the search collects them.
 */

#ifndef pqLMS3DQuickSearch_h
#define pqLMS3DQuickSearch_h

#include "lms3dAutoStart.h"

class pqLMS3DQuickSearch : public lms3dAutoStart
{
  Q_OBJECT

public:
  void startup() override;

private Q_SLOTS:
  void addWords();
};

#endif
