// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientListener.h"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace
{
// Without a call for this time, the client checks that the server is still there.
constexpr std::chrono::seconds CheckPeriod(1);

// In a row. The server drops a listener after three failed calls.
constexpr int MaximumMissed = 5;

/// The ORB calls scanReady() in a thread of its own.
class Listener : public POA_LMS3D::ScanListener
{
public:
  void scanReady(const LMS3D::ScanHeader& header) override
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Newest = std::make_unique<LMS3D::ScanHeader>(header);
    }
    this->Changed.notify_one();
  }

  /// Returns null if no call comes within a second.
  std::unique_ptr<LMS3D::ScanHeader> Wait()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait_for(lock, CheckPeriod, [this] { return this->Newest != nullptr; });
    return std::move(this->Newest);
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  std::unique_ptr<LMS3D::ScanHeader> Newest;
};

/// If no call comes, asks the server for its status, because a server that has ended cannot
/// announce that.
class Subscription
{
public:
  Subscription(LMS3D::LaserScanner_ptr scanner, LMS3D::ScanListener_ptr listener)
    : Scanner(LMS3D::LaserScanner::_duplicate(scanner))
    , Number(scanner->subscribe(listener))
    , Status(scanner->getStatus())
    , LastNumber(this->Status->newest)
  {
  }

  LMS3D::ScanHeader WaitForNext(Listener& listener)
  {
    int missed = 0;
    std::unique_ptr<LMS3D::ScanHeader> header = listener.Wait();
    for (; !header; header = listener.Wait())
    {
      missed = this->IsScanMissed() ? missed + 1 : 0;
      if (missed == MaximumMissed)
      {
        throw std::runtime_error(
          "the server makes scans but does not call this listener. It connects "
          "only to 127.0.0.1 and to the addresses of its option --connect-to");
      }
    }
    this->LastNumber = header->number;
    return *header;
  }

  void End() const { this->Scanner->unsubscribe(this->Number); }

private:
  bool IsScanMissed() const
  {
    const LMS3D::Status_var now = this->Scanner->getStatus();
    if (now->incarnation != this->Status->incarnation)
    {
      throw std::runtime_error("the server was restarted, so the subscription is lost");
    }
    return now->newest > this->LastNumber;
  }

  const LMS3D::LaserScanner_var Scanner;
  const CORBA::ULong Number;
  const LMS3D::Status_var Status;
  CORBA::ULongLong LastNumber;
};
} // namespace

void lms3dListenToScanner(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner,
  CORBA::ULongLong count, const std::function<void(const LMS3D::ScanHeader&)>& use)
{
  const CORBA::Object_var object = orb->resolve_initial_references("RootPOA");
  const PortableServer::POA_var adapter = PortableServer::POA::_narrow(object);
  const PortableServer::Servant_var<Listener> listener = new Listener;
  const PortableServer::ObjectId_var id = adapter->activate_object(listener);
  const PortableServer::POAManager_var manager = adapter->the_POAManager();
  manager->activate();

  const LMS3D::ScanListener_var reference = listener->_this();
  Subscription subscription(scanner, reference);
  for (; count > 0; --count)
  {
    use(subscription.WaitForNext(*listener));
  }
  subscription.End();
}
