// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Listeners for tests: some that answer, and some that do not.
 */
#ifndef ClientListener_h
#define ClientListener_h

#include "LMS3DScanner.hh"

#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include <netinet/in.h>

/// Counts the calls of scanReady().
class Counter : public POA_LMS3D::ScanListener
{
public:
  void scanReady(const LMS3D::ScanHeader& header) override;

  bool WaitFor(int count);
  int GetCount() const;
  ///@{
  /// The smallest and largest difference of scan numbers from one call to the next.
  CORBA::LongLong GetMinimumStep() const;
  CORBA::LongLong GetMaximumStep() const;
  ///@}

private:
  std::vector<CORBA::LongLong> GetSteps() const;

  mutable std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<CORBA::ULongLong> Numbers;
};

/// A listener that exists as long as this object.
class ActiveListener
{
public:
  ActiveListener();
  ~ActiveListener();
  ActiveListener(const ActiveListener&) = delete;
  void operator=(const ActiveListener&) = delete;

  Counter* operator->() { return this->Servant.in(); }
  LMS3D::ScanListener_var GetReference() { return this->Servant->_this(); }

private:
  PortableServer::POA_var Adapter;
  PortableServer::Servant_var<Counter> Servant;
  PortableServer::ObjectId_var Id;
};

/// A port of this machine that never answers.
class SilentPort
{
public:
  /// If `isFull`, connections are not accepted. Otherwise they are accepted but never answered.
  explicit SilentPort(bool isFull = false, const char* address = "127.0.0.1");
  ~SilentPort();
  SilentPort(const SilentPort&) = delete;
  void operator=(const SilentPort&) = delete;

  /// A reference to an object at this port.
  LMS3D::ScanListener_var GetReference() const;
  bool IsConnectedTo(int milliseconds) const;

private:
  int Socket;
  sockaddr_in Address = {};
  std::vector<int> Fillers;
};

/// A reference to an object that does not exist, at an address such as "127.0.0.1:2810".
LMS3D::ScanListener_var MakeReference(const std::string& address);

/// Waits until the server has `count` listeners. Returns false if that takes too long.
bool HasListeners(LMS3D::LaserScanner_ptr scanner, CORBA::ULong count);

#endif
