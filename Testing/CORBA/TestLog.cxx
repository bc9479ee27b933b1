// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dLineWriter.h"
#include "Common/lms3dLog.h"
#include "Common/lms3dLogLimit.h"
#include "Scanning/lms3dLogWindow.h"

#include <gtest/gtest.h>

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSetGet.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace
{
constexpr std::chrono::milliseconds Shortly(50);
constexpr std::chrono::seconds Long(20);

/// A pipe of 4,096 bytes. The writing end stays open, because a thread may still use it.
class SmallPipe
{
public:
  SmallPipe()
  {
    EXPECT_EQ(pipe(this->Ends), 0);
    EXPECT_EQ(fcntl(this->Ends[1], F_SETPIPE_SZ, 4096), 4096);
  }
  ~SmallPipe() { this->CloseReader(); }
  SmallPipe(const SmallPipe&) = delete;
  void operator=(const SmallPipe&) = delete;

  int GetWriter() const { return this->Ends[1]; }

  void CloseReader()
  {
    if (this->Ends[0] >= 0)
    {
      close(this->Ends[0]);
      this->Ends[0] = -1;
    }
  }

  /// Until a thread has begun to write.
  void WaitForText() const
  {
    pollfd waiting = { this->Ends[0], POLLIN, 0 };
    EXPECT_EQ(poll(&waiting, 1, -1), 1);
  }

  /// Everything up to the end of a line that contains `last`.
  std::string ReadUntil(const std::string& last) const
  {
    std::string text;
    char buffer[4096];
    while (text.find('\n', text.find(last)) == std::string::npos)
    {
      const ssize_t count = read(this->Ends[0], buffer, sizeof(buffer));
      if (count <= 0)
      {
        ADD_FAILURE() << "the pipe ended before " << last;
        break;
      }
      text.append(buffer, static_cast<std::size_t>(count));
    }
    return text;
  }

private:
  int Ends[2] = { -1, -1 };
};

std::string Describe(std::size_t count)
{
  return "left out: " + std::to_string(count);
}

std::vector<std::string> Logged;

void Collect(const std::string& line)
{
  Logged.push_back(line);
}
} // namespace

TEST(Log, ALineIsWritten)
{
  const SmallPipe pipe;
  lms3dLineWriter writer(pipe.GetWriter(), Describe);
  writer.Write("first");
  writer.Write("second");
  EXPECT_TRUE(writer.Flush(Long));
  EXPECT_EQ(pipe.ReadUntil("second\n"), "first\nsecond\n");
}

TEST(Log, LinesThatAreNotReadAreLeftOutAndCounted)
{
  const SmallPipe pipe;
  lms3dLineWriter writer(pipe.GetWriter(), Describe);
  // Blocks the thread.
  writer.Write(std::string(10000, 'y'));
  pipe.WaitForText();
  EXPECT_FALSE(writer.Flush(Shortly));
  const std::string line(999, 'x');
  constexpr int Number = 1000;
  for (int i = 0; i < Number; ++i)
  {
    writer.Write(line);
  }
  const std::string text = pipe.ReadUntil("left out: ");
  const auto written = std::count(text.begin(), text.end(), 'x') / 999;
  EXPECT_EQ(written, static_cast<long>(lms3dLineWriter::MaximumBytes / 1000));
  EXPECT_NE(text.find("\nleft out: " + std::to_string(Number - written) + "\n"), std::string::npos);
  // The next line is written again.
  writer.Write("later");
  EXPECT_EQ(pipe.ReadUntil("later\n"), "later\n");
}

TEST(Log, ALineThatIsTooLongIsLeftOut)
{
  const SmallPipe pipe;
  lms3dLineWriter writer(pipe.GetWriter(), Describe);
  writer.Write(std::string(lms3dLineWriter::MaximumBytes, 'x'));
  EXPECT_EQ(pipe.ReadUntil("\n"), "left out: 1\n");
}

TEST(Log, AReaderThatIsGoneEndsNothing)
{
  SmallPipe pipe;
  lms3dLineWriter writer(pipe.GetWriter(), Describe);
  pipe.CloseReader();
  writer.Write("lost");
  EXPECT_TRUE(writer.Flush(Long));
}

TEST(Log, AWriterThatIsBlockedCanBeDestroyed)
{
  const SmallPipe pipe;
  lms3dLineWriter writer(pipe.GetWriter(), Describe);
  writer.Write(std::string(10000, 'x'));
  EXPECT_FALSE(writer.Flush(Shortly));
}

TEST(Log, LinesOfOneKindAreLimitedAndCounted)
{
  Logged.clear();
  lms3dLogLimit limit("clients", Collect);
  constexpr int Number = 100;
  for (int i = 0; i < Number; ++i)
  {
    limit.Write("line");
  }
  ASSERT_EQ(Logged.size(), lms3dLogLimit::MaximumPerSecond + 1u);
  EXPECT_EQ(Logged.back(), "clients: more lines in this second; these lines are left out");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  limit.Write("later");
  ASSERT_EQ(Logged.size(), lms3dLogLimit::MaximumPerSecond + 3u);
  EXPECT_EQ(Logged[Logged.size() - 2], "clients: 80 lines were left out");
  EXPECT_EQ(Logged.back(), "later");
  limit.Report();
  EXPECT_EQ(Logged.back(), "later");
}

TEST(Log, TextsOfClientsForgeNoLines)
{
  EXPECT_EQ(lms3dMakePrintable("a b~"), "a b~");
  EXPECT_EQ(lms3dMakePrintable("host\n2026-01-01 forged"), "host\\n2026-01-01 forged");
  EXPECT_EQ(lms3dMakePrintable("\x1b[2J\r\x7f\xc3\xbc"), "\\x1b[2J\\x0d\\x7f\\xc3\\xbc");
  EXPECT_EQ(lms3dMakePrintable(std::string(5000, 'x')), std::string(1000, 'x') + "...");
}

TEST(Log, VTKsMessagesAreLines)
{
  testing::internal::CaptureStderr();
  lms3dLogVTKMessages();
  vtkGenericWarningMacro(<< "of several\nlines");
  lms3dFinishLog();
  const std::string log = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 1) << log;
  EXPECT_NE(log.find("of several\\nlines"), std::string::npos) << log;

  testing::internal::CaptureStderr();
  for (int i = 0; i < 100; ++i)
  {
    vtkGenericWarningMacro(<< "many");
  }
  lms3dFinishLog();
  const std::string many = testing::internal::GetCapturedStderr();
  EXPECT_NE(many.find("VTK: more lines in this second"), std::string::npos) << many;
  vtkOutputWindow::SetInstance(nullptr);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
}
