// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The boxes of the planes of a fused map, and which of them are near another box.
 */
#ifndef lms3dPlaneBoxes_h
#define lms3dPlaneBoxes_h

#include "Fusion/Scans/lms3dWorldBox.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

/// A search costs time by what is near, not by the number of planes: each plane is listed in the
/// cubes that its box meets, or, if it is large, in one list that each search goes through.
class lms3dPlaneBoxes
{
public:
  /// The size of a cube, metres, above 0.
  explicit lms3dPlaneBoxes(double size)
    : Size(size)
  {
  }

  /// Adds a plane with an empty box.
  void AddPlane() { this->Planes.emplace_back(); }

  const lms3dWorldBox& GetBox(std::size_t plane) const { return this->Planes[plane].Box; }

  /// Lets the box of a plane grow to a point.
  void Grow(std::size_t plane, const lms3dVector& point);

  /// Empties the box of a plane.
  void Remove(std::size_t plane);

  /// Returns the planes before `end` whose boxes are nearer to a box than a distance along each
  /// axis, in order. Metres.
  std::vector<int> Find(const lms3dWorldBox& box, double distance, std::size_t end) const;

private:
  using Cube = std::array<std::int64_t, 3>;

  /// The first and the last cubes that a box meets.
  struct Cubes
  {
    Cube First = { 0, 0, 0 };
    Cube Last = { -1, -1, -1 };

    double Count() const;
    bool Has(const Cube& cube) const;
  };

  struct Plane
  {
    lms3dWorldBox Box;
    Cubes Listed;
    bool IsLarge = false;
  };

  Cubes GetCubes(const lms3dWorldBox& box, double margin) const;
  static std::uint64_t GetKey(const Cube& cube);
  /// Calls `visit` with the key of each cube.
  template <typename Visitor>
  static void ForCubes(const Cubes& cubes, const Visitor& visit);

  const double Size;
  std::vector<Plane> Planes;
  std::unordered_map<std::uint64_t, std::vector<int>> InCube;
  std::vector<int> Large;
};

#endif
