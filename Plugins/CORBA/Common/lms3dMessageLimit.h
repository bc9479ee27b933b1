// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How much fits into a message of the ORB.
 */
#ifndef lms3dMessageLimit_h
#define lms3dMessageLimit_h

#include <omniORB4/CORBA.h>

#include <cstddef>

/// How many elements of so many bytes fit, beside a header and everything else.
inline CORBA::ULongLong lms3dGetMostElements(std::size_t size)
{
  constexpr CORBA::ULong Envelope = 2048;
  return (omniORB::giopMaxMsgSize() - Envelope) / size;
}

#endif
