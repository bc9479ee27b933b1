// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Object/lms3dReplies.h"

#include "Common/lms3dGridGeometry.h"

#include <numeric>

namespace
{
// Each name has its length before it and a zero after it, and begins at a multiple of four bytes.
std::size_t GetMarshalledSize(const std::vector<std::string>& names)
{
  return std::accumulate(names.begin(), names.end(), std::size_t(0),
    [](std::size_t size, const std::string& name) { return size + name.size() + 8; });
}

void RequireFits(CORBA::ULongLong count, std::size_t size)
{
  if (count > lms3dGetMaximumElements(size))
  {
    throw CORBA::IMP_LIMIT(0, CORBA::COMPLETED_NO);
  }
}
} // namespace

CORBA::String_var lms3dMakeText(const std::string& text)
{
  // The bound of Text in LMS3DScanner.idl.
  constexpr std::size_t MaximumLength = 512;
  std::string plain = text.substr(0, MaximumLength);
  for (char& character : plain)
  {
    if (character < 0x20 || character > 0x7e)
    {
      character = character == '\n' ? ' ' : '?';
    }
  }
  return CORBA::string_dup(plain.c_str());
}

LMS3D::SceneNames* lms3dMakeSceneNames(const lms3dSceneCatalogue& catalogue)
{
  const std::vector<std::string> names = catalogue.GetNames();
  RequireFits(GetMarshalledSize(names), 1);
  LMS3D::SceneNames_var list = new LMS3D::SceneNames;
  list->length(static_cast<CORBA::ULong>(names.size()));
  for (CORBA::ULong i = 0; i < list->length(); ++i)
  {
    list[i] = names[i].c_str();
  }
  return list._retn();
}

LMS3D::Data* lms3dMakePolarData(const lms3dSnapshot& snapshot)
{
  RequireFits(3 * CORBA::ULongLong(snapshot.Header.beams), sizeof(CORBA::Float));
  const lms3dScanGeometry geometry = lms3dGetGeometry(snapshot.Header.settings);
  const CORBA::ULong length = 3 * snapshot.Header.beams;
  CORBA::Float* const buffer = LMS3D::Data::allocbuf(length);
  CORBA::Float* next = buffer;
  const float* range = snapshot.Ranges.data();
  for (const double beta : geometry.GetBetaAngles())
  {
    for (const double alpha : geometry.GetAlphaAngles())
    {
      next[0] = *range++;
      next[1] = static_cast<CORBA::Float>(alpha);
      next[2] = static_cast<CORBA::Float>(beta);
      next += 3;
    }
  }
  return new LMS3D::Data(length, length, buffer, true);
}
