// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dSceneNames.h"

#include "lms3dMessageLimit.h"

#include <cstddef>
#include <numeric>

namespace
{
// On the wire each has its length before it, a zero after it, and begins at a multiple of four.
std::size_t GetMarshalledSize(const std::vector<std::string>& names)
{
  return std::accumulate(names.begin(), names.end(), std::size_t(0),
    [](std::size_t size, const std::string& name) { return size + name.size() + 8; });
}
} // namespace

LMS3D::SceneNames* lms3dMakeSceneNames(const lms3dSceneCatalogue& catalogue)
{
  const std::vector<std::string> names = catalogue.GetNames();
  if (GetMarshalledSize(names) > lms3dGetMostElements(1))
  {
    throw CORBA::IMP_LIMIT(0, CORBA::COMPLETED_NO);
  }
  LMS3D::SceneNames_var list = new LMS3D::SceneNames;
  list->length(static_cast<CORBA::ULong>(names.size()));
  for (CORBA::ULong i = 0; i < list->length(); ++i)
  {
    list[i] = names[i].c_str();
  }
  return list._retn();
}
