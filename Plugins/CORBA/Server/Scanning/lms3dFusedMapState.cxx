// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scanning/lms3dFusedMapState.h"

#include <algorithm>
#include <iterator>

bool lms3dFusedMapState::IsWhole(std::uint64_t since) const
{
  const LMS3D::FusedMapHeader& header = this->Header;
  return since < header.firstNumber || since > header.number || header.number - since > Memory;
}

lms3dFusedRegions lms3dFusedMapState::GetChanges(std::uint64_t since) const
{
  const bool isWhole = this->IsWhole(since);
  lms3dFusedRegions changes;
  std::copy_if(this->Regions.begin(), this->Regions.end(), std::back_inserter(changes),
    [isWhole, since](const auto& region)
    { return isWhole ? !region->IsRemoved() : region->Changed > since; });
  return changes;
}

std::size_t lms3dFusedMapState::GetBytes() const
{
  std::size_t bytes = this->Regions.size() * sizeof(this->Regions.front());
  for (const auto& region : this->Regions)
  {
    bytes += region->Changed == this->Header.number ? region->GetBytes() : 0;
  }
  return bytes;
}
