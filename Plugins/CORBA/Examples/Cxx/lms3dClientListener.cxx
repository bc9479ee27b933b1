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
// How soon the end of a server is noticed.
constexpr std::chrono::seconds Quiet(1);

// In a row: the server leaves a listener out after three scans that it cannot tell.
constexpr int MostMissed = 5;

/// The ORB calls scanReady() on a thread of its own.
class Listener : public POA_LMS3D::ScanListener
{
public:
  void scanReady(const LMS3D::ScanHeader& header) override
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->News = std::make_unique<LMS3D::ScanHeader>(header);
    }
    this->Changed.notify_one();
  }

  /// Null where it stays quiet.
  std::unique_ptr<LMS3D::ScanHeader> Wait()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait_for(lock, Quiet, [this] { return this->News != nullptr; });
    return std::move(this->News);
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  std::unique_ptr<LMS3D::ScanHeader> News;
};

/// A server that is gone tells nobody of it, so who hears nothing asks.
class Subscription
{
public:
  Subscription(LMS3D::LaserScanner_ptr scanner, LMS3D::ScanListener_ptr listener)
    : Scanner(LMS3D::LaserScanner::_duplicate(scanner))
    , Status(scanner->getStatus())
    , Told(this->Status->newest)
    , Number(scanner->subscribe(listener))
  {
  }

  LMS3D::ScanHeader WaitForNext(Listener& listener)
  {
    int missed = 0;
    std::unique_ptr<LMS3D::ScanHeader> header = listener.Wait();
    for (; !header; header = listener.Wait())
    {
      missed = this->IsScanMissed() ? missed + 1 : 0;
      if (missed == MostMissed)
      {
        throw std::runtime_error(
          "the server has scans but does not tell this listener; it connects "
          "to 127.0.0.1 and to what --connect-to adds");
      }
    }
    this->Told = header->number;
    return *header;
  }

  void End() const { this->Scanner->unsubscribe(this->Number); }

private:
  bool IsScanMissed() const
  {
    const LMS3D::Status_var now = this->Scanner->getStatus();
    if (now->incarnation != this->Status->incarnation)
    {
      throw std::runtime_error("the server was started anew, and does not know this listener");
    }
    return now->newest > this->Told;
  }

  const LMS3D::LaserScanner_var Scanner;
  const LMS3D::Status_var Status;
  CORBA::ULongLong Told;
  const CORBA::ULong Number;
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
