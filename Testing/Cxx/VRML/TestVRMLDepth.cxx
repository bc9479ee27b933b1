// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Grammar/lms3dVRMLContext.h"

#include "VRML/VRMLFixtures.h"

#include <pthread.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{
using VRMLDepth = VRMLScene;

// Sanitizers make stack frames several times as large.
#ifdef LMS3D_FEWER_BEAMS
constexpr std::size_t StackSize = std::size_t(16) << 20;
#else
constexpr std::size_t StackSize = std::size_t(1) << 20;
#endif

void RunOnStack(std::size_t size, const std::function<void()>& function)
{
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, size), 0);
  pthread_t thread;
  const auto run = [](void* argument) -> void*
  {
    (*static_cast<const std::function<void()>*>(argument))();
    return nullptr;
  };
  ASSERT_EQ(
    pthread_create(&thread, &attributes, run, const_cast<std::function<void()>*>(&function)), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

std::string Repeat(const std::string& text, int count)
{
  std::string result;
  for (int i = 0; i < count; ++i)
  {
    result += text;
  }
  return result;
}
} // namespace

TEST_F(VRMLDepth, NeedsAStackOfOneMebibyteAtMost)
{
  for (const auto& marks : std::vector<std::pair<std::string, std::string>>{
         { "DEF A Group { children [ ", "] } " }, { "Transform { children ", "} " },
         { "Group { Group { } ", "} " }, { "Switch { whichChoice 0 choice ", "} " },
         { "PROTO P [ ] { ", "} " }, { "PROTO P [ field MFNode n [ ", "] ] { } " },
         { "Script { field MFNode n [ PROTO P [ field SFNode n ", "] { } ] } " } })
  {
    for (const int depth : { lms3dVRMLMaximumDepth - 10, lms3dVRMLMaximumDepth + 10 })
    {
      const std::string text =
        SquareShape + Repeat(marks.first, depth) + SquareShape + Repeat(marks.second, depth);
      RunOnStack(StackSize, [&] { EXPECT_GE(GetArea(this->Read(text)), 1.0) << marks.first; });
    }
  }
}
