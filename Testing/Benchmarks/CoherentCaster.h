// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Casts coherent packets of 16 rays with Embree 3 or 4.
 */
#ifndef CoherentCaster_h
#define CoherentCaster_h

#include "EmbreeHandles.h"

class CoherentCaster
{
public:
  explicit CoherentCaster(RTCScene scene)
    : Scene(scene)
  {
#if LMS3D_EMBREE_MAJOR >= 4
    rtcInitIntersectArguments(&this->Arguments);
    this->Arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
#else
    rtcInitIntersectContext(&this->Context);
    this->Context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
#endif
  }

  void Intersect(const int* valid, RTCRayHit16& packet)
  {
#if LMS3D_EMBREE_MAJOR >= 4
    rtcIntersect16(valid, this->Scene, &packet, &this->Arguments);
#else
    rtcIntersect16(valid, this->Scene, &this->Context, &packet);
#endif
  }

private:
  RTCScene Scene;
#if LMS3D_EMBREE_MAJOR >= 4
  RTCIntersectArguments Arguments;
#else
  RTCIntersectContext Context;
#endif
};

#endif
