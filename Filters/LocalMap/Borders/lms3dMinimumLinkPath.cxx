// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dMinimumLinkPath.h"

#include <algorithm>
#include <cmath>

namespace
{
// The cosine of the longest arc. An arc of half a circle or more would turn round.
constexpr double MinimumCosine = 0.5;

// How far a vertex in the middle moves towards the left end of its gate.
constexpr double LeftOfMiddle = 0.25;

// Positive where c lies left of the arc from a to b, as the sensor sees it.
double GetTurn(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  return -lms3dDot(lms3dCross(a, b), c);
}

bool IsFar(const lms3dVector& a, const lms3dVector& b)
{
  const double product = lms3dDot(a, b);
  return product <= 0.0 ||
    product * product < MinimumCosine * MinimumCosine * lms3dDot(a, a) * lms3dDot(b, b);
}
} // namespace

/// The directions from an apex that pass all gates so far: between a point to the left and a point to
/// the right.
struct lms3dMinimumLinkPath::Wedge
{
  lms3dVector Apex;
  lms3dVector Left = { 0.0, 0.0, 0.0 };
  lms3dVector Right = { 0.0, 0.0, 0.0 };
  bool IsOpen = false;

  /// Intersects the wedge with a gate. Returns false and changes nothing if no direction remains.
  bool Narrow(const lms3dVector& left, const lms3dVector& right)
  {
    if (!this->IsOpen)
    {
      this->Left = left;
      this->Right = right;
      this->IsOpen = true;
      return true;
    }
    if (GetTurn(this->Apex, this->Right, left) < 0.0 ||
      GetTurn(this->Apex, this->Left, right) > 0.0)
    {
      return false;
    }
    if (GetTurn(this->Apex, this->Left, left) < 0.0)
    {
      this->Left = left;
    }
    if (GetTurn(this->Apex, this->Right, right) > 0.0)
    {
      this->Right = right;
    }
    return true;
  }

  /// The position at which the arc from the apex to a point passes a gate.
  double GetCrossing(const Gate& gate, const lms3dVector& point) const
  {
    const lms3dVector normal = lms3dCross(this->Apex, point);
    const double left = lms3dDot(normal, gate.Left);
    const double right = lms3dDot(normal, gate.Right);
    return left == right ? gate.Best : left / (left - right);
  }

  double GetBest(const Gate& gate) const
  {
    const double low = std::max(gate.Low, this->GetCrossing(gate, this->Left));
    const double high = std::min(gate.High, this->GetCrossing(gate, this->Right));
    if (low > high)
    {
      return std::min(gate.High, std::max(gate.Low, 0.5 * (low + high)));
    }
    return std::min(high, std::max(low, gate.Best));
  }
};

// The next vertex from an apex. Gate numbers count from `shift` on and wrap around.
lms3dMinimumLinkPath::Vertex lms3dMinimumLinkPath::FindNext(const lms3dVector& apex, int first,
  int count, int shift, const lms3dVector& end, bool& reachesEnd) const
{
  const int size = static_cast<int>(this->Gates.size());
  const auto gate = [&](int i) -> const Gate& { return this->Gates[(i + shift) % size]; };
  Wedge wedge{ apex };
  reachesEnd = false;
  for (int i = first; i < count; ++i)
  {
    const lms3dVector left = gate(i).GetPoint(gate(i).Low);
    const lms3dVector right = gate(i).GetPoint(gate(i).High);
    const bool isFar = IsFar(apex, left) || IsFar(apex, right);
    if (i > first && (isFar || !wedge.Narrow(left, right)))
    {
      return { i - 1, wedge.GetBest(gate(i - 1)) };
    }
    if (i == first)
    {
      wedge.Narrow(left, right);
    }
  }
  reachesEnd = first >= count || (!IsFar(apex, end) && wedge.Narrow(end, end));
  return reachesEnd ? Vertex{ count, 0.0 } : Vertex{ count - 1, wedge.GetBest(gate(count - 1)) };
}

std::vector<lms3dMinimumLinkPath::Vertex> lms3dMinimumLinkPath::Straighten(
  const lms3dVector& start, const lms3dVector& end, bool bendsInFirst, bool bendsInLast) const
{
  const int size = static_cast<int>(this->Gates.size());
  const auto getBest = [&](int i) { return this->Gates[i].GetPoint(this->Gates[i].Best); };
  std::vector<Vertex> path;
  int first = 0;
  lms3dVector apex = start;
  if (bendsInFirst)
  {
    path.push_back({ 0, this->Gates[0].Best });
    apex = getBest(0);
    first = 1;
  }
  const bool hasLast = bendsInLast && first < size;
  const int count = hasLast ? size - 1 : size;
  this->Append(apex, first, count, hasLast ? getBest(count) : end, path);
  if (hasLast)
  {
    path.push_back({ count, this->Gates[count].Best });
  }
  return path;
}

// Appends the vertices from an apex through the gates from `first` to before `count`.
void lms3dMinimumLinkPath::Append(
  lms3dVector apex, int first, int count, const lms3dVector& end, std::vector<Vertex>& path) const
{
  bool reachesEnd = false;
  while (true)
  {
    const Vertex vertex = this->FindNext(apex, first, count, 0, end, reachesEnd);
    if (reachesEnd)
    {
      return;
    }
    path.push_back(vertex);
    apex = this->Gates[vertex.Gate].GetPoint(vertex.At);
    first = vertex.Gate + 1;
  }
}

lms3dMinimumLinkPath::Vertex lms3dMinimumLinkPath::GetMiddle(
  const lms3dVector& start, const lms3dVector& end) const
{
  const int middle = static_cast<int>(this->Gates.size()) / 2;
  const Gate& gate = this->Gates[middle];
  const Wedge wedge{ start, end, end, true };
  const double at = std::min(gate.High, std::max(gate.Low, wedge.GetCrossing(gate, end)));
  return { middle, at + LeftOfMiddle * (gate.Low - at) };
}

// Starts from the first bend of a path that begins in the first gate, so that no vertex is wasted.
std::vector<lms3dMinimumLinkPath::Vertex> lms3dMinimumLinkPath::StraightenClosed() const
{
  const int count = static_cast<int>(this->Gates.size());
  const lms3dVector origin = this->Gates[0].GetPoint(this->Gates[0].Best);
  bool reachesEnd;
  Vertex vertex = this->FindNext(origin, 1, count, 0, origin, reachesEnd);
  vertex = reachesEnd ? Vertex{ 0, this->Gates[0].Best } : vertex;

  const int shift = vertex.Gate;
  const lms3dVector start = this->Gates[shift].GetPoint(vertex.At);
  std::vector<Vertex> path = { vertex };
  lms3dVector apex = start;
  int first = 1;
  while (true)
  {
    vertex = this->FindNext(apex, first, count, shift, start, reachesEnd);
    if (reachesEnd)
    {
      break;
    }
    first = vertex.Gate + 1;
    vertex.Gate = (vertex.Gate + shift) % count;
    apex = this->Gates[vertex.Gate].GetPoint(vertex.At);
    path.push_back(vertex);
  }
  if (path.size() < 3)
  {
    path.clear();
    for (int i = 0; i < count; ++i)
    {
      path.push_back({ i, this->Gates[i].Best });
    }
  }
  return path;
}
