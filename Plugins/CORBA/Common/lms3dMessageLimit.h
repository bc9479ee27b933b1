// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The size of a message.
 */
#ifndef lms3dMessageLimit_h
#define lms3dMessageLimit_h

#include <omniORB4/CORBA.h>

#include <cstddef>

/// The number of elements of `size` bytes that fit into a message of the ORB beside all headers.
/// The limit is omniORB's giopMaxMsgSize.
inline CORBA::ULongLong lms3dGetMaximumElements(std::size_t size)
{
  constexpr CORBA::ULong HeaderBytes = 2048;
  return (omniORB::giopMaxMsgSize() - HeaderBytes) / size;
}

#endif
