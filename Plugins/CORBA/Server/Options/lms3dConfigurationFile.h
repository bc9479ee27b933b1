// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The lines of a configuration file.
 */
#ifndef lms3dConfigurationFile_h
#define lms3dConfigurationFile_h

#include <functional>
#include <string>

/// `text` without the blanks at both ends.
std::string lms3dTrim(const std::string& text);

/**
 * Calls `parse` for each line that is neither empty nor a comment (#), without the blanks at its
 * ends. Adds file, number and line to the message of a std::invalid_argument that `parse` throws.
 * Throws std::invalid_argument if the file cannot be read.
 */
void lms3dReadConfigurationFile(
  const std::string& file, const std::function<void(const std::string& line)>& parse);

#endif
