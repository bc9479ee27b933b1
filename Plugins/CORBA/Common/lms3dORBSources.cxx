// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dORBSources.h"

#include <cstddef>
#include <cstdlib>
#include <fstream>

namespace
{
const std::string Prefix = "-ORB";

// The name of a line "name = value"; empty for other lines.
std::string GetName(const std::string& line)
{
  const std::size_t first = line.find_first_not_of(" \t");
  const std::size_t end = line.find_first_of(" \t=", first);
  const bool isSetting =
    first != std::string::npos && line[first] != '#' && end != std::string::npos;
  return isSetting ? line.substr(first, end - first) : "";
}
} // namespace

lms3dORBSources::lms3dORBSources(const std::vector<std::string>& arguments)
{
  const char* const variable = std::getenv("OMNIORB_CONFIG");
  std::string file = variable ? variable : "/etc/omniORB.cfg";
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i)
  {
    if (arguments[i].rfind(Prefix, 0) == 0)
    {
      const std::string name = arguments[i].substr(Prefix.size());
      this->Names.insert(name);
      // The value, which may look like a name.
      ++i;
      file = name == "configFile" ? arguments[i] : file;
    }
  }
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
  {
    this->Names.insert(GetName(line));
  }
}

bool lms3dORBSources::IsSet(const std::string& name) const
{
  return this->Names.count(name) != 0 || std::getenv(("ORB" + name).c_str());
}
