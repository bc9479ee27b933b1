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

// The positions in the reachable part of a gate, beside the preferred one, from which a vertex can
// start.
constexpr double Candidates[] = { 0.02, 0.98 };

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

/// The directions from an apex that pass all gates so far: between a point to the left and a point
/// to the right.
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

  /// Keeps the part of a gate that the wedge covers.
  Gate Clip(const Gate& gate) const
  {
    Gate part = gate;
    part.Low = std::max(gate.Low, this->GetCrossing(gate, this->Left));
    part.High = std::min(gate.High, this->GetCrossing(gate, this->Right));
    if (part.Low > part.High)
    {
      part.Low = std::min(gate.High, std::max(gate.Low, 0.5 * (part.Low + part.High)));
      part.High = part.Low;
    }
    part.Best = std::min(part.High, std::max(part.Low, gate.Best));
    return part;
  }
};

/// The part of the path's gates that lies ahead. Numbers count from `Shift` on and wrap around.
struct lms3dMinimumLinkPath::Rest
{
  int First;
  int Count;
  int Shift;
  lms3dVector End;
};

/// How far one arc reaches.
struct lms3dMinimumLinkPath::Reach
{
  /// The number of the last gate that the arc passes, or the number of all gates if it reaches the
  /// end.
  int Gate;
  /// The part of this gate that arcs from the apex reach.
  lms3dMinimumLinkPath::Gate Part;
};

lms3dMinimumLinkPath::Reach lms3dMinimumLinkPath::FindReach(
  const lms3dVector& apex, const Rest& rest) const
{
  const int size = static_cast<int>(this->Gates.size());
  const auto gate = [&](int i) -> const Gate& { return this->Gates[(i + rest.Shift) % size]; };
  Wedge wedge{ apex };
  for (int i = rest.First; i < rest.Count; ++i)
  {
    const lms3dVector left = gate(i).GetPoint(gate(i).Low);
    const lms3dVector right = gate(i).GetPoint(gate(i).High);
    const bool isFar = IsFar(apex, left) || IsFar(apex, right);
    if (i > rest.First && (isFar || !wedge.Narrow(left, right)))
    {
      return { i - 1, wedge.Clip(gate(i - 1)) };
    }
    if (i == rest.First)
    {
      wedge.Narrow(left, right);
    }
  }
  const bool reachesEnd =
    rest.First >= rest.Count || (!IsFar(apex, rest.End) && wedge.Narrow(rest.End, rest.End));
  return reachesEnd ? Reach{ rest.Count, {} }
                    : Reach{ rest.Count - 1, wedge.Clip(gate(rest.Count - 1)) };
}

// Chooses the vertex in a gate from which the next arc reaches farthest, and follows this arc.
lms3dMinimumLinkPath::Vertex lms3dMinimumLinkPath::Bend(Reach& reach, const Rest& rest) const
{
  const Reach from = reach;
  Vertex best = { from.Gate, from.Part.Best };
  const Rest ahead = { from.Gate + 1, rest.Count, rest.Shift, rest.End };
  reach = this->FindReach(from.Part.GetPoint(best.At), ahead);
  for (double share : Candidates)
  {
    const double at = from.Part.Low + share * (from.Part.High - from.Part.Low);
    const Reach next = this->FindReach(from.Part.GetPoint(at), ahead);
    if (next.Gate > reach.Gate)
    {
      best.At = at;
      reach = next;
    }
  }
  return best;
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
  this->Append(apex, { first, count, 0, hasLast ? getBest(count) : end }, path);
  if (hasLast)
  {
    path.push_back({ count, this->Gates[count].Best });
  }
  return path;
}

// Appends the vertices from an apex through the rest of the gates.
void lms3dMinimumLinkPath::Append(
  const lms3dVector& apex, const Rest& rest, std::vector<Vertex>& path) const
{
  const int size = static_cast<int>(this->Gates.size());
  Reach reach = this->FindReach(apex, rest);
  while (reach.Gate < rest.Count)
  {
    const Vertex vertex = this->Bend(reach, rest);
    path.push_back({ (vertex.Gate + rest.Shift) % size, vertex.At });
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
  const Reach reach = this->FindReach(origin, { 1, count, 0, origin });
  const Vertex first =
    reach.Gate < count ? Vertex{ reach.Gate, reach.Part.Best } : Vertex{ 0, this->Gates[0].Best };
  const lms3dVector start = this->Gates[first.Gate].GetPoint(first.At);
  std::vector<Vertex> path = { first };
  this->Append(start, { 1, count, first.Gate, start }, path);
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
