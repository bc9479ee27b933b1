// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Collects the messages of a reader.
 */
#ifndef lms3dMessages_h
#define lms3dMessages_h

#include "Model/lms3dScene.h"

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

/**
 * Stores each message once, also if a shared part of the scene is visited often. If the same
 * message is added as a warning and as an error, the error remains. Stores 1,000 messages at most;
 * one more then counts the omitted ones. Longer texts than 1,000 bytes are truncated.
 */
class lms3dMessages
{
public:
  ///@{
  /// `line` counts from 1; 0 means that the line is not known. An error is a loss of geometry.
  void AddWarning(const std::string& file, std::size_t line, const std::string& text);
  void AddError(const std::string& file, std::size_t line, const std::string& text);
  ///@}

  /// Moves the messages out, in the order in which they came. Call once, at the end.
  std::vector<lms3dMessage> Take();

private:
  void Add(lms3dMessage message);

  std::vector<lms3dMessage> Messages;
  /// Maps file, line and text to an index into Messages.
  std::map<std::tuple<std::string, std::size_t, std::string>, std::size_t> Indices;
  std::size_t OmittedWarnings = 0;
  std::size_t OmittedErrors = 0;
};

#endif
