// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The corners of outlines that may go, in the order in which they go.
 */
#ifndef lms3dCornerCandidates_h
#define lms3dCornerCandidates_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

struct lms3dCornerCandidate
{
  double Cost;
  std::int32_t Number;
  int Version;
  /// Whether another candidate goes before this one.
  bool operator<(const lms3dCornerCandidate& other) const
  {
    return this->Cost != other.Cost ? this->Cost > other.Cost : this->Number > other.Number;
  }
};

/// The candidates at the start are sorted once; a heap has those that come later.
class lms3dCornerCandidates
{
public:
  void AddFirst(const lms3dCornerCandidate& candidate) { this->First.push_back(candidate); }

  /// To be called after AddFirst() and before TakeNext().
  void SortFirst()
  {
    std::sort(this->First.begin(), this->First.end(),
      [](const lms3dCornerCandidate& a, const lms3dCornerCandidate& b) { return b < a; });
  }

  void Add(const lms3dCornerCandidate& candidate) { this->Later.push(candidate); }

  bool IsEmpty() const { return this->NextOfFirst == this->First.size() && this->Later.empty(); }

  lms3dCornerCandidate TakeNext()
  {
    if (this->NextOfFirst < this->First.size() &&
      (this->Later.empty() || this->Later.top() < this->First[this->NextOfFirst]))
    {
      return this->First[this->NextOfFirst++];
    }
    const lms3dCornerCandidate candidate = this->Later.top();
    this->Later.pop();
    return candidate;
  }

private:
  std::vector<lms3dCornerCandidate> First;
  std::size_t NextOfFirst = 0;
  std::priority_queue<lms3dCornerCandidate> Later;
};

#endif
