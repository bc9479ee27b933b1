// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Collects what a reader has to say.
 */
#ifndef lms3dMessages_h
#define lms3dMessages_h

#include "lms3dScene.h"

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

/**
 * Says each thing once, however often a shared part of the scene is met, as an error where it is one
 * at least once. Keeps no more than 1,000 messages: the last then tells how many were left out.
 */
class lms3dMessages
{
public:
  void AddWarning(const std::string& file, std::size_t line, const std::string& text);
  /// Geometry is lost.
  void AddError(const std::string& file, std::size_t line, const std::string& text);

  std::vector<lms3dMessage> Take();

private:
  void Add(lms3dMessage message);

  std::vector<lms3dMessage> Messages;
  /// Where the message with a file, line and text is.
  std::map<std::tuple<std::string, std::size_t, std::string>, std::size_t> Places;
  std::size_t WarningsLeftOut = 0;
  std::size_t ErrorsLeftOut = 0;
};

#endif
