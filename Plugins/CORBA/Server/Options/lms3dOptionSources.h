// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Splits a command line and a configuration file into options and their values.
 */
#ifndef lms3dOptionSources_h
#define lms3dOptionSources_h

#include <cstddef>
#include <string>
#include <vector>

struct lms3dOptionSetting
{
  using Words = std::vector<std::string>;

  /// Where it stands, for messages.
  std::string Origin;
  std::string Name;
  Words Values;
};

struct lms3dCommandLine
{
  std::vector<lms3dOptionSetting> Settings;
  /// Those that begin with -ORB, each with its value.
  std::vector<std::string> ORBArguments;
};

/// The number of values that an option takes; throws std::invalid_argument for an unknown one.
using lms3dOptionCount = std::size_t (*)(const std::string& name);

///@{
/// Throw std::invalid_argument with what is wrong and where.
lms3dCommandLine lms3dReadCommandLine(
  const std::vector<std::string>& arguments, lms3dOptionCount getCount);
std::vector<lms3dOptionSetting> lms3dReadOptionFile(
  const std::string& file, lms3dOptionCount getCount);
///@}

#endif
