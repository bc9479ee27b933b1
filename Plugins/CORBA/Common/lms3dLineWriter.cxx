// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dLineWriter.h"

#include "Common/lms3dThreadWithoutSignals.h"

#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <utility>

#include <poll.h>
#include <unistd.h>

namespace
{
// Another program that shares the terminal may have made it non-blocking.
void WaitUntilWritable(int file)
{
  pollfd waiting = { file, POLLOUT, 0 };
  poll(&waiting, 1, -1);
}

// If the reader is gone, the text is lost.
void WriteAll(int file, const std::string& text)
{
  std::size_t written = 0;
  while (written < text.size())
  {
    const ssize_t count = write(file, text.data() + written, text.size() - written);
    if (count >= 0)
    {
      written += static_cast<std::size_t>(count);
    }
    else if (errno == EAGAIN)
    {
      WaitUntilWritable(file);
    }
    else if (errno != EINTR)
    {
      return;
    }
  }
}
} // namespace

class lms3dLineWriter::Queue
{
public:
  Queue(int file, Describe describe)
    : File(file)
    , DescribeLeftOut(std::move(describe))
  {
  }

  void Add(const std::string& line)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (this->LeftOut != 0 || this->Waiting.size() + line.size() >= MaximumBytes)
      {
        ++this->LeftOut;
      }
      else
      {
        this->Waiting.append(line).push_back('\n');
      }
    }
    this->Changed.notify_all();
  }

  bool WaitUntilWritten(std::chrono::milliseconds timeout)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    return this->Changed.wait_for(
      lock, timeout, [this] { return !this->HasLines() && !this->IsWriting; });
  }

  void End()
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Ended = true;
    }
    this->Changed.notify_all();
  }

  void Run()
  {
    for (std::string text = this->Take(); !text.empty(); text = this->Take())
    {
      WriteAll(this->File, text);
    }
  }

private:
  // Returns nothing when the thread is to end.
  std::string Take()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->IsWriting = false;
    this->Changed.notify_all();
    this->Changed.wait(lock, [this] { return this->Ended || this->HasLines(); });
    std::string text = std::exchange(this->Waiting, {});
    if (this->LeftOut != 0)
    {
      text.append(this->DescribeLeftOut(std::exchange(this->LeftOut, 0))).push_back('\n');
    }
    this->IsWriting = !text.empty();
    return text;
  }

  bool HasLines() const { return !this->Waiting.empty() || this->LeftOut != 0; }

  const int File;
  const Describe DescribeLeftOut;
  std::mutex Mutex;
  std::condition_variable Changed;
  std::string Waiting;
  std::size_t LeftOut = 0;
  bool IsWriting = false;
  bool Ended = false;
};

lms3dLineWriter::lms3dLineWriter(int file, Describe describe)
  : Lines(std::make_shared<Queue>(file, std::move(describe)))
{
  // The signals of the process are for other threads, and a closed pipe is no reason to end.
  lms3dStartThreadWithoutSignals([lines = this->Lines] { lines->Run(); }).detach();
}

lms3dLineWriter::~lms3dLineWriter()
{
  this->Lines->End();
}

void lms3dLineWriter::Write(const std::string& line)
{
  this->Lines->Add(line);
}

bool lms3dLineWriter::Flush(std::chrono::milliseconds timeout)
{
  return this->Lines->WaitUntilWritten(timeout);
}
