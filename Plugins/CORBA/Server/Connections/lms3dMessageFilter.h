// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Withholds messages from the ORB that it cannot handle safely.
 */
#ifndef lms3dMessageFilter_h
#define lms3dMessageFilter_h

/**
 * Skips fragments of requests, and cancellations of requests.
 *
 * omniORB assigns such a message to the first call of the connection with the same number. If
 * another thread still answers that call, both threads use its memory, and the process crashes. And
 * while omniORB reads a request in fragments, it stores the connection's other requests without
 * limit. Therefore the ORB gets only the beginning of such a request, as a complete one. GIOP
 * permits a server to ignore a cancellation.
 */
class lms3dMessageFilter
{
public:
  /// Call once per process, after ORB_init() and before the ORB's first object adapter exists.
  static void Install();

  /// True if the ORB gets only the beginning of the request that this thread has received last.
  static bool IsRequestIncomplete();
};

#endif
