// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Validates what a server sends.
 */
#ifndef lms3dRemoteCheck_h
#define lms3dRemoteCheck_h

#include "Client/lms3dRemoteScan.h"

///@{
/**
 * Throw std::runtime_error if the values are not as LMS3DScanner.idl demands, so that a server
 * cannot make a client run out of memory or read out of bounds. Check the header before fetching
 * the arrays of its scan, then the device, then the arrays; their checksums are compared too. The
 * limit of a local map is 16,000,000 points and twice as many triangles.
 */
void lms3dCheckHeader(const LMS3D::ScanHeader& header);
void lms3dCheckDevice(const lms3dRemoteScan& scan);
void lms3dCheckArrays(const lms3dRemoteScan& scan);
///@}

#endif
