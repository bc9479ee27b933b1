// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dKeptMeshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

void lms3dKeptMeshes::Keep(lms3dBeamVector<std::int32_t> labels, const lms3dPatchOutlines& outlines,
  std::vector<lms3dPatchMesh> meshes)
{
  this->Labels = std::move(labels);
  this->Meshes = std::move(meshes);
  this->Vertices = outlines.GetVertices();
  this->Outlines.resize(this->Meshes.size());
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    this->Outlines[i] = outlines.GetOutline(static_cast<int>(i));
  }
}

void lms3dKeptMeshes::FindChanges(const lms3dPatches& patches)
{
  this->HasChanged.assign(this->Meshes.size(), false);
  const auto change = [this](std::int32_t label)
  {
    if (label >= 0 && label < static_cast<std::int32_t>(this->HasChanged.size()))
    {
      this->HasChanged[label] = true;
    }
  };
  for (std::size_t i = 0; i < this->Labels.size(); ++i)
  {
    if (this->Labels[i] != patches.Labels[i])
    {
      change(this->Labels[i]);
      change(patches.Labels[i]);
    }
  }
}

bool lms3dKeptMeshes::TryToTake(int patch, const lms3dPatchOutlines& outlines, lms3dPatchMesh& mesh)
{
  if (patch >= static_cast<int>(this->Meshes.size()) || !this->Meshes[patch].IsValid ||
    this->HasChanged[patch])
  {
    return false;
  }
  const std::vector<Number> numbers = this->MatchOutlines(patch, outlines);
  if (numbers.empty())
  {
    return false;
  }
  mesh = std::move(this->Meshes[patch]);
  this->Meshes[patch].IsValid = false;
  const auto shared = static_cast<std::int32_t>(this->Vertices.size());
  const auto added = static_cast<std::int32_t>(outlines.GetVertices().size());
  for (std::array<std::int32_t, 3>& triangle : mesh.Triangles)
  {
    for (std::int32_t& corner : triangle)
    {
      const auto isBefore = [](const Number& number, std::int32_t old) { return number.Old < old; };
      corner = corner < shared
        ? std::lower_bound(numbers.begin(), numbers.end(), corner, isBefore)->New
        : corner - shared + added;
    }
  }
  return true;
}

// Returns the numbers in the order of the old ones, or none if the outlines differ.
std::vector<lms3dKeptMeshes::Number> lms3dKeptMeshes::MatchOutlines(
  int patch, const lms3dPatchOutlines& outlines) const
{
  const lms3dPatchOutlines::Outline& before = this->Outlines[patch];
  const lms3dPatchOutlines::Outline& now = outlines.GetOutline(patch);
  if (before.LoopEnds != now.LoopEnds)
  {
    return {};
  }
  std::vector<Number> numbers(before.Vertices.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = { before.Vertices[i], now.Vertices[i] };
  }
  std::sort(
    numbers.begin(), numbers.end(), [](const Number& a, const Number& b) { return a.Old < b.Old; });
  return this->AreSameVertices(numbers, outlines.GetVertices()) ? numbers : std::vector<Number>();
}

// The order of the vertices counts, too: a triangulation takes them in that order.
bool lms3dKeptMeshes::AreSameVertices(
  const std::vector<Number>& sorted, const std::vector<lms3dMapVertex>& vertices) const
{
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    const lms3dMapVertex& before = this->Vertices[sorted[i].Old];
    const lms3dMapVertex& now = vertices[sorted[i].New];
    const bool isSame =
      before.Direction == now.Direction && before.InverseRange == now.InverseRange;
    const bool isInOrder = i == 0 ||
      (sorted[i - 1].Old == sorted[i].Old ? sorted[i - 1].New == sorted[i].New
                                          : sorted[i - 1].New < sorted[i].New);
    if (!isSame || !isInOrder)
    {
      return false;
    }
  }
  return true;
}
