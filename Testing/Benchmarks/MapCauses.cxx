// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapCauses.h"

#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace
{
constexpr vtkIdType SmallPatch = 4;

/// The vertices of all outlines, and the patches of each.
class Outlines
{
public:
  void Add(int patch, const std::array<vtkIdType, 3>& corners)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = corners[i];
      const vtkIdType b = corners[(i + 1) % 3];
      this->Patches[a].insert(patch);
      // An edge inside a patch occurs in both directions.
      if (this->Edges.erase({ patch, { b, a } }) == 0)
      {
        this->Edges.insert({ patch, { a, b } });
      }
    }
  }

  void Count(MapCauses& causes) const
  {
    std::set<vtkIdType> onOutline;
    for (const auto& edge : this->Edges)
    {
      onOutline.insert(edge.second.first);
    }
    for (const auto& [vertex, patches] : this->Patches)
    {
      const auto number = static_cast<vtkIdType>(patches.size());
      if (onOutline.count(vertex) == 0)
      {
        causes.Inside += 2;
      }
      else
      {
        (number == 1 ? causes.Borders : number == 2 ? causes.Creases : causes.Corners) += number;
      }
    }
  }

private:
  std::set<std::pair<int, std::pair<vtkIdType, vtkIdType>>> Edges;
  std::map<vtkIdType, std::set<int>> Patches;
};
} // namespace

MapCauses CountMapCauses(vtkPolyData* map)
{
  auto* ids = vtkIntArray::SafeDownCast(map->GetCellData()->GetArray("PatchId"));
  MapCauses causes;
  Outlines outlines;
  std::map<int, vtkIdType> sizes;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    const int patch = ids->GetValue(cell);
    if (patch < 0)
    {
      ++causes.Strips;
      continue;
    }
    ++sizes[patch];
    map->GetCellPoints(cell, points);
    outlines.Add(patch, { points->GetId(0), points->GetId(1), points->GetId(2) });
  }
  outlines.Count(causes);
  for (const auto& [patch, size] : sizes)
  {
    causes.SmallPatches += size <= SmallPatch ? 1 : 0;
    causes.OnSmallPatches += size <= SmallPatch ? size : 0;
  }
  causes.Patches = map->GetNumberOfCells() - causes.Strips - causes.Inside - causes.Borders -
    causes.Creases - causes.Corners;
  return causes;
}
