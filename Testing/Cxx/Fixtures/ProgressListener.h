// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Calls a function in each progress event of an algorithm.
 */
#ifndef ProgressListener_h
#define ProgressListener_h

#include <functional>

class vtkAlgorithm;

/// Listens until it is destroyed. The algorithm must live longer.
class ProgressListener
{
public:
  ProgressListener(vtkAlgorithm* algorithm, std::function<void(double)> react);
  ProgressListener(const ProgressListener&) = delete;
  ProgressListener& operator=(const ProgressListener&) = delete;
  ~ProgressListener();

private:
  vtkAlgorithm* Algorithm;
  std::function<void(double)> React;
  unsigned long Tag;
};

#endif
