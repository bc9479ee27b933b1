// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Object/lms3dReplies.h"

#include "Common/lms3dDeviceNames.h"

#include <numeric>

namespace
{
// Each name has its length before it and a zero after it, and begins at a multiple of four bytes.
std::size_t GetMarshalledSize(const std::vector<std::string>& names)
{
  return std::accumulate(names.begin(), names.end(), std::size_t(0),
    [](std::size_t size, const std::string& name) { return size + name.size() + 8; });
}

template <typename Sequence>
Sequence* MakeNames(const std::vector<std::string>& names)
{
  typename Sequence::_var_type list = new Sequence;
  list->length(static_cast<CORBA::ULong>(names.size()));
  for (CORBA::ULong i = 0; i < list->length(); ++i)
  {
    list[i] = names[i].c_str();
  }
  return list._retn();
}

template <typename Sequence, typename Element>
void Copy(const std::vector<Element>& all, Sequence& copy)
{
  const auto length = static_cast<CORBA::ULong>(all.size());
  Element* const buffer = Sequence::allocbuf(length);
  std::copy(all.begin(), all.end(), buffer);
  copy.replace(length, length, buffer, true);
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
  if (GetMarshalledSize(names) > lms3dGetMaximumElements(1))
  {
    throw CORBA::IMP_LIMIT(0, CORBA::COMPLETED_NO);
  }
  return MakeNames<LMS3D::SceneNames>(names);
}

LMS3D::PresetNames* lms3dMakePresetNames()
{
  return MakeNames<LMS3D::PresetNames>(lms3dGetPresetNames());
}

void lms3dCheckPart(std::size_t items, std::size_t bytes, CORBA::ULong first, CORBA::ULong count)
{
  if (CORBA::ULongLong(first) + count > items)
  {
    throw LMS3D::InvalidArgument(lms3dMakeText("there are " + std::to_string(items) +
      " items, but first + count is " + std::to_string(CORBA::ULongLong(first) + count)));
  }
  const CORBA::ULongLong maximum = lms3dGetMaximumElements(bytes);
  if (count > maximum)
  {
    throw LMS3D::LimitExceeded(
      lms3dMakeText(std::to_string(count) + " do not fit into a message; fetch parts"), maximum);
  }
}

void lms3dCheckMessage(
  CORBA::ULongLong bytes, const std::string& subject, const std::string& operations)
{
  const CORBA::ULongLong maximum = lms3dGetMaximumElements(1);
  if (bytes > maximum)
  {
    throw LMS3D::LimitExceeded(
      lms3dMakeText(subject + " " + std::to_string(bytes) +
        " bytes, which do not fit into a message; fetch parts with " + operations),
      maximum);
  }
}

LMS3D::LocalMap* lms3dMakeLocalMap(const lms3dSnapshot& snapshot)
{
  lms3dCheckMessage(snapshot.MapPoints.size() * sizeof(CORBA::Double) +
      snapshot.MapTriangles.size() * sizeof(CORBA::ULong),
    "the map has", "getMapPoints() and getMapTriangles()");
  LMS3D::LocalMap_var map = new LMS3D::LocalMap;
  map->header = snapshot.Header;
  Copy(snapshot.MapPoints, map->points);
  Copy(snapshot.MapTriangles, map->triangles);
  return map._retn();
}
