// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Texts with numbers.
 */
#ifndef lms3dText_h
#define lms3dText_h

#include <sstream>
#include <string>

/// Returns the parts as one text, as a stream writes them.
template <typename... Parts>
std::string lms3dJoinText(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

#endif
