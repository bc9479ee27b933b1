// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTriangleClusters.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace
{
// Cubes along the scene's diagonal at first. Few enough for a scan to look at all clusters.
constexpr int MaximumCubes = 32;
constexpr std::size_t MaximumClusters = 4096;

// A triangle longer than this number of cubes is a cluster of its own, as long as there are few.
constexpr float MaximumCubesOfTriangle = 2.0f;
constexpr std::size_t MaximumLarge = 256;

// Enough for the preparations of a task to cost little.
constexpr std::size_t TrianglesOfTask = 1024;

// Bits of a place within a cube, along each axis.
constexpr int PlaceBits = 3;

constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr lms3dNormalizedBox Nothing = { { Infinity, Infinity, Infinity },
  { -Infinity, -Infinity, -Infinity } };

// Returns the number of the cube of the given size that has the centre of a box, along an axis.
int FindPlace(const lms3dNormalizedBox& box, int axis, int cubes)
{
  const float center = 0.5f * (box.Low[axis] + box.High[axis]);
  return std::clamp(static_cast<int>((center + 0.5f) * static_cast<float>(cubes)), 0, cubes - 1);
}
} // namespace

/// Makes the clusters with one size of cubes.
class lms3dTriangleClusters::Builder
{
public:
  Builder(const std::vector<lms3dNormalizedBox>& boxes, int cubes)
    : Boxes(boxes)
    , Cubes(cubes)
    , ClusterOfCube(static_cast<std::size_t>(cubes) * cubes * cubes, NoCluster)
  {
  }

  // Returns false if there are too many clusters.
  bool Build(lms3dTriangleClusters& result)
  {
    std::vector<std::uint32_t> clusters(this->Boxes.size());
    for (std::size_t triangle = 0; triangle < clusters.size(); ++triangle)
    {
      const lms3dNormalizedBox& box = this->Boxes[triangle];
      clusters[triangle] = this->FindCluster(box);
      Group& cluster = this->Clusters[clusters[triangle]];
      Enlarge(box, cluster.Box);
      ++cluster.Count;
      if (this->Clusters.size() > MaximumClusters)
      {
        return false;
      }
    }
    result.Triangles = this->List(clusters);
    for (const Group& cluster : this->Clusters)
    {
      this->Sort(result.Triangles.data() + cluster.First, cluster.Count);
    }
    this->MakeParts(result);
    result.Clusters = this->Clusters;
    return true;
  }

private:
  static constexpr std::uint32_t NoCluster = ~0u;

  std::uint32_t FindCluster(const lms3dNormalizedBox& box)
  {
    std::size_t cube = 0;
    float size = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
    {
      cube = cube * this->Cubes + FindPlace(box, axis, this->Cubes);
      size = std::max(size, box.High[axis] - box.Low[axis]);
    }
    if (size * static_cast<float>(this->Cubes) > MaximumCubesOfTriangle &&
      this->CountOfLarge < MaximumLarge)
    {
      ++this->CountOfLarge;
      return this->AddCluster();
    }
    std::uint32_t& cluster = this->ClusterOfCube[cube];
    cluster = cluster == NoCluster ? this->AddCluster() : cluster;
    return cluster;
  }

  std::uint32_t AddCluster()
  {
    this->Clusters.push_back({ Nothing, 0, 0 });
    return static_cast<std::uint32_t>(this->Clusters.size() - 1);
  }

  static void Enlarge(const lms3dNormalizedBox& box, lms3dNormalizedBox& whole)
  {
    whole = lms3dJoin(whole, box);
  }

  // Returns the triangles of one cluster after the other.
  std::vector<std::uint32_t> List(const std::vector<std::uint32_t>& clusters)
  {
    std::vector<std::uint32_t> next(this->Clusters.size());
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      this->Clusters[i].First = next[i] = first;
      first += this->Clusters[i].Count;
    }
    std::vector<std::uint32_t> triangles(clusters.size());
    for (std::size_t triangle = 0; triangle < clusters.size(); ++triangle)
    {
      triangles[next[clusters[triangle]]++] = static_cast<std::uint32_t>(triangle);
    }
    return triangles;
  }

  // Sorts the triangles of a cluster along a Z-order curve, so that neighbours share parts.
  void Sort(std::uint32_t* triangles, std::uint32_t count)
  {
    this->Keys.resize(count);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      this->Keys[i] = { this->GetKey(triangles[i]), triangles[i] };
    }
    std::sort(this->Keys.begin(), this->Keys.end());
    for (std::uint32_t i = 0; i < count; ++i)
    {
      triangles[i] = this->Keys[i].second;
    }
  }

  std::uint32_t GetKey(std::uint32_t triangle) const
  {
    const lms3dNormalizedBox& box = this->Boxes[triangle];
    std::uint32_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int place = FindPlace(box, axis, this->Cubes << PlaceBits);
      for (int bit = 0; bit < PlaceBits; ++bit)
      {
        key |= (static_cast<std::uint32_t>(place) >> bit & 1u) << (3 * bit + axis);
      }
    }
    return key;
  }

  void MakeParts(lms3dTriangleClusters& result) const
  {
    result.FirstPart.reserve(this->Clusters.size());
    std::uint32_t parts = 0;
    for (const Group& cluster : this->Clusters)
    {
      result.FirstPart.push_back(parts);
      parts += (cluster.Count + TrianglesOfPart - 1) / TrianglesOfPart;
    }
    result.Parts.assign(parts, Nothing);
    for (std::size_t i = 0; i < this->Clusters.size(); ++i)
    {
      const Group& cluster = this->Clusters[i];
      for (std::uint32_t k = 0; k < cluster.Count; ++k)
      {
        Enlarge(this->Boxes[result.Triangles[cluster.First + k]],
          result.Parts[result.FirstPart[i] + k / TrianglesOfPart]);
      }
    }
  }

  const std::vector<lms3dNormalizedBox>& Boxes;
  const int Cubes;
  std::vector<std::uint32_t> ClusterOfCube;
  std::vector<Group> Clusters;
  std::size_t CountOfLarge = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Keys;
};

lms3dTriangleClusters::lms3dTriangleClusters(
  const lms3dTriangleMesh& mesh, const lms3dNormalization& normalization)
{
  std::vector<lms3dNormalizedBox> boxes(mesh.GetNumberOfTriangles());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), TrianglesOfTask),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        boxes[i] = normalization.GetBox(lms3dGetCorners(mesh, i));
      }
    });
  int cubes = MaximumCubes;
  while (!Builder(boxes, cubes).Build(*this))
  {
    cubes /= 2;
  }
}
