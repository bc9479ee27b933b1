// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The messages of a reading as texts for the user.
 */
#ifndef lms3dMessageList_h
#define lms3dMessageList_h

#include "Model/lms3dScene.h"

#include <string>
#include <vector>

class lms3dMessageList
{
public:
  lms3dMessageList() = default;
  explicit lms3dMessageList(const std::vector<lms3dMessage>& messages);

  int GetSize() const { return static_cast<int>(this->Texts.size()); }

  /// Returns "file:line: text", or shorter if the line or the file is not known. Returns an empty
  /// string if the index is out of range.
  std::string GetText(int i) const;

  /// Returns MESSAGE_WARNING if the index is out of range.
  int GetSeverity(int i) const;

  bool HasErrors() const;

  /// Returns the first error, or else the first warning, or else an empty string.
  std::string GetMostSevere() const;

  /// Returns the most severe message and, if there are several, the first 20 of all messages, one
  /// on each line.
  std::string Summarize() const;

private:
  std::vector<std::string> Texts;
  std::vector<int> Severities;
};

#endif
