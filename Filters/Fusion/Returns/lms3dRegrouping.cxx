// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dRegrouping.h"

#include "Fusion/Planes/lms3dCoveringPlanes.h"
#include "Fusion/Returns/lms3dRegroupedPlane.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace
{
// As a share of the bound: how far returns may be from the plane of their group.
constexpr double LargestShare = 0.9;
// Bounds: how far old planes may be from the box of the first one.
constexpr double LargestGap = 3.0;
constexpr std::size_t PlacesOfScan = 10;
// The most returns of a plane that goes.
constexpr std::size_t LargestCount = 4000;
// The most returns of several planes in a place. Small places take less time, so more of them are
// looked at, and one place that fails keeps fewer planes.
constexpr std::size_t LargestCountOfPlace = 1000;
// Planes with fewer triangles are not looked at for their own sake.
constexpr std::size_t SmallestNumberOfTriangles = 2;
// How many triangles a new plane is expected to have. Most have more, so places that are not better
// with this number are hardly ever better.
constexpr std::size_t TrianglesOfPlane = 3;
} // namespace

bool lms3dRegrouping::IsCandidate(int number) const
{
  const lms3dFusedPlane& plane = this->Planes[number];
  return plane.IsWeak && !plane.Returns.empty() && plane.Returns.size() <= LargestCount;
}

// The planes at which a place may be worth it, those that have gained the most triangles first.
std::vector<int> lms3dRegrouping::FindSeeds() const
{
  std::vector<std::pair<std::size_t, int>> seeds;
  for (std::size_t i = 0; i < this->Planes.GetSize(); ++i)
  {
    const auto number = static_cast<int>(i);
    const lms3dFusedPlane& plane = this->Planes[i];
    if (!this->IsCandidate(number))
    {
      continue;
    }
    const std::size_t triangles = plane.CountTriangles();
    if (triangles > plane.RegroupedTriangles &&
      (triangles >= SmallestNumberOfTriangles || !plane.Verbatim.empty()))
    {
      seeds.emplace_back(triangles - plane.RegroupedTriangles, number);
    }
  }
  std::sort(seeds.begin(), seeds.end(),
    [](const auto& a, const auto& b)
    { return a.first != b.first ? a.first > b.first : a.second < b.second; });
  std::vector<int> numbers;
  numbers.reserve(seeds.size());
  for (const auto& seed : seeds)
  {
    numbers.push_back(seed.second);
  }
  return numbers;
}

// The threads divide places, then the new planes of each place.
bool lms3dRegrouping::MakePlanes()
{
  std::vector<Place> places = this->FindPlaces();
  const double bound = LargestShare * this->Planes.GetMaximumError();
  tbb::parallel_for(std::size_t{ 0 }, places.size(),
    [&](std::size_t i) { places[i].Groups = lms3dGroupReturns(places[i].Returns, bound); });
  for (Place& place : places)
  {
    lms3dFusedPlane& seed = this->Planes[place.OldPlanes.front()];
    seed.RegroupedTriangles = seed.CountTriangles();
    place.FindLeft();
    for (Place& part : place.Split())
    {
      this->AddPlace(std::move(part));
    }
  }
  this->FillPlanes();
  return std::any_of(this->Places.begin(), this->Places.end(),
    [](const Place& place) { return !place.NewPlanes.empty(); });
}

std::vector<lms3dRegrouping::Place> lms3dRegrouping::FindPlaces()
{
  this->IsTaken.assign(this->Planes.GetSize(), false);
  std::vector<Place> places;
  for (const int seed : this->FindSeeds())
  {
    if (places.size() < PlacesOfScan && !this->IsTaken[seed])
    {
      places.push_back(this->FindPlace(seed));
    }
  }
  return places;
}

