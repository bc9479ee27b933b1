// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Delays and refuses requests before they reach the object, and identifies their
 * connections.
 */
#ifndef lms3dRequestGate_h
#define lms3dRequestGate_h

#include <omniORB4/CORBA.h>

OMNI_NAMESPACE_BEGIN(omni)
class giopStrand;
OMNI_NAMESPACE_END(omni)

/**
 * This file and lms3dMessageFilter are the only ones that include omniORB's internal headers.
 *
 * omniORB serves from the creation of its first object adapter on, which is before there is an
 * object, and also while it destroys the objects. Clients would then get OBJECT_NOT_EXIST or
 * OBJ_ADAPTER, after which they need not try again. Therefore requests wait until the gate opens,
 * and get TRANSIENT after it has closed. A LocateRequest is no call: at the very end a client can
 * still get OBJECT_NOT_EXIST.
 *
 * Arguments of 64 KiB or more, and requests in fragments, get IMP_LIMIT. No operation needs them.
 *
 * All methods may be called from any thread.
 */
class lms3dRequestGate
{
public:
  /// Call once per process, after ORB_init() and before the ORB's first object adapter exists.
  static void Install();

  /// Lets requests pass.
  static void Open();

  /// Refuses requests from now on. Call before the ORB is destroyed, even if the gate never opened.
  static void Close();

  /// The connection of the call that this thread answers. Null for calls within the process.
  static const omni::giopStrand* GetConnection();

  /// False if the ORB has noticed that the client of this thread's call has closed its connection.
  static bool IsClientConnected();
};

#endif
