// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Fetches arrays that are larger than a message.
 */
#ifndef lms3dFetchParts_h
#define lms3dFetchParts_h

#include "Common/lms3dMessageLimit.h"
#include "LMS3DScanner.hh"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

/**
 * Appends `total` items, each of `width` elements, to `elements`, in as many messages as necessary.
 * `fetch(first, count)` returns the items of one message. If the server's limit is lower than the
 * client's, its exception contains the limit. Calls `beforePart` before each message. Throws
 * std::runtime_error if a message has another length, and what `fetch` and `beforePart` throw.
 */
template <typename Sequence, typename Element, typename Fetch>
void lms3dFetchParts(CORBA::ULong total, CORBA::ULong width,
  const std::function<void()>& beforePart, const Fetch& fetch, std::vector<Element>& elements)
{
  CORBA::ULongLong maximum = lms3dGetMaximumElements(width * sizeof(Element));
  for (CORBA::ULong first = 0; first < total;)
  {
    const auto count =
      static_cast<CORBA::ULong>(std::min<CORBA::ULongLong>(maximum, total - first));
    beforePart();
    try
    {
      const typename Sequence::_var_type part = fetch(first, count);
      if (part->length() != count * width)
      {
        throw std::runtime_error("the server sends " + std::to_string(part->length()) +
          " numbers instead of " + std::to_string(count * width));
      }
      elements.insert(elements.end(), part->get_buffer(), part->get_buffer() + part->length());
      first += count;
    }
    catch (const LMS3D::LimitExceeded& limit)
    {
      if (limit.limit == 0 || limit.limit >= count)
      {
        throw;
      }
      maximum = limit.limit;
    }
  }
}

#endif
