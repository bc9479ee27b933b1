// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Neighbouring planes of a fused map whose returns are grouped anew.
 */
#ifndef lms3dRegroupingPlace_h
#define lms3dRegroupingPlace_h

#include "Fusion/Scans/lms3dLocalMap.h"
#include "Fusion/Scans/lms3dReturnGroups.h"

#include <cstddef>
#include <vector>

struct lms3dRegroupingPlace
{
  /// Adds an old plane with its returns.
  void AddOldPlane(int number, const std::vector<lms3dMappedReturn>& returns);

  void FindLeft();

  /// Splits the place into parts that can be replaced on their own: an old plane and a group are in
  /// the same part if they have a return in common. The order stays. To be called before there are
  /// new planes.
  std::vector<lms3dRegroupingPlace> Split() const;

  std::vector<int> OldPlanes;
  std::vector<lms3dMappedReturn> Returns;
  /// For each return the place of its plane among the old ones.
  std::vector<std::size_t> OwnerOf;
  std::vector<lms3dReturnGroup> Groups;
  /// The planes of the groups, which may take the place of the old ones.
  std::vector<int> NewPlanes;
  /// The returns without a group.
  std::vector<int> Left;
};

#endif
