// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lets requests in no sooner than there is an object, no later, and none that is too long.
 */
#ifndef lms3dRequestGate_h
#define lms3dRequestGate_h

/**
 * omniORB serves as soon as it has an object adapter, which is before there is an object, and on while
 * it destroys them: clients would get OBJECT_NOT_EXIST or OBJ_ADAPTER, after which they need not try
 * again. The ORB's threads wait for the gate to be opened, and once it is closed calls get TRANSIENT.
 * Arguments of 64 KiB or more, and requests in fragments, get IMP_LIMIT; none that the object takes
 * is so long.
 * LocateRequest is no call, so that who sends one in the last moment still gets OBJECT_NOT_EXIST.
 */
class lms3dRequestGate
{
public:
  /// For the one ORB of a process, before its first object adapter.
  static void Install();
  static void Open();
  /// Also where it was never opened, before the ORB is destroyed.
  static void Close();
};

#endif
