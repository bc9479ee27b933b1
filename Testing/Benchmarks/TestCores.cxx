// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cores.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
// Logical cores 0 and 4, 1 and 5, ... share hardware.
Cores GetPair(int core)
{
  return { core % 4, core % 4 + 4 };
}

constexpr const char* Stat = "cpu  1000 1000 1000 1000 1000 1000 1000 1000 0 0\n"
                             "cpu0 1 2 3 40 50 6 7 8 0 0\n"
                             "cpu1 100 0 0 900 0 0 0 0 0 0\n"
                             "cpu10 7 0 0 0 0 0 0 0 0 0\n"
                             "intr 12345 1 2 3\n";
} // namespace

TEST(Cores, AreReadFromLists)
{
  EXPECT_EQ(ParseCores("0-2,5\n"), (Cores{ 0, 1, 2, 5 }));
  EXPECT_EQ(ParseCores("7"), Cores{ 7 });
  EXPECT_EQ(ParseCores(""), Cores{});
  EXPECT_EQ(ParseCores("\n"), Cores{});
}

TEST(Cores, AreTheHighestThatShareNoHardware)
{
  const Cores all = { 0, 1, 2, 3, 4, 5, 6, 7 };
  EXPECT_EQ(ChooseCores(all, &GetPair, 2), (Cores{ 6, 7 }));
  EXPECT_EQ(ChooseCores({ 2, 3, 7 }, &GetPair, 2), (Cores{ 2, 7 }));
  EXPECT_EQ(ChooseCores({ 3, 7 }, &GetPair, 2), (Cores{ 3, 7 }));
  EXPECT_EQ(ChooseCores({ 5 }, &GetPair, 2), Cores{ 5 });
  EXPECT_EQ(ChooseCores(all, &GetPair, 0), all);
}

TEST(Cores, HaveTimes)
{
  const CoreTimes first = ParseCoreTimes(Stat, { 0 });
  EXPECT_EQ(first.Busy, 27.0);
  EXPECT_EQ(first.All, 117.0);
  const CoreTimes both = ParseCoreTimes(Stat, { 0, 1 });
  EXPECT_EQ(both.Busy, 127.0);
  EXPECT_EQ(both.All, 1117.0);
  EXPECT_EQ(ParseCoreTimes(Stat, { 2 }).All, 0.0);
  EXPECT_EQ(ParseCoreTimes("", { 0 }).All, 0.0);
}

TEST(Cores, AreQuietIfOthersTakeLittle)
{
  EXPECT_EQ(DescribeOthers(0.0), "");
  EXPECT_EQ(DescribeOthers(0.029), "");
  EXPECT_EQ(DescribeOthers(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(DescribeOthers(0.416),
    "The machine was not quiet: other processes took 42 % of the cores' time.");
}

TEST(Cores, HaveAShareOfOthers)
{
  const LoadMeter meter;
  volatile double sum = 0.0;
  for (int i = 0; i < 100000000; ++i)
  {
    sum = sum + 1.0;
  }
  const double share = meter.GetShareOfOthers();
  // NaN where /proc/stat is empty.
  EXPECT_FALSE(share < 0.0);
  EXPECT_FALSE(share > 1.0);
}
