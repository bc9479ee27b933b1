// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientORB.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>

namespace
{
class Counter : public POA_LMS3D::ScanListener
{
public:
  void scanReady(const LMS3D::ScanHeader& header) override
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->IsGrowing = this->IsGrowing && header.number > this->Newest;
      this->Newest = header.number;
      ++this->Count;
    }
    this->Changed.notify_all();
  }

  bool WaitFor(int count)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    return this->Changed.wait_for(
      lock, std::chrono::seconds(10), [this, count] { return this->Count >= count; });
  }

  int GetCount() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Count;
  }

  bool IsInOrder() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->IsGrowing;
  }

private:
  mutable std::mutex Mutex;
  std::condition_variable Changed;
  CORBA::ULongLong Newest = 0;
  int Count = 0;
  bool IsGrowing = true;
};

PortableServer::POA_var GetAdapter()
{
  const CORBA::Object_var object = GetClientORB()->resolve_initial_references("RootPOA");
  PortableServer::POA_var adapter = PortableServer::POA::_narrow(object);
  const PortableServer::POAManager_var manager = adapter->the_POAManager();
  manager->activate();
  return adapter;
}

/// A listener that is there while this lives.
class ActiveListener
{
public:
  ActiveListener()
    : Adapter(GetAdapter())
    , Servant(new Counter)
    , Id(this->Adapter->activate_object(this->Servant))
  {
  }
  ~ActiveListener() { this->Adapter->deactivate_object(this->Id); }
  ActiveListener(const ActiveListener&) = delete;
  void operator=(const ActiveListener&) = delete;

  Counter* operator->() { return this->Servant.in(); }
  LMS3D::ScanListener_var GetReference() { return this->Servant->_this(); }

private:
  PortableServer::POA_var Adapter;
  PortableServer::Servant_var<Counter> Servant;
  PortableServer::ObjectId_var Id;
};

} // namespace

TEST(ServerCallbacks, AreOffUnlessAskedFor)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  ActiveListener listener;
  EXPECT_THROW(scanner->subscribe(listener.GetReference()), LMS3D::NotPermitted);
  const LMS3D::Status_var status = scanner->getStatus();
  EXPECT_FALSE(status->hasCallbacks);
  EXPECT_EQ(listener->GetCount(), 0);
}

TEST(ServerCallbacks, TellOfEachScanUntilUnsubscribed)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  ActiveListener listener;
  const CORBA::ULong subscription = scanner->subscribe(listener.GetReference());
  EXPECT_TRUE(listener->WaitFor(5));
  EXPECT_TRUE(listener->IsInOrder());
  scanner->unsubscribe(subscription);
  EXPECT_THROW(scanner->unsubscribe(subscription), LMS3D::InvalidArgument);
  // One may be on its way.
  const int count = listener->GetCount();
  const LMS3D::ScanHeader_var later = scanner->waitForScan(WaitFor(scanner).number + 3, 0, 5000);
  EXPECT_LE(listener->GetCount(), count + 1);
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}

TEST(ServerCallbacks, TakeNoMoreThanSixteenAndNoNil)
{
  ServerProcess server({ "--callbacks" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  EXPECT_THROW(scanner->subscribe(LMS3D::ScanListener::_nil()), LMS3D::InvalidArgument);
  ActiveListener listener;
  for (int i = 0; i < 16; ++i)
  {
    scanner->subscribe(listener.GetReference());
  }
  EXPECT_THROW(scanner->subscribe(listener.GetReference()), LMS3D::LimitExceeded);
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}
