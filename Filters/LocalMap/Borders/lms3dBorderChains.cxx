// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dBorderChains.h"

#include <stdexcept>
#include <utility>

lms3dBorderChains::lms3dBorderChains(const lms3dBorderGates& gates)
  : Gates(gates)
{
  this->FindChains();
}

bool lms3dBorderChains::IsStart(int edge) const
{
  return !this->Gates.IsRegular(this->Before[edge]);
}

void lms3dBorderChains::FindChains()
{
  const int edges = this->Gates.GetNumberOfEdges();
  this->Before.assign(edges, lms3dBorderGates::NoGate);
  this->ChainOf.assign(edges, lms3dBorderGates::NoGate);
  for (int edge = 0; edge < edges; ++edge)
  {
    if (!this->Gates.IsVoid(edge))
    {
      this->Before[this->Gates.GetNext(edge)] = edge;
    }
  }
  std::vector<bool> visited(edges, false);
  for (const bool isOpen : { true, false })
  {
    for (int edge = 0; edge < edges; ++edge)
    {
      if (!this->Gates.IsVoid(edge) && !visited[edge] && (!isOpen || this->IsStart(edge)))
      {
        this->AddChain(edge, visited);
      }
    }
  }
}

void lms3dBorderChains::AddChain(int first, std::vector<bool>& visited)
{
  const bool isShared = this->Gates.GetGate(first).Kind != lms3dBorderGates::DepthStep;
  Chain chain;
  chain.IsClosed = !this->IsStart(first);
  int edge = first;
  do
  {
    chain.Edges.push_back(edge);
    visited[edge] = true;
    if (isShared)
    {
      visited[lms3dBorderGates::GetTwin(edge)] = true;
    }
    if (chain.Edges.size() > visited.size())
    {
      throw std::runtime_error(
        "The borders of the map do not close, because the points of the scan "
        "do not belong to its angles. Connect the first output of "
        "vtkLMS3DScanFilter.");
    }
    edge = this->Gates.GetNext(edge);
  } while (edge != first && !this->IsStart(edge));

  const std::int32_t number = static_cast<std::int32_t>(this->Chains.size());
  this->ChainOf[first] = 2 * number;
  if (isShared)
  {
    this->ChainOf[lms3dBorderGates::GetTwin(chain.Edges.back())] = 2 * number + 1;
  }
  this->Chains.push_back(std::move(chain));
}
