// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Results of operations in the IDL's types, within the size of a message.
 */
#ifndef lms3dReplies_h
#define lms3dReplies_h

#include "Common/lms3dMessageLimit.h"
#include "LMS3DScanner.hh"
#include "Scanning/lms3dSceneCatalogue.h"
#include "Scanning/lms3dSnapshotStore.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

/// A copy of `text` within the bound of LMS3D::Text, in printable ASCII, which every ORB accepts.
CORBA::String_var lms3dMakeText(const std::string& text);

/// The names of all scenes. The caller owns the result. Throws CORBA::IMP_LIMIT if they do not fit
/// into a message.
LMS3D::SceneNames* lms3dMakeSceneNames(const lms3dSceneCatalogue& catalogue);

/// The names of all presets. The caller owns the result.
LMS3D::PresetNames* lms3dMakePresetNames();

/// The local map of a scan. The caller owns the result. Throws LMS3D::LimitExceeded if it does not
/// fit into a message.
LMS3D::LocalMap* lms3dMakeLocalMap(const lms3dSnapshot& snapshot);

/// Throws LMS3D::InvalidArgument if there are fewer than `first` + `count` items,
/// LMS3D::LimitExceeded if `count` items of `bytes` bytes do not fit into a message.
void lms3dCheckPart(std::size_t items, std::size_t bytes, CORBA::ULong first, CORBA::ULong count);

/// Throws LMS3D::LimitExceeded if `bytes` do not fit into a message. The reason begins with
/// `subject`, a noun and its verb, and names the `operations` that return parts.
void lms3dCheckMessage(
  CORBA::ULongLong bytes, const std::string& subject, const std::string& operations);

/**
 * A sequence of `count` items from item `first` on, each of `width` elements of `all`. The caller
 * owns the result. Throws LMS3D::InvalidArgument if `all` has fewer items, LMS3D::LimitExceeded if
 * they do not fit into a message.
 */
template <typename Sequence, typename Element>
Sequence* lms3dMakePart(
  const std::vector<Element>& all, CORBA::ULong width, CORBA::ULong first, CORBA::ULong count)
{
  lms3dCheckPart(all.size() / width, width * sizeof(Element), first, count);
  // Filling a sequence element by element takes several times as long.
  const CORBA::ULong length = width * count;
  Element* buffer = Sequence::allocbuf(length);
  std::copy_n(all.begin() + std::size_t(width) * first, length, buffer);
  return new Sequence(length, length, buffer, true);
}

#endif
