// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientListener.h"

#include <condition_variable>
#include <mutex>

namespace
{
/// The ORB calls scanReady() on a thread of its own.
class Listener : public POA_LMS3D::ScanListener
{
public:
  void scanReady(const LMS3D::ScanHeader& header) override
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Newest = header;
      this->IsNew = true;
    }
    this->Changed.notify_one();
  }

  LMS3D::ScanHeader Wait()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this] { return this->IsNew; });
    this->IsNew = false;
    return this->Newest;
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  LMS3D::ScanHeader Newest;
  bool IsNew = false;
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
  const CORBA::ULong subscription = scanner->subscribe(reference);
  for (; count > 0; --count)
  {
    use(listener->Wait());
  }
  scanner->unsubscribe(subscription);
}
