// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/lms3dVRMLHeader.h"

#include <algorithm>
#include <array>

namespace
{
const char* const ByteOrderMark = "\xEF\xBB\xBF";

struct Format
{
  const char* Beginning;
  /// What such a file is; empty for VRML97.
  const char* Description;
};

const std::array<Format, 8> Formats = { {
  { "#VRML V2.0 binary", "is a binary VRML file, not VRML97 in text" },
  { "#VRML V2.0", "" },
  { "#VRML V1.0", "is a VRML 1.0 file, which is another format than VRML97; convert it" },
  { "#VRML", "does not begin with \"#VRML V2.0\", so it has another version of VRML" },
  { "#X3D", "is an X3D file, not VRML97; convert it" },
  { "<?xml", "is an XML file (X3D?), not VRML97; convert it" },
  { "<X3D", "is an X3D file, not VRML97; convert it" },
  { "#Inventor", "is an Open Inventor file, not VRML97; convert it" },
} };

bool BeginsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

bool IsBinary(const std::string& text)
{
  return text.find('\0') != std::string::npos;
}
} // namespace

std::string lms3dExplainBeginning(const std::string& beginning)
{
  const std::string text = beginning.substr(BeginsWith(beginning, ByteOrderMark) ? 3 : 0);
  const auto* const format = std::find_if(Formats.begin(), Formats.end(),
    [&text](const Format& each) { return BeginsWith(text, each.Beginning); });
  if (format != Formats.end())
  {
    return format->Description;
  }
  return IsBinary(text)
    ? "is a binary file, not a VRML97 file"
    : "does not begin with \"#VRML V2.0\", so it is not a VRML 2.0 (VRML97) file";
}
