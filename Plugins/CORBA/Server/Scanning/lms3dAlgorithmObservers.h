// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Aborts VTK algorithms, and collects their messages.
 */
#ifndef lms3dAlgorithmObservers_h
#define lms3dAlgorithmObservers_h

#include <functional>
#include <memory>
#include <string>

class vtkAlgorithm;

/// Returns true if the work is to end. May be called from any thread.
using lms3dStopTest = std::function<bool()>;

/// Calls `isStopped` at each progress event of `algorithm`, and aborts the algorithm if it returns
/// true.
void lms3dAbortIf(vtkAlgorithm* algorithm, const lms3dStopTest& isStopped);

/// Collects errors and warnings of an algorithm and of its executive, which VTK then does not
/// print. Shares the ownership of the algorithm. For the thread that updates the algorithm.
class lms3dAlgorithmMessages
{
public:
  explicit lms3dAlgorithmMessages(vtkAlgorithm* algorithm);
  ~lms3dAlgorithmMessages();
  lms3dAlgorithmMessages(const lms3dAlgorithmMessages&) = delete;
  void operator=(const lms3dAlgorithmMessages&) = delete;

  ///@{
  /// The first message since the last call, without VTK's prefix. Empty if there was none.
  std::string TakeError();
  std::string TakeWarning();
  ///@}

private:
  struct Observers;
  const std::unique_ptr<Observers> Internals;
};

#endif
