// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dOutlineCorners.h"

#include <utility>

lms3dOutlineCorners::lms3dOutlineCorners(
  const std::vector<lms3dLoop>& loops, std::vector<bool> isFixed)
  : Fixed(std::move(isFixed))
  , Ends({ 0 })
{
  for (const lms3dLoop& loop : loops)
  {
    const Corner first = this->Ends.back();
    const auto size = static_cast<Corner>(loop.size());
    this->Points.insert(this->Points.end(), loop.begin(), loop.end());
    for (Corner i = 0; i < size; ++i)
    {
      this->Next.push_back(first + (i + 1) % size);
      this->Previous.push_back(first + (i + size - 1) % size);
    }
    this->Ends.push_back(first + size);
  }
  this->Gone.assign(this->Points.size(), false);
  this->FirstPoints = this->Points;
  this->FirstNext = this->Next;
}

void lms3dOutlineCorners::Remove(Corner corner)
{
  this->Gone[corner] = true;
  this->Next[this->Previous[corner]] = this->Next[corner];
  this->Previous[this->Next[corner]] = this->Previous[corner];
}

std::vector<lms3dLoop> lms3dOutlineCorners::GetLoops() const
{
  std::vector<lms3dLoop> loops;
  for (std::size_t i = 0; i + 1 < this->Ends.size(); ++i)
  {
    lms3dLoop loop;
    for (Corner corner = this->Ends[i]; corner < this->Ends[i + 1]; ++corner)
    {
      if (!this->Gone[corner])
      {
        loop.push_back(this->Points[corner]);
      }
    }
    loops.push_back(loop);
  }
  return loops;
}
