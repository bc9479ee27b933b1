// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/lms3dMessageList.h"

#include <algorithm>
#include <cstddef>

namespace
{
constexpr std::size_t MaximumListedMessages = 20;

std::string ToText(const lms3dMessage& message)
{
  const std::string line = message.Line > 0 ? ":" + std::to_string(message.Line) : "";
  return (message.File.empty() ? "" : message.File + line + ": ") + message.Text;
}
} // namespace

lms3dMessageList::lms3dMessageList(const std::vector<lms3dMessage>& messages)
{
  for (const lms3dMessage& message : messages)
  {
    this->Texts.push_back(ToText(message));
    this->Severities.push_back(message.Severity);
  }
}

std::string lms3dMessageList::GetText(int i) const
{
  return i >= 0 && i < this->GetSize() ? this->Texts[i] : std::string();
}

int lms3dMessageList::GetSeverity(int i) const
{
  return i >= 0 && i < this->GetSize() ? this->Severities[i] : lms3dMessage::MESSAGE_WARNING;
}

bool lms3dMessageList::HasErrors() const
{
  return std::find(this->Severities.begin(), this->Severities.end(), lms3dMessage::MESSAGE_ERROR) !=
    this->Severities.end();
}

std::string lms3dMessageList::GetMostSevere() const
{
  const auto first = std::max_element(this->Severities.begin(), this->Severities.end());
  return this->GetText(static_cast<int>(first - this->Severities.begin()));
}

// The list is for windows such as ParaView's, whose users cannot call GetMessage.
std::string lms3dMessageList::Summarize() const
{
  std::string summary = this->GetMostSevere();
  if (this->Texts.size() < 2)
  {
    return summary;
  }
  const std::size_t listed = std::min(this->Texts.size(), MaximumListedMessages);
  summary += "\nAll " + std::to_string(this->Texts.size()) + " messages:";
  for (std::size_t i = 0; i < listed; ++i)
  {
    summary.append("\n").append(this->Texts[i]);
  }
  if (listed < this->Texts.size())
  {
    summary.append("\nand so on, see GetMessage");
  }
  return summary;
}
