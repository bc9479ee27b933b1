// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderChains.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <stdexcept>

namespace
{
// The number of edges that a thread looks at, at least.
constexpr int EdgesOfTask = 2048;
} // namespace

lms3dBorderChains::lms3dBorderChains(const lms3dBorderGates& gates)
  : Gates(gates)
{
  this->FindChains();
}

void lms3dBorderChains::FindChains()
{
  const int edges = this->Gates.GetNumberOfEdges();
  this->Before.assign(edges, lms3dBorderGates::NoGate);
  this->ChainOf.assign(edges, lms3dBorderGates::NoGate);
  for (int edge = 0; edge < edges; ++edge)
  {
    const int next = this->Gates.GetNext(edge);
    if (next != lms3dBorderGates::NoGate)
    {
      this->Before[next] = edge;
    }
  }
  this->FindStarts();
  for (const bool isOpen : { true, false })
  {
    for (int edge = 0; edge < edges; ++edge)
    {
      if (!this->IsVisited[edge] && (!isOpen || this->IsStart[edge]))
      {
        this->AddChain(edge);
      }
    }
  }
}

// No chain begins with a void edge.
void lms3dBorderChains::FindStarts()
{
  this->IsStart.assign(this->Before.size(), 0);
  this->IsVisited.assign(this->Before.size(), 1);
  tbb::parallel_for(tbb::blocked_range<int>(0, static_cast<int>(this->Before.size()), EdgesOfTask),
    [this](const tbb::blocked_range<int>& edges)
    {
      for (int edge = edges.begin(); edge < edges.end(); ++edge)
      {
        const int before = this->Before[edge];
        if (before != lms3dBorderGates::NoGate)
        {
          this->IsStart[edge] = this->Gates.IsRegular(before) ? 0 : 1;
          this->IsVisited[edge] = 0;
        }
      }
    });
}

void lms3dBorderChains::AddChain(int first)
{
  const bool isShared = this->Gates.GetGate(first).Kind != lms3dBorderGates::DepthStep;
  this->EdgesOfChain.clear();
  int edge = first;
  do
  {
    this->EdgesOfChain.push_back(edge);
    this->IsVisited[edge] = 1;
    if (isShared)
    {
      this->IsVisited[lms3dBorderGates::GetTwin(edge)] = 1;
    }
    if (this->EdgesOfChain.size() > this->IsVisited.size())
    {
      throw std::runtime_error(
        "The borders of the map do not close, because the points of the scan "
        "do not belong to its angles. Connect the first output of "
        "vtkLMS3DScanFilter.");
    }
    edge = this->Gates.GetNext(edge);
  } while (edge != first && !this->IsStart[edge]);

  const std::int32_t number = static_cast<std::int32_t>(this->Chains.size());
  this->ChainOf[first] = 2 * number;
  if (isShared)
  {
    this->ChainOf[lms3dBorderGates::GetTwin(this->EdgesOfChain.back())] = 2 * number + 1;
  }
  this->Chains.push_back({ this->EdgesOfChain, this->IsStart[first] == 0 });
}
