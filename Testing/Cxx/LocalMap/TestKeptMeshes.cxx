// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which meshes of patches are kept when other patches are split, and that a new attempt
 * makes the same.
 */
#include "LocalMap/Bounded/lms3dKeptMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace
{
constexpr double Near = 2.0;
constexpr double Far = 3.0;
constexpr double MaximumError = 0.01;
constexpr int Beams = 41;
constexpr int Turns = 41;

enum Patch : std::int32_t
{
  Left,
  Right,
  /// A block of beams inside of the left one.
  Inner,
  /// A corner of the block, after it is split.
  Corner
};

/// Beams in steps of a degree, to 20 degrees on all sides. All returns of a patch have the same
/// range.
class Walls
{
public:
  Walls()
    : Geometry(MakeGeometry())
  {
    std::vector<double> ranges;
    std::vector<int> ids;
    for (int i = 0; i < Beams * Turns; ++i)
    {
      ranges.push_back(i / Beams < Turns / 2 ? Near : Far);
      ids.push_back(i);
    }
    this->Grid.Build(this->Geometry, ranges.data(), ids.data(), Beams * Turns);
    this->Joins.Find(this->Grid, 0.1);
    this->Sphere = std::make_unique<lms3dBeamSphere>(this->Grid, this->Joins);
    this->Patches.Labels.assign(this->Sphere->GetSize(), lms3dPatches::None);
    for (lms3dBeamSphere::GridIndex index = 0; index < this->Sphere->GetSize(); ++index)
    {
      if (this->Sphere->HasReturn(index))
      {
        const Patch side = this->Sphere->GetRange(index) == Near ? Left : Right;
        this->Patches.Labels[index] = this->IsInBlock(index, 5, 10) ? Inner : side;
      }
    }
    this->FitPlanes(3);
  }

  void SplitBlock()
  {
    for (lms3dBeamSphere::GridIndex index = 0; index < this->Sphere->GetSize(); ++index)
    {
      if (this->IsInBlock(index, 9, 15))
      {
        this->Patches.Labels[index] = Corner;
      }
    }
    const std::vector<lms3dPatches::Patch> before = this->Patches.Patches;
    this->FitPlanes(4);
    this->Patches.Patches[Left].Plane = before[Left].Plane;
    this->Patches.Patches[Right].Plane = before[Right].Plane;
  }

  const lms3dPatches& GetPatches() const { return this->Patches; }

  /// The outlines and the meshes of all patches.
  struct Attempt
  {
    explicit Attempt(const Walls& walls)
      : Gates(*walls.Sphere, walls.Patches, lms3dPatches::CreaseShare * MaximumError)
      , Outlines(*walls.Sphere, walls.Patches, this->Gates)
    {
      lms3dPatchMesher mesher(*walls.Sphere, walls.Patches, this->Outlines, MaximumError, 0.0);
      const std::vector<int> members = walls.Patches.CountMembers(*walls.Sphere);
      for (std::size_t i = 0; i < members.size(); ++i)
      {
        this->Meshes.push_back(mesher.Mesh(static_cast<int>(i), members[i]));
      }
    }

    const lms3dBorderGates Gates;
    const lms3dPatchOutlines Outlines;
    std::vector<lms3dPatchMesh> Meshes;
  };

private:
  static lms3dScanGeometry MakeGeometry()
  {
    const double angles[2] = { -20.0, 20.0 };
    return { angles, Beams, angles, Turns };
  }

  bool IsInBlock(lms3dBeamSphere::GridIndex index, int firstTurn, int firstBeam) const
  {
    const int turn = this->Sphere->GetTurn(index);
    const int beam = this->Sphere->GetBeam(index);
    return turn >= firstTurn && turn < 12 && beam >= firstBeam && beam < 20;
  }

  void FitPlanes(int count)
  {
    this->Patches.Patches.assign(count, {});
    for (lms3dBeamSphere::GridIndex index = 0; index < this->Sphere->GetSize(); ++index)
    {
      if (this->Patches.Labels[index] >= 0)
      {
        this->Patches.Patches[this->Patches.Labels[index]].Fit.Add(*this->Sphere, index);
      }
    }
    for (lms3dPatches::Patch& patch : this->Patches.Patches)
    {
      patch.Plane = patch.Fit.GetPlane();
    }
  }

  lms3dScanGeometry Geometry;
  lms3dRangeGrid Grid;
  lms3dRangeJoins Joins;
  std::unique_ptr<lms3dBeamSphere> Sphere;
  lms3dPatches Patches;
};

void ExpectSame(const lms3dPatchMesh& mesh, const lms3dPatchMesh& expected)
{
  EXPECT_TRUE(mesh.IsValid);
  EXPECT_EQ(mesh.Triangles, expected.Triangles);
  ASSERT_EQ(mesh.Added.size(), expected.Added.size());
  for (std::size_t i = 0; i < mesh.Added.size(); ++i)
  {
    EXPECT_EQ(mesh.Added[i].Direction, expected.Added[i].Direction);
    EXPECT_EQ(mesh.Added[i].InverseRange, expected.Added[i].InverseRange);
  }
}
} // namespace

TEST(KeptMeshes, AreThoseOfTheNextAttempt)
{
  Walls walls;
  Walls::Attempt first(walls);
  ASSERT_TRUE(first.Meshes[Right].IsValid);
  ASSERT_FALSE(first.Meshes[Right].Added.empty());
  const lms3dPatchMesh before = first.Meshes[Right];
  lms3dKeptMeshes kept;
  kept.Keep(walls.GetPatches().Labels, first.Outlines, std::move(first.Meshes));
  walls.SplitBlock();
  const Walls::Attempt second(walls);
  kept.FindChanges(walls.GetPatches());
  lms3dPatchMesh mesh;
  ASSERT_TRUE(kept.TryToTake(Right, second.Outlines, mesh));
  // The junctions beside the split block come first, so all numbers are others.
  EXPECT_NE(before.Triangles, second.Meshes[Right].Triangles);
  ExpectSame(mesh, second.Meshes[Right]);
}

TEST(KeptMeshes, AreNoneOfPatchesThatChanged)
{
  Walls walls;
  Walls::Attempt first(walls);
  ASSERT_TRUE(first.Meshes[Left].IsValid);
  ASSERT_TRUE(first.Meshes[Inner].IsValid);
  lms3dKeptMeshes kept;
  kept.Keep(walls.GetPatches().Labels, first.Outlines, std::move(first.Meshes));
  walls.SplitBlock();
  const Walls::Attempt second(walls);
  kept.FindChanges(walls.GetPatches());
  lms3dPatchMesh mesh;
  // Its outline passes the ends of the border around the corner.
  EXPECT_FALSE(kept.TryToTake(Left, second.Outlines, mesh));
  EXPECT_FALSE(kept.TryToTake(Inner, second.Outlines, mesh));
  EXPECT_FALSE(kept.TryToTake(Corner, second.Outlines, mesh));
}

TEST(KeptMeshes, AreNoneOfPatchesWithOtherReturns)
{
  Walls walls;
  Walls::Attempt first(walls);
  lms3dKeptMeshes kept;
  kept.Keep(walls.GetPatches().Labels, first.Outlines, std::move(first.Meshes));
  lms3dPatches patches = walls.GetPatches();
  *std::find(patches.Labels.begin(), patches.Labels.end(), Right) = lms3dPatches::None;
  kept.FindChanges(patches);
  lms3dPatchMesh mesh;
  EXPECT_TRUE(kept.TryToTake(Left, first.Outlines, mesh));
  EXPECT_FALSE(kept.TryToTake(Right, first.Outlines, mesh));
}
