// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Beams aimed at where meshes are weakest, and what is truly hit, for tests below VTK.
 */
#ifndef CasterFixtures_h
#define CasterFixtures_h

#include "Casting/lms3dRayCaster.h"
#include "ExactReference.h"
#include "Fixtures/BeamFixtures.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <limits>
#include <memory>

/// Tests cast 1/Fewer of their packets. Sanitizer and Debug builds define LMS3D_FEWER_BEAMS.
#ifdef LMS3D_FEWER_BEAMS
constexpr std::size_t Fewer = 50;
#else
constexpr std::size_t Fewer = 1;
#endif

/// A mesh in the caster under test and in the exact reference.
struct Target
{
  explicit Target(const lms3dTriangleMesh& mesh);

  const lms3dTriangleMesh& GetMesh() const { return this->Caster->GetMesh(); }
  /// The corner of a triangle, relative to an origin.
  Vector GetRelativeCorner(const Vector& origin, std::size_t triangle, int corner) const;
  /// Corners, points on edges and within a triangle, relative to an origin.
  Beams GetRelativePoints(std::size_t triangle, const Vector& origin, Random& random) const;
  /// Beams at these points, exact except for the rounding of the direction. No corner may be at the
  /// origin.
  Beams MakeBeamsAt(std::size_t triangle, const Vector& origin, Random& random) const;
  lms3dBeamPacket Cast(const Vector& origin, const Beams& directions,
    double maximumRange = std::numeric_limits<double>::infinity()) const;

  std::unique_ptr<lms3dRayCaster> Caster;
  ExactReference Reference;
};

/// Counts of beams and of errors.
struct Tally
{
  std::int64_t Beams = 0;
  std::int64_t Hits = 0;
  /// Hits of the reference that the caster misses.
  std::int64_t Misses = 0;
  /// Hits of a triangle that the beam truly passes by, or that is not the nearest.
  std::int64_t FalseHits = 0;
  /// The worst range in units in the last place.
  double WorstError = 0.0;

  Tally& operator+=(const Tally& other);
};
std::ostream& operator<<(std::ostream& os, const Tally& tally);

/// Units in the last place by which a range may differ from the true one.
constexpr double ExactRangeError = 3.0;

/// Expects that no beam is lost or invented, and every range is right.
void ExpectExact(const Tally& tally);

/// Expects as well that all beams hit, as they do from within a closed mesh.
void ExpectExactAndWhole(const Tally& tally);

/// Casts a packet and holds it against the reference. Hits within 1e-13 of one another are as good
/// as one another.
Tally Judge(const Target& target, const Vector& origin, const Beams& directions);

/// The same of one beam of a packet that was cast.
Tally JudgeBeam(const Target& target, const Vector& origin, const Vector& direction,
  const lms3dBeamPacket& packet, int beam);

/// The sum of the results of `judge` for each number below count, on all cores.
Tally JudgeEach(std::size_t count, const std::function<Tally(std::size_t)>& judge);

/// Casts `packets` packets, or fewer, at triangles throughout the mesh.
Tally JudgeTriangles(const Target& target, const Vector& sensor, std::size_t packets);

/// Casts `packets` packets, or fewer, in all directions.
Tally JudgeAllAround(const Target& target, const Vector& sensor, std::size_t packets);

#endif
