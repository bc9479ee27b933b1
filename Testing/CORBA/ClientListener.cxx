// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientListener.h"

#include "ClientORB.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <numeric>
#include <thread>

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace
{
PortableServer::POA_var GetAdapter()
{
  const CORBA::Object_var object = GetClientORB()->resolve_initial_references("RootPOA");
  PortableServer::POA_var adapter = PortableServer::POA::_narrow(object);
  const PortableServer::POAManager_var manager = adapter->the_POAManager();
  manager->activate();
  return adapter;
}
} // namespace

void Counter::scanReady(const LMS3D::ScanHeader& header)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Numbers.push_back(header.number);
  }
  this->Changed.notify_all();
}

bool Counter::WaitFor(int count)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  return this->Changed.wait_for(lock, std::chrono::seconds(60),
    [this, count] { return static_cast<int>(this->Numbers.size()) >= count; });
}

int Counter::GetCount() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return static_cast<int>(this->Numbers.size());
}

CORBA::LongLong Counter::GetMinimumStep() const
{
  const std::vector<CORBA::LongLong> steps = this->GetSteps();
  return *std::min_element(steps.begin(), steps.end());
}

CORBA::LongLong Counter::GetMaximumStep() const
{
  const std::vector<CORBA::LongLong> steps = this->GetSteps();
  return *std::max_element(steps.begin(), steps.end());
}

std::vector<CORBA::LongLong> Counter::GetSteps() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  std::vector<CORBA::LongLong> steps(this->Numbers.begin(), this->Numbers.end());
  std::adjacent_difference(steps.begin(), steps.end(), steps.begin());
  // The first difference is the first number itself.
  steps.erase(steps.begin());
  return steps;
}

ActiveListener::ActiveListener()
  : Adapter(GetAdapter())
  , Servant(new Counter)
  , Id(this->Adapter->activate_object(this->Servant))
{
}

ActiveListener::~ActiveListener()
{
  this->Adapter->deactivate_object(this->Id);
}

SilentPort::SilentPort(bool isFull, const char* address)
  : Socket(socket(AF_INET, SOCK_STREAM, 0))
{
  this->Address.sin_family = AF_INET;
  inet_pton(AF_INET, address, &this->Address.sin_addr);
  socklen_t size = sizeof(this->Address);
  auto* const name = reinterpret_cast<sockaddr*>(&this->Address);
  EXPECT_EQ(bind(this->Socket, name, size), 0);
  EXPECT_EQ(listen(this->Socket, isFull ? 0 : 8), 0);
  EXPECT_EQ(getsockname(this->Socket, name, &size), 0);
  // The kernel accepts some connections more than the backlog.
  while (isFull && this->Fillers.size() < 4)
  {
    this->Fillers.push_back(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0));
    EXPECT_TRUE(connect(this->Fillers.back(), name, size) == 0 || errno == EINPROGRESS);
  }
}

SilentPort::~SilentPort()
{
  std::for_each(this->Fillers.begin(), this->Fillers.end(), close);
  close(this->Socket);
}

LMS3D::ScanListener_var SilentPort::GetReference() const
{
  return MakeReference(std::string(inet_ntoa(this->Address.sin_addr)) + ":" +
    std::to_string(ntohs(this->Address.sin_port)));
}

bool SilentPort::IsConnectedTo(int milliseconds) const
{
  pollfd waiting = { this->Socket, POLLIN, 0 };
  return poll(&waiting, 1, milliseconds) == 1;
}

LMS3D::ScanListener_var MakeReference(const std::string& address)
{
  const std::string uri = "corbaloc:iiop:1.2@" + address + "/Nothing";
  const CORBA::Object_var object = GetClientORB()->string_to_object(uri.c_str());
  return LMS3D::ScanListener::_unchecked_narrow(object);
}

bool HasListeners(LMS3D::LaserScanner_ptr scanner, CORBA::ULong count)
{
  for (int i = 0; i < 600; ++i)
  {
    const LMS3D::Status_var status = scanner->getStatus();
    if (status->listening == count)
    {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}
