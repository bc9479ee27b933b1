// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Several processes of vtkMultiProcessController, each a thread of the test.
 */
#ifndef ThreadProcesses_h
#define ThreadProcesses_h

#include <vtkMultiProcessController.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

/// Returns the controllers of `count` processes that exchange messages in memory.
std::vector<vtkSmartPointer<vtkMultiProcessController>> MakeProcesses(int count);

/// Calls `run` with each rank, all at the same time, and returns when all are done.
void RunProcesses(int count, const std::function<void(int)>& run);

#endif
