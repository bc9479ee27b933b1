// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRayCaster.h"

#include "vtkLMS3DScanFilter.h"

#include <cstddef>
#include <iterator>

using lms3dNewRayCaster = std::unique_ptr<lms3dRayCaster>(lms3dTriangleMesh mesh);

lms3dNewRayCaster lms3dNewExactCaster;
lms3dNewRayCaster lms3dNewFastCaster;
lms3dNewRayCaster lms3dNewAngleSumCaster;
lms3dNewRayCaster lms3dNewMollerTrumboreCaster;
lms3dNewRayCaster lms3dNewStaticCellLocatorCaster;

namespace
{
struct Method
{
  int Number;
  const char* Name;
  lms3dNewRayCaster* New;
};

constexpr Method Methods[] = {
  { vtkLMS3DScanFilter::EXACT, "Exact", lms3dNewExactCaster },
  { vtkLMS3DScanFilter::FAST, "Fast", lms3dNewFastCaster },
  { vtkLMS3DScanFilter::ANGLE_SUM, "AngleSum", lms3dNewAngleSumCaster },
  { vtkLMS3DScanFilter::MOLLER_TRUMBORE, "MollerTrumbore", lms3dNewMollerTrumboreCaster },
  { vtkLMS3DScanFilter::STATIC_CELL_LOCATOR, "StaticCellLocator", lms3dNewStaticCellLocatorCaster },
};

constexpr bool AreNumberedInOrder()
{
  for (std::size_t i = 0; i < std::size(Methods); ++i)
  {
    if (Methods[i].Number != static_cast<int>(i))
    {
      return false;
    }
  }
  return true;
}
static_assert(AreNumberedInOrder(), "a method's number is its place in the table");
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dRayCaster::New(int method, lms3dTriangleMesh mesh)
{
  return Methods[method].New(std::move(mesh));
}

void lms3dRayCaster::Measure(const lms3dViewpoint&, lms3dBeamPacket*, int) const
{
  // Most methods choose by the range that they give.
}

int lms3dRayCaster::GetNumberOfMethods()
{
  return static_cast<int>(std::size(Methods));
}

const char* lms3dRayCaster::GetMethodName(int method)
{
  return Methods[method].Name;
}
