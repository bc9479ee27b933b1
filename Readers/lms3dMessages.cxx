// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dMessages.h"

#include "lms3dUTF8.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr std::size_t MostMessages = 1000;
constexpr std::size_t LongestText = 1000;

// A file can have names of any length.
std::string Shorten(const std::string& text)
{
  const std::string_view beginning = lms3dCutUTF8(text, LongestText);
  return lms3dToUTF8(beginning) + (beginning.size() < text.size() ? "..." : "");
}
} // namespace

void lms3dMessages::AddWarning(const std::string& file, std::size_t line, const std::string& text)
{
  this->Add({ lms3dMessage::WARNING, file, line, Shorten(text) });
}

void lms3dMessages::AddError(const std::string& file, std::size_t line, const std::string& text)
{
  this->Add({ lms3dMessage::ERROR, file, line, Shorten(text) });
}

void lms3dMessages::Add(lms3dMessage message)
{
  const auto known = this->Places.find({ message.File, message.Line, message.Text });
  if (known != this->Places.end())
  {
    int& severity = this->Messages[known->second].Severity;
    severity = std::max(severity, message.Severity);
  }
  else if (this->Messages.size() == MostMessages)
  {
    ++(message.Severity == lms3dMessage::ERROR ? this->ErrorsLeftOut : this->WarningsLeftOut);
  }
  else
  {
    this->Places[{ message.File, message.Line, message.Text }] = this->Messages.size();
    this->Messages.push_back(std::move(message));
  }
}

std::vector<lms3dMessage> lms3dMessages::Take()
{
  if (this->ErrorsLeftOut + this->WarningsLeftOut > 0)
  {
    this->Messages.push_back(
      { this->ErrorsLeftOut > 0 ? lms3dMessage::ERROR : lms3dMessage::WARNING, "", 0,
        "there is more that was not read: " + std::to_string(this->ErrorsLeftOut) +
          " more errors and " + std::to_string(this->WarningsLeftOut) + " more warnings" });
  }
  return std::move(this->Messages);
}
