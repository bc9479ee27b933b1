// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The catalogue of scenes as listScenes() returns it.
 */
#ifndef lms3dSceneNames_h
#define lms3dSceneNames_h

#include "LMS3DScanner.hh"
#include "lms3dSceneCatalogue.h"

/// Owned by the caller. Throws CORBA::IMP_LIMIT where the names do not fit into a message.
LMS3D::SceneNames* lms3dMakeSceneNames(const lms3dSceneCatalogue& catalogue);

#endif
