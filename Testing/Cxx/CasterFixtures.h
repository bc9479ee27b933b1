// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes to shoot at, and beams aimed at where they are weakest, for tests below VTK.
 */
#ifndef CasterFixtures_h
#define CasterFixtures_h

#include "ExactReference.h"
#include "lms3dBeamPacket.h"
#include "lms3dRayCaster.h"
#include "lms3dTriangleMesh.h"

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <vector>

class vtkPolyData;

using Vector = std::array<double, 3>;

/// The same sequence everywhere for the same seed (SplitMix64).
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }
  /// All 64 bits.
  std::uint64_t GetBits();
  /// From 0 up to, not including, 1.
  double Get() { return static_cast<double>(this->GetBits() >> 11) * 0x1p-53; }
  double Get(double low, double high) { return low + (high - low) * this->Get(); }
  /// A vector on the unit sphere.
  Vector GetDirection();

private:
  std::uint64_t State;
};

Vector operator+(const Vector& p, const Vector& q);
Vector operator-(const Vector& p, const Vector& q);
Vector operator*(double factor, const Vector& p);
double GetLength(const Vector& p);
Vector Normalize(const Vector& p);
/// Turned by angles that are multiples of nothing.
Vector Turn(const Vector& p);

lms3dTriangleMesh MakeMesh(const std::vector<std::array<Vector, 3>>& triangles);
/// An icosahedron of radius 1 whose triangles are quartered so many times.
lms3dTriangleMesh MakeIcosphere(int level);
/// From -1 to 1, each side of cells x cells squares, two triangles each.
lms3dTriangleMesh MakeCube(int cells);
/// The triangles of a surface that has nothing else.
lms3dTriangleMesh MakeMesh(vtkPolyData* surface);
void Append(const lms3dTriangleMesh& other, lms3dTriangleMesh& mesh);
lms3dTriangleMesh Map(lms3dTriangleMesh mesh, const std::function<Vector(const Vector&)>& map);
lms3dTriangleMesh Move(lms3dTriangleMesh mesh, double scale, const Vector& offset);
/// Whether each edge, told by its coordinates, is used as often in one direction as in the other.
bool IsClosed(const lms3dTriangleMesh& mesh);

using Beams = std::array<Vector, lms3dBeamPacket::Size>;

/// A packet along some directions, no component of which is above 1.
lms3dBeamPacket Aim(const Beams& directions);

/// A mesh in the caster that is tested and in the one that is right.
struct Target
{
  explicit Target(const lms3dTriangleMesh& mesh);

  const lms3dTriangleMesh& GetMesh() const { return this->Caster->GetMesh(); }
  /// The corner of a triangle seen from an origin.
  Vector See(const Vector& origin, std::size_t triangle, int corner) const;
  /// Beams at corners, edges and the inside of a triangle: exactly at them but for the rounding of
  /// the direction. None where a corner is at the origin.
  Beams AimAt(std::size_t triangle, const Vector& origin, Random& random) const;

  std::unique_ptr<lms3dRayCaster> Caster;
  ExactReference Reference;
};

/// What was found wrong in how many beams.
struct Tally
{
  std::int64_t Beams = 0;
  std::int64_t Hits = 0;
  /// Of them those that miss what they truly hit.
  std::int64_t Misses = 0;
  /// Hits of a triangle that the beam truly passes by, or that is not the nearest.
  std::int64_t FalseHits = 0;
  /// The worst range in units in the last place.
  double WorstError = 0.0;

  Tally& operator+=(const Tally& other);
};
std::ostream& operator<<(std::ostream& os, const Tally& tally);

/// Casts a packet and holds it against the reference. Hits within 1e-13 of one another are as good
/// as one another.
Tally Judge(const Target& target, const Vector& origin, const Beams& directions);

/// The sum of what `judge` tells of each number below count, on all cores.
Tally JudgeEach(std::size_t count, const std::function<Tally(std::size_t)>& judge);

#endif
