// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/ThreadProcesses.h"

#include <vtkAbstractArray.h>
#include <vtkCommunicator.h>
#include <vtkDummyController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <tuple>

namespace
{
using Message = std::vector<char>;

/// The messages on their way, by sender, receiver and tag.
class Mail
{
public:
  using Way = std::tuple<int, int, int>;

  void Send(const Way& way, Message message)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Messages[way].push_back(std::move(message));
    this->Arrived.notify_all();
  }

  Message Receive(const Way& way)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    std::deque<Message>& messages = this->Messages[way];
    this->Arrived.wait(lock, [&messages] { return !messages.empty(); });
    Message message = std::move(messages.front());
    messages.pop_front();
    return message;
  }

private:
  std::mutex Mutex;
  std::condition_variable Arrived;
  std::map<Way, std::deque<Message>> Messages;
};

class ThreadCommunicator : public vtkCommunicator
{
public:
  static ThreadCommunicator* New();
  vtkTypeMacro(ThreadCommunicator, vtkCommunicator);

  void Join(std::shared_ptr<Mail> mail, int rank, int count)
  {
    this->Messages = std::move(mail);
    this->MaximumNumberOfProcesses = count;
    this->NumberOfProcesses = count;
    this->LocalProcessId = rank;
  }

  int SendVoidArray(const void* data, vtkIdType length, int type, int to, int tag) override
  {
    const char* first = static_cast<const char*>(data);
    const std::ptrdiff_t bytes = length * vtkAbstractArray::GetDataTypeSize(type);
    this->Messages->Send({ this->LocalProcessId, to, tag }, Message(first, first + bytes));
    return 1;
  }

  int ReceiveVoidArray(void* data, vtkIdType length, int type, int from, int tag) override
  {
    const Message message = this->Messages->Receive({ from, this->LocalProcessId, tag });
    std::copy(message.begin(), message.end(), static_cast<char*>(data));
    this->Count = length;
    static_cast<void>(type);
    return 1;
  }

private:
  std::shared_ptr<Mail> Messages;
};

vtkStandardNewMacro(ThreadCommunicator);
} // namespace

std::vector<vtkSmartPointer<vtkMultiProcessController>> MakeProcesses(int count)
{
  const auto mail = std::make_shared<Mail>();
  std::vector<vtkSmartPointer<vtkMultiProcessController>> processes;
  for (int rank = 0; rank < count; ++rank)
  {
    vtkNew<ThreadCommunicator> communicator;
    communicator->Join(mail, rank, count);
    vtkNew<vtkDummyController> controller;
    controller->SetCommunicator(communicator);
    processes.push_back(controller.Get());
  }
  return processes;
}

void RunProcesses(int count, const std::function<void(int)>& run)
{
  std::vector<std::thread> threads;
  threads.reserve(count);
  for (int rank = 0; rank < count; ++rank)
  {
    threads.emplace_back(run, rank);
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}
