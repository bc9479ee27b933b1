// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Who called.
 */
#ifndef lms3dCaller_h
#define lms3dCaller_h

#include <omniORB4/CORBA.h>

OMNI_NAMESPACE_BEGIN(omni)
class giopStrand;
OMNI_NAMESPACE_END(omni)

/// For the ORB's thread that is to answer the next call of this connection.
void lms3dSetCaller(const omni::giopStrand& connection);

/// The connection of the call that this thread answers.
const omni::giopStrand* lms3dGetCaller();

/// False once the ORB knows that the client of this thread's call has closed its connection.
bool lms3dIsCallerThere();

#endif
