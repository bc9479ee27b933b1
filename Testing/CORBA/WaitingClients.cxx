// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "WaitingClients.h"

#include "ClientORB.h"

#include <gtest/gtest.h>

#include <chrono>

WaitingClients::WaitingClients(const std::string& reference)
  : Scanner(Connect(reference))
{
  constexpr int Many = 40;
  this->Clients.reserve(Many);
  for (int i = 0; i < Many; ++i)
  {
    this->Clients.emplace_back([this] { this->Wait(); });
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (this->Refused == 0 && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_GT(this->Refused, 0);
}

WaitingClients::~WaitingClients()
{
  this->IsOver = true;
  for (std::thread& client : this->Clients)
  {
    client.join();
  }
}

// When a call times out, one that was refused takes its place.
void WaitingClients::Wait()
{
  constexpr CORBA::ULongLong Never = ~CORBA::ULongLong(0);
  while (!this->IsOver)
  {
    try
    {
      this->Scanner->waitForScan(Never, 0, 1000);
    }
    catch (const LMS3D::NoScanYet&)
    {
      continue;
    }
    catch (const LMS3D::LimitExceeded&)
    {
      ++this->Refused;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
}
