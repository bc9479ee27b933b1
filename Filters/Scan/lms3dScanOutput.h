// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The two outputs of vtkLMS3DScanFilter, filled from the ranges of a scan.
 */
#ifndef lms3dScanOutput_h
#define lms3dScanOutput_h

#include "Device/lms3dRangeImage.h"
#include "Pipeline/lms3dMemoryPool.h"
#include "Scan/lms3dMovingBeams.h"
#include "Scan/lms3dPartHits.h"
#include "Scan/lms3dScanner.h"
#include "Scan/lms3dWideBeams.h"

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

class vtkImageData;
class lms3dProcesses;
class vtkPolyData;

/**
 * Fills the outputs of one scan after another, in memory that is reused.
 *
 * One scan is Cast and Fill, or, in several processes, CastPart, ReduceToNearest, Fill and
 * FillRangeImagePiece, all with the same arguments. Cast, CastPart and Fill use the threads of the
 * calling TBB arena.
 */
class lms3dScanOutput
{
public:
  /// Frees what is left of a scan that was stopped, that failed, or whose outputs are filled.
  void Discard();

  ///@{
  /// Makes, unless there is one that fits, and discards the plan of a scan that may follow with the
  /// same arguments. Caster and geometry must live until the plan is discarded. Uses the threads of
  /// the calling TBB arena.
  void MakePlan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
    const lms3dPose& pose, double maximumRange);
  bool HasPlan() const { return this->Plan.has_value(); }
  void DiscardPlan() { this->Plan.reset(); }
  ///@}

  /// Casts all beams. Returns false if `progress` stopped it.
  bool Cast(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry, const lms3dPose& pose,
    const lms3dRangeLimits& limits, const lms3dProgress& progress);

  /// Casts all beams against this process's part of the scene. `caster` is null if the part has no
  /// triangles. Returns false if `progress` stopped it.
  bool CastPart(const lms3dRayCaster* caster, const lms3dScanGeometry& geometry,
    const lms3dPose& pose, const lms3dRangeLimits& limits, const lms3dProgress& progress);

  /// Does what Cast does, or, if `isPart`, what CastPart does, for beams that start and point
  /// anywhere.
  bool CastRays(const lms3dRayCaster* caster, const lms3dMovingBeams& beams,
    const lms3dRangeLimits& limits, bool isPart, const lms3dProgress& progress);

  /// Makes room for the hits of beams with a width. The caller fills all.
  lms3dMixedBeams AllocateMixed(std::int64_t beams, bool isPart);

  /// Replaces the results of CastPart by the nearest of all processes. The triangles of this part
  /// belong to cells that are numbered from `firstCell`. Collective.
  void ReduceToNearest(
    const lms3dProcesses& processes, const lms3dRayCaster* caster, std::int64_t firstCell);

  /// Returns for each beam with a return the triangle that gave it, lms3dBeamPacket::NoTriangle for
  /// all other beams, and for beams that hit another process's part. Valid until Discard.
  const std::vector<std::int32_t>& GetOwnTriangles() const
  {
    return this->Part.Triangles.empty() ? this->Triangles : this->Part.Triangles;
  }

  /// Returns the range of each beam, metres, NaN without a return. Valid until Discard.
  const double* GetRanges() const { return this->Ranges->GetPointer(0); }

  /// Copies the range of each beam. Valid until Discard.
  void CopyRanges(vtkDoubleArray* ranges) const;

  /// Returns whether some beams have no return.
  bool HasMissingReturns() const;

  /// Removes the returns of the beams for which `isRemoved` is not 0. It has a value for each beam.
  void RemoveReturns(const std::vector<unsigned char>& isRemoved);

  /// Fills output 0 and, unless `image` is null, output 1. Both must be empty. Output 1 has the
  /// array of ranges; if all beams give returns, an array of output 0 shares its memory. So
  /// RemoveReturns must not follow. `mesh` is that of the caster, or null after ReduceToNearest.
  void Fill(const lms3dTriangleMesh* mesh, const lms3dScanGeometry& geometry, const lms3dPose& pose,
    vtkPolyData* scan, vtkImageData* image);

  /// Fills a piece of output 1 with a copy of its ranges, after ReduceToNearest.
  void FillRangeImagePiece(
    const lms3dScanGeometry& geometry, const lms3dImagePiece& piece, vtkImageData* image) const;

private:
  /// Returns the slot of the first return of each turn, and the number of returns at the end.
  std::vector<std::size_t> CountReturns(const lms3dScanGeometry& geometry) const;
  void Allocate(std::size_t beams);
  void AllocatePart(std::size_t beams);
  void SetNoReturn();

  lms3dMemoryPool Pool;
  std::optional<lms3dScanPlan> Plan;

  /// One value for each beam, ordered by turn, then by beam: metres, NaN without a return.
  vtkSmartPointer<vtkDoubleArray> Ranges;

  /// lms3dBeamPacket::NoTriangle without a return. After ReduceToNearest 0 stands for any triangle.
  std::vector<std::int32_t> Triangles;

  /// Used only with several processes.
  lms3dPartHits Part;
};

#endif
