// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/lms3dMessages.h"

#include "Model/lms3dUTF8.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr std::size_t MaximumNumberOfMessages = 1000;
constexpr std::size_t MaximumTextLength = 1000;

// Names in a file have no maximum length.
std::string Shorten(const std::string& text)
{
  const std::string_view beginning = lms3dCutUTF8(text, MaximumTextLength);
  return lms3dToUTF8(beginning) + (beginning.size() < text.size() ? "..." : "");
}
} // namespace

void lms3dMessages::AddWarning(const std::string& file, std::size_t line, const std::string& text)
{
  this->Add({ lms3dMessage::MESSAGE_WARNING, file, line, Shorten(text) });
}

void lms3dMessages::AddError(const std::string& file, std::size_t line, const std::string& text)
{
  this->Add({ lms3dMessage::MESSAGE_ERROR, file, line, Shorten(text) });
}

void lms3dMessages::Add(lms3dMessage message)
{
  const auto known = this->Indices.find({ message.File, message.Line, message.Text });
  if (known != this->Indices.end())
  {
    int& severity = this->Messages[known->second].Severity;
    severity = std::max(severity, message.Severity);
  }
  else if (this->Messages.size() == MaximumNumberOfMessages)
  {
    ++(message.Severity == lms3dMessage::MESSAGE_ERROR ? this->OmittedErrors
                                                       : this->OmittedWarnings);
  }
  else
  {
    this->Indices[{ message.File, message.Line, message.Text }] = this->Messages.size();
    this->Messages.push_back(std::move(message));
  }
}

std::vector<lms3dMessage> lms3dMessages::Take()
{
  if (this->OmittedErrors + this->OmittedWarnings > 0)
  {
    this->Messages.push_back(
      { this->OmittedErrors > 0 ? lms3dMessage::MESSAGE_ERROR : lms3dMessage::MESSAGE_WARNING, "",
        0,
        "more was not read: " + std::to_string(this->OmittedErrors) + " more errors and " +
          std::to_string(this->OmittedWarnings) + " more warnings" });
  }
  return std::move(this->Messages);
}
