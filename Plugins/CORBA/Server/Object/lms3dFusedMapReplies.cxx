// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Object/lms3dFusedMapReplies.h"

#include "Common/lms3dChecksum.h"
#include "Object/lms3dReplies.h"

#include <algorithm>
#include <cstddef>

namespace
{
// Elements of a point, and of a triangle.
constexpr std::size_t Width = 3;

static_assert(sizeof(LMS3D::FusedRegion) == 3 * sizeof(CORBA::ULong), "regions have no gaps");

LMS3D::FusedRegion Describe(const lms3dFusedRegion& region)
{
  return { region.Id, static_cast<CORBA::ULong>(region.Points.size() / Width),
    static_cast<CORBA::ULong>(region.Triangles.size() / Width) };
}

// `member` is Points or Triangles of a region.
template <typename Element>
std::size_t CountItems(
  const lms3dFusedRegions& changes, std::vector<Element> lms3dFusedRegion::*member)
{
  std::size_t elements = 0;
  for (const auto& region : changes)
  {
    elements += ((*region).*member).size();
  }
  return elements / Width;
}

template <typename Element>
std::uint32_t AddToChecksum(const lms3dFusedRegions& changes,
  std::vector<Element> lms3dFusedRegion::*member, std::uint32_t checksum)
{
  for (const auto& region : changes)
  {
    const std::vector<Element>& elements = (*region).*member;
    checksum = lms3dContinueChecksum(checksum, elements.data(), elements.size() * sizeof(Element));
  }
  return checksum;
}

// Does not join the regions first, which would copy all of them for a small part.
template <typename Sequence, typename Element>
Sequence* MakePart(const lms3dFusedRegions& changes, std::vector<Element> lms3dFusedRegion::*member,
  CORBA::ULong first, CORBA::ULong count)
{
  lms3dCheckPart(CountItems(changes, member), Width * sizeof(Element), first, count);
  const CORBA::ULong length = Width * count;
  Element* const buffer = Sequence::allocbuf(length);
  std::size_t skip = Width * std::size_t(first);
  std::size_t done = 0;
  for (const auto& region : changes)
  {
    const std::vector<Element>& elements = (*region).*member;
    const std::size_t skipped = std::min(skip, elements.size());
    const std::size_t taken = std::min<std::size_t>(elements.size() - skipped, length - done);
    std::copy_n(elements.data() + skipped, taken, buffer + done);
    skip -= skipped;
    done += taken;
  }
  return new Sequence(length, length, buffer, true);
}

// Moves the elements of a part into a member of an answer.
template <typename Sequence>
void Move(Sequence* part, Sequence& member)
{
  typename Sequence::_var_type owned = part;
  const CORBA::ULong length = owned->length();
  member.replace(length, length, owned->get_buffer(true), true);
}
} // namespace

LMS3D::FusedMapHeader lms3dMakeFusedMapHeader(
  const lms3dFusedMapState& state, CORBA::ULongLong since, const lms3dFusedRegions& changes)
{
  LMS3D::FusedMapHeader header = state.Header;
  header.since = since;
  header.isWhole = state.IsWhole(since);
  header.regions = static_cast<CORBA::ULong>(changes.size());
  header.points = static_cast<CORBA::ULong>(CountItems(changes, &lms3dFusedRegion::Points));
  header.triangles = static_cast<CORBA::ULong>(CountItems(changes, &lms3dFusedRegion::Triangles));
  std::uint32_t checksum = 0;
  for (const auto& region : changes)
  {
    const LMS3D::FusedRegion description = Describe(*region);
    checksum = lms3dContinueChecksum(checksum, &description, sizeof(description));
  }
  checksum = AddToChecksum(changes, &lms3dFusedRegion::Points, checksum);
  header.checksum = AddToChecksum(changes, &lms3dFusedRegion::Triangles, checksum);
  return header;
}

LMS3D::FusedRegions* lms3dMakeFusedRegions(
  const lms3dFusedRegions& changes, CORBA::ULong first, CORBA::ULong count)
{
  lms3dCheckPart(changes.size(), sizeof(LMS3D::FusedRegion), first, count);
  LMS3D::FusedRegion* const buffer = LMS3D::FusedRegions::allocbuf(count);
  const auto begin = changes.begin() + static_cast<std::ptrdiff_t>(first);
  std::transform(begin, begin + static_cast<std::ptrdiff_t>(count), buffer,
    [](const auto& region) { return Describe(*region); });
  return new LMS3D::FusedRegions(count, count, buffer, true);
}

LMS3D::Offsets* lms3dMakeFusedPoints(
  const lms3dFusedRegions& changes, CORBA::ULong first, CORBA::ULong count)
{
  return MakePart<LMS3D::Offsets>(changes, &lms3dFusedRegion::Points, first, count);
}

LMS3D::Indices* lms3dMakeFusedTriangles(
  const lms3dFusedRegions& changes, CORBA::ULong first, CORBA::ULong count)
{
  return MakePart<LMS3D::Indices>(changes, &lms3dFusedRegion::Triangles, first, count);
}

LMS3D::FusedMap* lms3dMakeFusedMap(
  const LMS3D::FusedMapHeader& header, const lms3dFusedRegions& changes)
{
  const CORBA::ULongLong items =
    CORBA::ULongLong(header.regions) + header.points + header.triangles;
  lms3dCheckMessage(items * Width * sizeof(CORBA::ULong), "the changes have",
    "getFusedRegions(), getFusedPoints() and getFusedTriangles()");
  LMS3D::FusedMap_var map = new LMS3D::FusedMap;
  map->header = header;
  Move(lms3dMakeFusedRegions(changes, 0, header.regions), map->regions);
  Move(lms3dMakeFusedPoints(changes, 0, header.points), map->points);
  Move(lms3dMakeFusedTriangles(changes, 0, header.triangles), map->triangles);
  return map._retn();
}
