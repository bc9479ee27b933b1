// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Embree's objects, released when nobody holds them any more.
 *
 * For lms3dEmbreeScene.cxx alone: no other source sees Embree.
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

template <typename Handle>
using lms3dEmbreeHandle = std::unique_ptr<std::remove_pointer_t<Handle>, lms3dEmbreeRelease>;

/// Throws std::runtime_error where the last call of Embree in this thread failed.
void lms3dThrowOnError(RTCDevice device);

#endif
