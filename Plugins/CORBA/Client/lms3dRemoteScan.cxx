// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRemoteScan.h"

#include "lms3dMessageLimit.h"
#include "lms3dRemoteCheck.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace
{
void RequireLength(CORBA::ULong length, CORBA::ULong expected)
{
  if (length != expected)
  {
    throw std::runtime_error("the server sends " + std::to_string(length) +
      " numbers in place of " + std::to_string(expected));
  }
}

// `ask(first, count)` is one message's items, of `width` elements each. The server's limit may be
// lower than the client's, which it then tells.
template <typename Sequence, typename Element, typename Ask>
void FetchAll(CORBA::ULong total, CORBA::ULong width, const std::function<void()>& beforePart,
  const Ask& ask, std::vector<Element>& elements)
{
  CORBA::ULongLong most = lms3dGetMostElements(width * sizeof(Element));
  for (CORBA::ULong first = 0; first < total;)
  {
    const auto count = static_cast<CORBA::ULong>(std::min<CORBA::ULongLong>(most, total - first));
    beforePart();
    try
    {
      const typename Sequence::_var_type part = ask(first, count);
      RequireLength(part->length(), count * width);
      elements.insert(elements.end(), part->get_buffer(), part->get_buffer() + part->length());
      first += count;
    }
    catch (const LMS3D::LimitExceeded& limit)
    {
      if (limit.limit == 0 || limit.limit >= count)
      {
        throw;
      }
      most = limit.limit;
    }
  }
}
} // namespace

lms3dRemoteScan lms3dFetchScan(LMS3D::LaserScanner_ptr scanner, const LMS3D::ScanHeader& header,
  const std::function<void()>& beforePart)
{
  lms3dCheckHeader(header);
  lms3dRemoteScan scan;
  scan.Header = header;
  const CORBA::ULongLong number = header.number;
  FetchAll<LMS3D::Ranges>(
    header.beams, 1, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getRanges(number, first, count); },
    scan.Ranges);
  FetchAll<LMS3D::Coordinates>(
    header.mapPoints, 3, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getMapPoints(number, first, count); },
    scan.MapPoints);
  FetchAll<LMS3D::Indices>(
    header.mapTriangles, 3, beforePart,
    [&](CORBA::ULong first, CORBA::ULong count)
    { return scanner->getMapTriangles(number, first, count); },
    scan.MapTriangles);
  lms3dCheckArrays(scan);
  return scan;
}
