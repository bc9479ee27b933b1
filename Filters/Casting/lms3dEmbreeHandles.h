// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Owners of Embree's objects, and the check for Embree's errors.
 *
 * The only header that includes Embree. Only the sources named lms3dEmbree* and their tests may
 * include it.
 */
#ifndef lms3dEmbreeHandles_h
#define lms3dEmbreeHandles_h

#if LMS3D_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

struct lms3dEmbreeRelease
{
  void operator()(RTCDevice device) const;
  void operator()(RTCGeometry geometry) const;
  void operator()(RTCScene scene) const;
};

/// Owns one reference, for example lms3dEmbreeHandle<RTCScene>.
template <typename Handle>
using lms3dEmbreeHandle = std::unique_ptr<std::remove_pointer_t<Handle>, lms3dEmbreeRelease>;

/// Throws std::runtime_error, with a text for the user, if the last call of Embree in this thread
/// failed.
void lms3dThrowOnError(RTCDevice device);

#endif
