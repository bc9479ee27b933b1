// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads the surfaces of VRML97 scenes (ISO/IEC 14772-1:1997).
 */
#ifndef lms3dVRMLReader_h
#define lms3dVRMLReader_h

#include "Grammar/lms3dVRMLOptions.h"
#include "Model/lms3dScene.h"

#include <string>

/**
 * Reads a scene with its Inlines and prototypes, and all that can be read of a faulty one.
 *
 * Every loss of geometry is a message of severity MESSAGE_ERROR. If `progress` returns false, the
 * reading stops. The scene is then incomplete, without a message: discard it.
 *
 * Never throws because of the content of a file. std::bad_alloc and other exceptions of the
 * standard library pass through.
 */
lms3dScene lms3dReadVRML(const std::string& fileName, const lms3dVRMLOptions& options,
  const lms3dProgressFunction& progress);

#endif
