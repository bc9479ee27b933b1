// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dRegroupingPlace.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace
{
// For each old plane the first one of its part.
std::vector<std::size_t> FindFirstPlanes(const lms3dRegroupingPlace& place)
{
  std::vector<std::size_t> firsts(place.OldPlanes.size());
  std::iota(firsts.begin(), firsts.end(), std::size_t{ 0 });
  const auto find = [&](std::size_t plane)
  {
    while (firsts[plane] != plane)
    {
      plane = firsts[plane];
    }
    return plane;
  };
  for (const lms3dReturnGroup& group : place.Groups)
  {
    for (const int i : group.Returns)
    {
      const std::size_t a = find(place.OwnerOf[group.Returns.front()]);
      const std::size_t b = find(place.OwnerOf[i]);
      firsts[std::max(a, b)] = std::min(a, b);
    }
  }
  std::transform(firsts.begin(), firsts.end(), firsts.begin(), find);
  return firsts;
}
} // namespace

void lms3dRegroupingPlace::AddOldPlane(int number, const std::vector<lms3dMappedReturn>& returns)
{
  this->OwnerOf.insert(this->OwnerOf.end(), returns.size(), this->OldPlanes.size());
  this->OldPlanes.push_back(number);
  this->Returns.insert(this->Returns.end(), returns.begin(), returns.end());
}

void lms3dRegroupingPlace::FindLeft()
{
  std::vector<bool> isGrouped(this->Returns.size());
  for (const lms3dReturnGroup& group : this->Groups)
  {
    for (const int i : group.Returns)
    {
      isGrouped[i] = true;
    }
  }
  for (std::size_t i = 0; i < isGrouped.size(); ++i)
  {
    if (!isGrouped[i])
    {
      this->Left.push_back(static_cast<int>(i));
    }
  }
}

std::vector<lms3dRegroupingPlace> lms3dRegroupingPlace::Split() const
{
  const std::vector<std::size_t> firsts = FindFirstPlanes(*this);
  std::vector<lms3dRegroupingPlace> parts(this->OldPlanes.size());
  std::vector<std::size_t> numberInPart;
  for (std::size_t i = 0; i < this->OldPlanes.size(); ++i)
  {
    numberInPart.push_back(parts[firsts[i]].OldPlanes.size());
    parts[firsts[i]].OldPlanes.push_back(this->OldPlanes[i]);
  }
  std::vector<int> placeInPart;
  for (std::size_t i = 0; i < this->Returns.size(); ++i)
  {
    lms3dRegroupingPlace& part = parts[firsts[this->OwnerOf[i]]];
    placeInPart.push_back(static_cast<int>(part.Returns.size()));
    part.Returns.push_back(this->Returns[i]);
    part.OwnerOf.push_back(numberInPart[this->OwnerOf[i]]);
  }
  for (lms3dReturnGroup group : this->Groups)
  {
    lms3dRegroupingPlace& part = parts[firsts[this->OwnerOf[group.Returns.front()]]];
    for (int& i : group.Returns)
    {
      i = placeInPart[i];
    }
    part.Groups.push_back(std::move(group));
  }
  for (const int i : this->Left)
  {
    parts[firsts[this->OwnerOf[i]]].Left.push_back(placeInPart[i]);
  }
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                [](const lms3dRegroupingPlace& part) { return part.OldPlanes.empty(); }),
    parts.end());
  return parts;
}
