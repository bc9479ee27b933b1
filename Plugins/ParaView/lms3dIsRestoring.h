// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Distinguishes new representations from restored ones.
 */

#ifndef lms3dIsRestoring_h
#define lms3dIsRestoring_h

#include <pqApplicationCore.h>
#include <pqUndoStack.h>

/// Whether a state, undo or redo restores representations, which have their look already.
inline bool lms3dIsRestoring()
{
  pqApplicationCore* core = pqApplicationCore::instance();
  const pqUndoStack* stack = core->getUndoStack();
  return core->isLoadingState() || (stack && (stack->getInUndo() || stack->getInRedo()));
}

#endif
