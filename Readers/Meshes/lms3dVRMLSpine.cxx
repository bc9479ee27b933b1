// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes/lms3dVRMLSpine.h"

#include <algorithm>
#include <cstddef>

namespace
{
bool IsZero(const lms3dVector& a)
{
  return a[0] == 0.0 && a[1] == 0.0 && a[2] == 0.0;
}

/// Requires that consecutive points differ.
class Spine
{
public:
  explicit Spine(const std::vector<lms3dVector>& points)
    : Points(points)
    , Last(points.size() - 1)
    , IsClosed(points.size() > 1 && points.front() == points.back())
  {
  }

  std::vector<lms3dSpineFrame> MakeFrames() const
  {
    std::vector<lms3dVector> y = this->GetTangents();
    std::vector<lms3dVector> z = this->GetNormals();
    if (std::all_of(z.begin(), z.end(), IsZero))
    {
      this->MakeStraight(y, z);
    }
    FillZeros(y);
    FillZeros(z);
    TurnToOneSide(z);
    std::vector<lms3dSpineFrame> frames;
    for (std::size_t i = 0; i <= this->Last; ++i)
    {
      const lms3dVector x = lms3dNormalize(lms3dCross(y[i], z[i]));
      frames.push_back({ x, y[i], lms3dCross(x, y[i]) });
    }
    return frames;
  }

private:
  lms3dVector GetStep(std::size_t from, std::size_t to) const
  {
    return lms3dSubtract(this->Points[to], this->Points[from]);
  }

  // The two ends of a closed spine are one point, with the same neighbours.
  std::size_t GetBefore(std::size_t i) const
  {
    return i > 0 ? i - 1 : this->IsClosed ? this->Last - 1 : 0;
  }
  std::size_t GetAfter(std::size_t i) const
  {
    return i < this->Last ? i + 1 : this->IsClosed ? 1 : this->Last;
  }

  // Replaces each zero vector by its predecessor, and leading zero vectors by the first nonzero
  // one.
  static void FillZeros(std::vector<lms3dVector>& vectors)
  {
    const auto first = std::find_if_not(vectors.begin(), vectors.end(), IsZero);
    lms3dVector last = first == vectors.end() ? lms3dVector{ 0, 1, 0 } : *first;
    for (lms3dVector& vector : vectors)
    {
      vector = IsZero(vector) ? last : vector;
      last = vector;
    }
  }

  std::vector<lms3dVector> GetTangents() const
  {
    std::vector<lms3dVector> tangents;
    for (std::size_t i = 0; i <= this->Last; ++i)
    {
      tangents.push_back(lms3dNormalize(this->GetStep(this->GetBefore(i), this->GetAfter(i))));
    }
    return tangents;
  }

  // Perpendicular to the plane of the bend; zero at points without a bend.
  std::vector<lms3dVector> GetNormals() const
  {
    std::vector<lms3dVector> normals;
    for (std::size_t i = 0; i <= this->Last; ++i)
    {
      const lms3dVector normal =
        lms3dCross(this->GetStep(i, this->GetAfter(i)), this->GetStep(i, this->GetBefore(i)));
      normals.push_back(this->IsBend(i, normal) ? lms3dNormalize(normal) : lms3dVector{ 0, 0, 0 });
    }
    return normals;
  }

  static void TurnToOneSide(std::vector<lms3dVector>& normals)
  {
    for (std::size_t i = 1; i < normals.size(); ++i)
    {
      if (lms3dDot(normals[i], normals[i - 1]) < 0.0)
      {
        normals[i] = lms3dScale(normals[i], -1.0);
      }
    }
  }

  // A straight spine has one frame for all points, also if it reverses its direction.
  void MakeStraight(std::vector<lms3dVector>& tangents, std::vector<lms3dVector>& normals) const
  {
    const lms3dVector direction =
      this->Last > 0 ? lms3dNormalize(this->GetStep(0, 1)) : lms3dVector{ 0, 1, 0 };
    std::fill(tangents.begin(), tangents.end(), direction);
    std::fill(normals.begin(), normals.end(), TurnZWith(direction));
  }

  // A bend of the size of rounding errors does not count.
  bool IsBend(std::size_t i, const lms3dVector& normal) const
  {
    const lms3dVector after = this->GetStep(i, this->GetAfter(i));
    const lms3dVector before = this->GetStep(i, this->GetBefore(i));
    constexpr double rounding = 1e-14;
    return lms3dDot(normal, normal) > rounding * lms3dDot(after, after) * lms3dDot(before, before);
  }

  // Rotates the z axis by the smallest rotation that takes the y axis to the spine.
  static lms3dVector TurnZWith(const lms3dVector& tangent)
  {
    const double cosine = tangent[1];
    if (cosine <= -1.0)
    {
      return { 0, 0, -1 };
    }
    const double share = tangent[2] / (1.0 + cosine);
    return { -tangent[0] * share, -tangent[2], 1.0 - tangent[2] * share };
  }

  const std::vector<lms3dVector>& Points;
  std::size_t Last;
  bool IsClosed;
};
} // namespace

// Consecutive equal points have the same frame (ISO/IEC 14772-1, 6.18.3).
std::vector<lms3dSpineFrame> lms3dMakeSpineFrames(const std::vector<lms3dVector>& spine)
{
  std::vector<lms3dVector> distinct;
  std::vector<std::size_t> indices;
  for (const lms3dVector& point : spine)
  {
    if (distinct.empty() || distinct.back() != point)
    {
      distinct.push_back(point);
    }
    indices.push_back(distinct.size() - 1);
  }
  const std::vector<lms3dSpineFrame> frames = Spine(distinct).MakeFrames();
  std::vector<lms3dSpineFrame> result;
  result.reserve(indices.size());
  for (std::size_t index : indices)
  {
    result.push_back(frames[index]);
  }
  return result;
}
