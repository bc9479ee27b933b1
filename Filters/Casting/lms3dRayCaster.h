// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the nearest triangle along each beam of a packet.
 *
 * A method is a source file of its own, with one function that makes its caster. Adding one takes
 * that file and its line in CMakeLists.txt, a row in the table of lms3dRayCaster.cxx, an enumerator
 * with its setter in vtkLMS3DScanFilter.h, and an entry in LMS3DFilters.xml. The filter, the command
 * line and the benchmark read the table; tests hold the header and the XML against it.
 */
#ifndef lms3dRayCaster_h
#define lms3dRayCaster_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"
#include "Pipeline/lms3dProgress.h"

#include <memory>
#include <utility>

class lms3dRayCaster
{
public:
  /// The numbers of vtkLMS3DScanFilter::IntersectionMethods, which documents them.
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

  static int GetNumberOfMethods();
  static const char* GetMethodName(int method);

  virtual ~lms3dRayCaster() = default;
  lms3dRayCaster(const lms3dRayCaster&) = delete;
  lms3dRayCaster& operator=(const lms3dRayCaster&) = delete;

  /**
   * Casts the active beams of some packets, and fills their Range and Triangle with the nearest hit
   * at a range above 0 and up to the viewpoint's maximum. May be called from many threads.
   */
  void Cast(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const
  {
    this->Choose(viewpoint, packets, count);
    this->Measure(viewpoint, packets, count);
  }

  ///@{
  /**
   * The two steps of Cast. The first finds the nearest triangle, of those at the same range the one
   * with the smallest number, by a range that has about 13 digits; the second gives it all digits.
   */
  virtual void Choose(
    const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const = 0;
  virtual void Measure(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const;
  ///@}

  const lms3dTriangleMesh& GetMesh() const { return this->Mesh; }

protected:
  explicit lms3dRayCaster(lms3dTriangleMesh mesh)
    : Mesh(std::move(mesh))
  {
  }

private:
  lms3dTriangleMesh Mesh;
};

#endif
