// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Collective operations of the processes that scan one scene, each with a part of it.
 */
#ifndef lms3dProcesses_h
#define lms3dProcesses_h

#include "Pipeline/lms3dFailure.h"
#include "Scan/lms3dScenePart.h"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

class vtkMultiProcessController;
class vtkMultiProcessStream;

/**
 * Wraps a controller, which must outlive the object.
 *
 * IsParallel, GetCount, GetRank and IsFirst are local. All other methods are collective: all
 * processes must call them in the same order, on the thread that runs the filter, since MPI need
 * not allow calls from other threads.
 */
class lms3dProcesses
{
public:
  static constexpr vtkIdType NoCell = VTK_ID_MAX;

  /// Null stands for this process alone.
  explicit lms3dProcesses(vtkMultiProcessController* controller);

  bool IsParallel() const { return this->Count > 1; }
  int GetCount() const { return this->Count; }
  int GetRank() const { return this->Rank; }
  bool IsFirst() const { return this->Rank == 0; }

  ///@{
  /// Returns in how many processes `mine` is true, and whether it is in any of them.
  int AllReduceCount(bool mine) const;
  bool AnyOf(bool mine) const { return this->AllReduceCount(mine) > 0; }
  ///@}

  /// Runs `work` in each process. If it throws in some of them, throws std::runtime_error in all of
  /// them, with the error of the lowest rank that failed. One process alone throws what `work`
  /// throws.
  template <typename Work>
  void RunCollectively(const Work& work) const
  {
    if (!this->IsParallel())
    {
      work();
      return;
    }
    this->ThrowFirstError(lms3dRunAndGetError(work, "There is not enough memory."));
  }

  /// Replaces the numbers in all processes by the first process's.
  void Broadcast(std::vector<double>& numbers) const;

  /// Replaces the stream in all processes by the first process's.
  void Broadcast(vtkMultiProcessStream& stream) const;

  /// The cells of all processes.
  struct Cells
  {
    lms3dScenePart Whole;

    /// The number of this process's first cell. If no part has global ids, cells are numbered
    /// consecutively over the processes; if all parts have ids, it is 0.
    std::int64_t First = 0;
  };

  /// Adds up the parts of all processes. Throws std::runtime_error, with a text for the user, if
  /// only some parts have global ids, or if several processes have cells and some are volume cells:
  /// no process can distinguish the outer surface from the seams.
  Cells GatherCells(const lms3dScenePart& mine) const;

  /**
   * Replaces `ranges` (metres, NaN without a return) and `cells` of each beam by range and cell of
   * the nearest hit in all processes. The nearest hit is the one with the smallest of
   * `nearestRanges` (lms3dBeamPacket::NoRange without a hit), and among equal ones the one in the
   * cell with the smallest number: what one process would choose from the whole scene. All arrays
   * have one value for each beam, in all processes.
   */
  void ReduceToNearest(
    const std::vector<double>& nearestRanges, std::vector<vtkIdType>& cells, double* ranges) const;

  /// Returns the data objects of all processes, by rank, in the first process. In all others the
  /// result is undefined. Throws std::runtime_error in all processes if one cannot send.
  std::vector<vtkSmartPointer<vtkDataObject>> GatherToFirst(vtkDataObject* mine) const;

private:
  void ThrowFirstError(const std::string& mine) const;

  vtkMultiProcessController* Controller;
  int Count;
  int Rank;
};

#endif
