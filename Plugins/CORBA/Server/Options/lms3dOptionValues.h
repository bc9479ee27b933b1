// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Values of options.
 */
#ifndef lms3dOptionValues_h
#define lms3dOptionValues_h

#include <array>
#include <string>
#include <vector>

///@{
/// Throw std::invalid_argument, which tells the text and what it had to be.
double lms3dGetNumber(const std::string& text, double lowest, double highest);
int lms3dGetCount(const std::string& text, int lowest, int highest);
std::array<double, 3> lms3dGetVector(const std::vector<std::string>& words);
/// True for `second`, false for `first`.
bool lms3dGetChoice(const std::string& text, const std::string& first, const std::string& second);
///@}

#endif