// The weak planes near one, as long as they have few returns together.
lms3dRegrouping::Place lms3dRegrouping::FindPlace(int seed)
{
  Place place;
  const auto add = [&](int number)
  {
    this->Planes[number].DropForgotten();
    place.AddOldPlane(number, this->Planes[number].Returns);
    this->IsTaken[number] = true;
  };
  add(seed);
  const double gap = LargestGap * this->Planes.GetMaximumError();
  for (const int number :
    this->Planes.FindPlanesNear(this->Planes.GetBox(static_cast<std::size_t>(seed)), gap))
  {
    if (!this->IsTaken[number] && this->IsCandidate(number) &&
      place.Returns.size() + this->Planes[number].Returns.size() <= LargestCountOfPlace)
    {
      add(number);
    }
  }
  return place;
}

void lms3dRegrouping::AddPlace(Place&& place)
{
  if (TrianglesOfPlane * place.Groups.size() + place.Left.size() <
    this->CountTriangles(place.OldPlanes))
  {
    place.NewPlanes.reserve(place.Groups.size());
    for (const lms3dReturnGroup& group : place.Groups)
    {
      place.NewPlanes.push_back(lms3dMakeRegroupedPlane(group, place.OldPlanes, this->Planes));
    }
    this->Places.push_back(std::move(place));
  }
}

// Gives the new planes their surface and their returns.
void lms3dRegrouping::FillPlanes()
{
  for (const Place& place : this->Places)
  {
    std::vector<lms3dWorldBox> boxes(place.NewPlanes.size());
    tbb::parallel_for(std::size_t{ 0 }, boxes.size(),
      [&](std::size_t i)
      {
        boxes[i] = lms3dFillRegroupedPlane(place.NewPlanes[i], place.Returns, place.Groups[i],
          place.OldPlanes, this->Tables, this->Planes);
      });
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      this->Planes.GrowBox(place.NewPlanes[i], boxes[i].Low);
      this->Planes.GrowBox(place.NewPlanes[i], boxes[i].High);
    }
  }
}

std::size_t lms3dRegrouping::CountTriangles(const std::vector<int>& numbers) const
{
  return std::accumulate(numbers.begin(), numbers.end(), std::size_t{ 0 },
    [this](std::size_t sum, int number) { return sum + this->Planes[number].CountTriangles(); });
}

// How many returns that are left get a facet if the old planes go.
std::size_t lms3dRegrouping::CountFacets(const Place& place) const
{
  lms3dCoveringPlanes search(this->Planes);
  return static_cast<std::size_t>(std::count_if(place.Left.begin(), place.Left.end(),
    [&](int i) {
      return search.Find(place.Returns[i], place.OldPlanes, this->Planes.GetMaximumError()) < 0;
    }));
}

// All planes that go are cleared before others get returns: the returns of a plane that goes would
// be lost.
void lms3dRegrouping::Choose()
{
  std::vector<lms3dMappedReturn> left;
  for (const Place& place : this->Places)
  {
    if (this->IsBetter(place))
    {
      this->Clear(place.OldPlanes);
      for (const int number : place.NewPlanes)
      {
        this->Planes[number].RegroupedTriangles = this->Planes[number].CountTriangles();
      }
      for (const int i : place.Left)
      {
        left.push_back(place.Returns[i]);
      }
    }
    else
    {
      this->Clear(place.NewPlanes);
    }
  }
  this->AddLeft(left);
  this->Places.clear();
}

bool lms3dRegrouping::IsBetter(const Place& place) const
{
  return this->CountTriangles(place.NewPlanes) + this->CountFacets(place) <
    this->CountTriangles(place.OldPlanes);
}

void lms3dRegrouping::Clear(const std::vector<int>& numbers)
{
  for (const int number : numbers)
  {
    this->Planes.Clear(number);
  }
}

void lms3dRegrouping::AddLeft(const std::vector<lms3dMappedReturn>& left)
{
  lms3dCoveringPlanes search(this->Planes);
  for (const lms3dMappedReturn& mapped : left)
  {
    this->Planes.AddBesideOrFacet(search.Find(mapped, {}, this->Planes.GetMaximumError()), mapped);
  }
}
