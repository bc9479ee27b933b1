// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scene's triangles in clusters of neighbours, each with a box.
 *
 * A grid of cubes divides the scene. The triangles whose boxes have their centres in one cube are a
 * cluster. A triangle that is much larger than a cube is a cluster of its own, so that it does not
 * enlarge the box of its neighbours. A cluster consists of parts of a few triangles.
 */
#ifndef lms3dTriangleClusters_h
#define lms3dTriangleClusters_h

#include "Casting/lms3dNormalization.h"
#include "Geometry/lms3dTriangleMesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

class lms3dTriangleClusters
{
public:
  /// Some triangles and a box around them.
  struct Group
  {
    lms3dNormalizedBox Box;

    /// Where the triangles stand in the list of all, and their number.
    std::uint32_t First;
    std::uint32_t Count;
  };

  /// The normalization must be of the whole mesh.
  lms3dTriangleClusters(const lms3dTriangleMesh& mesh, const lms3dNormalization& normalization);

  std::size_t GetCount() const { return this->Clusters.size(); }
  const Group& GetCluster(std::size_t i) const { return this->Clusters[i]; }

  /// Calls `function` with each part of a cluster: up to four triangles that are neighbours.
  template <typename Function>
  void ForEachPart(std::size_t cluster, const Function& function) const
  {
    const Group& whole = this->Clusters[cluster];
    const lms3dNormalizedBox* box = this->Parts.data() + this->FirstPart[cluster];
    for (std::uint32_t done = 0; done < whole.Count; done += TrianglesOfPart, ++box)
    {
      function(Group{ *box, whole.First + done, std::min(TrianglesOfPart, whole.Count - done) });
    }
  }

  const std::uint32_t* GetTriangles() const { return this->Triangles.data(); }

private:
  class Builder;

  static constexpr std::uint32_t TrianglesOfPart = 4;

  std::vector<Group> Clusters;
  std::vector<lms3dNormalizedBox> Parts;
  std::vector<std::uint32_t> FirstPart;
  std::vector<std::uint32_t> Triangles;
};

#endif
