// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The planes of a fused map, and how triangles and returns join them.
 */
#ifndef lms3dFusedPlanes_h
#define lms3dFusedPlanes_h

#include "Fusion/Planes/lms3dFusedPlane.h"
#include "Fusion/Planes/lms3dPlaneBoxes.h"
#include "Fusion/Scans/lms3dLocalMap.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

/// A plane keeps its number until it is cleared. Lengths are metres.
class lms3dFusedPlanes
{
public:
  explicit lms3dFusedPlanes(double maximumError);

  double GetMaximumError() const { return this->MaximumError; }
  double GetCell() const { return this->Cell; }
  /// How far a return may be from its plane. The rest of the bound is for the size of cells.
  double GetLargestDistance() const { return 0.97 * this->MaximumError; }
  /// The scan, counted from 0, that AddReturn() takes the returns to be of.
  void SetScan(int scan) { this->Scan = scan; }

  std::size_t GetSize() const { return this->Planes.size(); }
  lms3dFusedPlane& operator[](std::size_t number) { return this->Planes[number]; }
  const lms3dFusedPlane& operator[](std::size_t number) const { return this->Planes[number]; }
  const std::deque<lms3dFusedPlane>& GetAll() const { return this->Planes; }

  ///@{
  /// Returns the number of a new plane: the lowest that ReuseNumbers() found, or a new one. Its
  /// first tile lies around the foot of `middle`, or of the point.
  int MakePlane(const lms3dVector& point, const lms3dVector& normal)
  {
    return this->MakePlane(point, normal, point);
  }
  int MakePlane(const lms3dVector& point, const lms3dVector& normal, const lms3dVector& middle);
  ///@}

  /// Takes a plane out. Its tiles stay, without blocks and triangles.
  void Clear(int number);

  /// Lets MakePlane() use the numbers of planes that were cleared. Their tiles must be up to date.
  /// A plane keeps its number as long as another plane that has not gone ends at a crease with it.
  void ReuseNumbers();
  /// How many numbers of planes that were cleared MakePlane() can use.
  std::size_t GetNumberOfUnused() const { return this->Unused.size(); }

  ///@{
  /// Lets the box of a plane have a point, or a triangle of a local map.
  void GrowBox(int number, const lms3dVector& point)
  {
    this->Boxes.Grow(static_cast<std::size_t>(number), point);
  }
  void GrowBox(int number, const lms3dLocalMap& local, int triangle);
  ///@}

  ///@{
  /// Threads may call these for different planes at the same time. Lets a plane have surface where
  /// a triangle of a local map is. The cells get Guess until AcceptGuesses().
  void GuessTriangle(int number, const lms3dLocalMap& local, int triangle);
  void GuessTriangle(int number, const std::array<lms3dVector, 3>& corners);

  /// Lets a plane have surface where Guess says so.
  void AcceptGuesses(int number);

  /// Adds a return to a plane. Returns false if the plane does not explain it.
  bool AddReturn(int number, const lms3dMappedReturn& mapped);
  ///@}

  /// Whether the triangles of a plane explain a return: they are within the bound of it.
  bool Covers(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped) const;

  /// Whether the beam of a return meets a plane in a cell that is covered, within the bound of the
  /// return.
  bool IsMetBy(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped) const;

  /// Adds a return to a plane that covers it. The region does not grow to it.
  void AddBeside(int number, const lms3dMappedReturn& mapped);

  /// Adds a return beside the region of a plane that covers it, or gives it a facet if the number
  /// is -1.
  void AddBesideOrFacet(int number, const lms3dMappedReturn& mapped);

  /// Adds a return to the first plane that shows it. Returns false if none does.
  bool AddToPlanes(const std::vector<int>& planes, const lms3dMappedReturn& mapped);

  /// Makes a small triangle around a return, across its beam. It goes when a plane shows the
  /// return.
  void AddFacet(const lms3dMappedReturn& mapped);

  /// Whether a plane explains a return, and has surface there.
  bool Shows(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped) const;

  /// The planes with surface, out of the first `end`, that can show a return: they and their boxes
  /// meet the box of the returns.
  std::vector<int> FindPlanesNear(
    const std::vector<lms3dMappedReturn>& returns, std::size_t end) const;

  /// The box of the triangles that joined a plane, of local maps or of other planes, and of the
  /// returns of planes that no local map has.
  const lms3dWorldBox& GetBox(std::size_t number) const { return this->Boxes.GetBox(number); }

  /// The planes whose boxes are nearer to a box than a distance along each axis.
  std::vector<int> FindPlanesNear(const lms3dWorldBox& box, double distance) const
  {
    return this->Boxes.Find(box, distance, this->Planes.size());
  }

  /// Whether the planes show at least a share of the returns.
  bool ShowShare(double share, const std::vector<int>& planes,
    const std::vector<lms3dMappedReturn>& returns) const;

private:
  bool IsCreaseOfOthers(int number) const;
  void DropCreases(int number);
  /// `place` is that of the return, cells.
  void NoteReturn(lms3dFusedPlane& plane, int blockNumber, const lms3dMappedReturn& mapped,
    const lms3dPoint2& place) const;
  bool IsCovered(const lms3dFusedPlane& plane, const lms3dRasterBlock& block, std::int32_t u,
    std::int32_t v) const;
  /// Whether triangles in the tile of a cell explain a return in the cell, at a distance from the
  /// plane, metres.
  bool IsCovered(
    const lms3dFusedPlane& plane, std::int32_t u, std::int32_t v, double distance) const;

  const double MaximumError;
  const double Cell;
  int Scan = 0;
  /// The memory of the blocks of all planes.
  std::shared_ptr<lms3dBlockMemory> Memory;
  std::deque<lms3dFusedPlane> Planes;
  /// The planes that were cleared, without those whose numbers can be used again.
  std::vector<int> Cleared;
  /// The numbers that can be used again, the highest first.
  std::vector<int> Unused;
  /// As GetBox().
  lms3dPlaneBoxes Boxes;
};

#endif
