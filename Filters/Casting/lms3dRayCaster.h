// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the nearest triangle along each beam of a packet.
 *
 * Each method is a source file with one function that makes its caster. To add a method, add that
 * file to CMakeLists.txt, an enumerator to lms3dRayCaster::Method, a declaration of the function
 * and a row of the table to lms3dRayCaster.cxx, an enumerator with its setter to
 * vtkLMS3DScanFilter.h, and an entry to LMS3DFilters.xml. The filter, the command line and the
 * benchmark read the table; tests compare the header and the XML with it.
 */
#ifndef lms3dRayCaster_h
#define lms3dRayCaster_h

#include "Casting/lms3dBeamGrid.h"
#include "Casting/lms3dGridCaster.h"
#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Pipeline/lms3dProgress.h"
#include "Pipeline/lms3dSerialNumber.h"

#include <cstdint>
#include <memory>
#include <utility>

class lms3dRayCaster
{
public:
  /// The values of vtkLMS3DScanFilter::IntersectionMethods, which documents them.
  enum Method
  {
    EXACT,
    FAST,
    ANGLE_SUM,
    MOLLER_TRUMBORE,
    STATIC_CELL_LOCATOR
  };

  /**
   * Builds what the method needs, with the threads of the calling TBB arena. The mesh must have at
   * least one triangle; the caster takes it over. Methods with Embree report the progress of the
   * build; the others report nothing. Returns null if `progress` stopped the build, which frees
   * all memory. Throws std::runtime_error if the build fails, for example because memory is short.
   */
  static std::unique_ptr<lms3dRayCaster> New(
    int method, lms3dTriangleMesh mesh, const lms3dProgress& progress = {});

  ///@{
  /// The methods of the table; a method is an index from 0.
  static int GetNumberOfMethods();
  static const char* GetMethodName(int method);
  ///@}

  virtual ~lms3dRayCaster() = default;
  lms3dRayCaster(const lms3dRayCaster&) = delete;
  lms3dRayCaster& operator=(const lms3dRayCaster&) = delete;

  /**
   * Casts the active beams of some packets. Fills Range and Triangle with the nearest hit at a
   * range above 0 and up to the maximum. Several threads may call this at once.
   */
  void Cast(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const
  {
    this->FindNearest(origin, packets, count);
    this->RefineRanges(origin, packets, count);
  }

  ///@{
  /**
   * The two steps of Cast. FindNearest finds the nearest triangle of each beam: FAST by ranges in
   * single precision, the other methods by ranges of about 13 digits. EXACT, ANGLE_SUM and
   * MOLLER_TRUMBORE take, of triangles at the same range, the one with the smallest index.
   * RefineRanges computes the ranges of these triangles with all digits; methods whose first ranges
   * are final do nothing. Between the two, Range of a beam with a triangle is undefined until
   * ComputeRanges.
   */
  virtual void FindNearest(
    const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const = 0;
  virtual void RefineRanges(
    const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const;
  ///@}

  /// Sets Range, after FindNearest, to the range by which FindNearest compared; processes that have
  /// parts of a scene compare these. Methods whose FindNearest sets Range do nothing.
  virtual void ComputeRanges(
    const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const;

  /**
   * Casts the active beams of some packets whose beams start at points of their own. Fills Range
   * and Triangle like Cast, which gives each beam the same result at its own start. Several threads
   * may call this at once. FAST may choose another triangle than Cast does where single precision
   * does not tell two apart.
   */
  void CastFree(double maximumRange, lms3dFreePacket* packets, int count) const
  {
    this->FindNearestFree(maximumRange, packets, count);
    this->RefineRangesFree(packets, count);
  }

  ///@{
  /**
   * The two steps of CastFree. FindNearestFree needs Origin, Direction and Active alone, and
   * overwrites NarrowDirection. It sets Range to the range by which it compared, NoRange for beams
   * without a hit. RefineRangesFree computes the ranges of the triangles with all digits, as
   * RefineRanges does; no range is then above the maximum of the first step. By default both treat
   * each beam on its own.
   */
  virtual void FindNearestFree(double maximumRange, lms3dFreePacket* packets, int count) const;
  virtual void RefineRangesFree(lms3dFreePacket* packets, int count) const;
  ///@}

  /// Returns an object whose FindNearest serves one scan, and gives the same results as this one's.
  /// The caster and the arrays of the grid must outlive it. Uses the threads of the calling TBB
  /// arena.
  virtual std::unique_ptr<lms3dGridCaster> NewGridCaster(
    const lms3dRayOrigin& origin, const lms3dBeamGrid& grid) const;

  const lms3dTriangleMesh& GetMesh() const { return this->Mesh; }

  /// Returns a number that no other caster has or had.
  std::uint64_t GetSerialNumber() const { return this->SerialNumber; }

protected:
  explicit lms3dRayCaster(lms3dTriangleMesh mesh)
    : Mesh(std::move(mesh))
  {
  }

private:
  lms3dTriangleMesh Mesh;
  const std::uint64_t SerialNumber = lms3dMakeSerialNumber();
};

#endif
