// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the nearest triangle along each beam of a packet.
 *
 * A method is a source file of its own with one function of the kind lms3dNewRayCaster, which is
 * named in the table of lms3dRayCaster.cxx, in the order of
 * vtkLMS3DScanFilter::IntersectionMethods.
 */
#ifndef lms3dRayCaster_h
#define lms3dRayCaster_h

#include "lms3dBeamPacket.h"
#include "lms3dTriangleMesh.h"

#include <memory>
#include <utility>

class lms3dRayCaster
{
public:
  /**
   * Takes the mesh over, which has at least one triangle, and builds what the method needs, with
   * the threads of the calling TBB arena. Throws std::runtime_error where that fails, for want of
   * memory for instance.
   */
  static std::unique_ptr<lms3dRayCaster> New(int method, lms3dTriangleMesh mesh);

  virtual ~lms3dRayCaster() = default;
  lms3dRayCaster(const lms3dRayCaster&) = delete;
  lms3dRayCaster& operator=(const lms3dRayCaster&) = delete;

  /**
   * Casts the active beams of some packets, and fills their Range and Triangle with the nearest hit
   * at a range above 0 and up to the viewpoint's maximum. May be called from many threads.
   */
  virtual void Cast(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const = 0;

  const lms3dTriangleMesh& GetMesh() const { return this->Mesh; }

protected:
  explicit lms3dRayCaster(lms3dTriangleMesh mesh)
    : Mesh(std::move(mesh))
  {
  }

private:
  lms3dTriangleMesh Mesh;
};

using lms3dNewRayCaster = std::unique_ptr<lms3dRayCaster>(lms3dTriangleMesh mesh);

lms3dNewRayCaster lms3dNewExactCaster;
lms3dNewRayCaster lms3dNewFastCaster;
lms3dNewRayCaster lms3dNewAngleSumCaster;
lms3dNewRayCaster lms3dNewMollerTrumboreCaster;
lms3dNewRayCaster lms3dNewStaticCellLocatorCaster;

#endif
