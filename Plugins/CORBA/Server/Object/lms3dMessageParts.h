// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Parts of a scan that fit into a message.
 */
#ifndef lms3dMessageParts_h
#define lms3dMessageParts_h

#include "LMS3DScanner.hh"
#include "lms3dMessageLimit.h"
#include "lms3dText.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

/**
 * A sequence of `count` items from item `first` on, where an item is `width` elements. Throws
 * LMS3D::InvalidArgument where there are not so many, LMS3D::LimitExceeded where they do not fit.
 */
template <typename Sequence, typename Element>
Sequence* lms3dMakePart(
  const std::vector<Element>& all, CORBA::ULong width, CORBA::ULong first, CORBA::ULong count)
{
  const CORBA::ULongLong items = all.size() / width;
  if (CORBA::ULongLong(first) + count > items)
  {
    throw LMS3D::InvalidArgument(lms3dText("there are " + std::to_string(items) +
      ", not those up to " + std::to_string(CORBA::ULongLong(first) + count)));
  }
  const CORBA::ULongLong most = lms3dGetMostElements(width * sizeof(Element));
  if (count > most)
  {
    throw LMS3D::LimitExceeded(
      lms3dText(std::to_string(count) + " do not fit into a message; ask for parts"), most);
  }
  // Element by element, as sequences otherwise are filled, takes several times as long.
  const CORBA::ULong length = width * count;
  Element* buffer = Sequence::allocbuf(length);
  std::copy_n(all.begin() + std::size_t(width) * first, length, buffer);
  return new Sequence(length, length, buffer, true);
}

#endif
