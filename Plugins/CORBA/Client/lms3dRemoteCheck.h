// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a server sends, before anybody uses it.
 */
#ifndef lms3dRemoteCheck_h
#define lms3dRemoteCheck_h

#include "lms3dRemoteScan.h"

///@{
/**
 * Throw std::runtime_error where the numbers are not those that LMS3DScanner.idl allows, so that no
 * server can make its clients run out of memory or bounds: the header before anything is fetched for
 * it, then the arrays, their checksums included. A local map may have 16,000,000 points and twice as
 * many triangles.
 */
void lms3dCheckHeader(const LMS3D::ScanHeader& header);
void lms3dCheckArrays(const lms3dRemoteScan& scan);
///@}

#endif
