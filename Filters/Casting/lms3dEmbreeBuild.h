// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Builds the acceleration structure of an Embree scene, with progress and abort.
 */
#ifndef lms3dEmbreeBuild_h
#define lms3dEmbreeBuild_h

#include "Casting/lms3dBuildStopped.h"
#include "Casting/lms3dEmbreeHandles.h"
#include "Pipeline/lms3dProgress.h"

/**
 * Commits a scene on the calling thread and the threads of its TBB arena. `progress` may be empty.
 * It receives Embree's estimate of the work that is done, on the calling thread only; a small scene
 * may give no report at all. Throws lms3dBuildStopped if `progress` returned false, and
 * std::runtime_error if Embree fails, for example because memory is short. The scene can then only
 * be released.
 */
void lms3dCommitScene(RTCDevice device, RTCScene scene, const lms3dProgress& progress);

#endif
