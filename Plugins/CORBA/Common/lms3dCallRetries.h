// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Ends calls that a hostile server or listener forwards without end.
 */
#ifndef lms3dCallRetries_h
#define lms3dCallRetries_h

/**
 * If a call fails at an address to which another one has forwarded it, omniORB tries it again
 * without end, and each new connection gets clientConnectTimeOutPeriod in addition to the call's
 * deadline. After this function the ORB tries such a call once more, within its deadline. Leave
 * clientConnectTimeOutPeriod at 0, so that connecting counts too. Applies to all objects of the
 * process. Call before the first remote call.
 */
void lms3dLimitRetries();

#endif
