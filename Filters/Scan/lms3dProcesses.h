// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The processes that scan together, each with a part of the scene.
 */
#ifndef lms3dProcesses_h
#define lms3dProcesses_h

#include "Device/lms3dScanGeometry.h"
#include "Pipeline/lms3dFailure.h"

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

class vtkMultiProcessController;

/// All of them must call each method, in the same order, by the thread that runs the filter.
class lms3dProcesses
{
public:
  static constexpr vtkIdType NoCell = VTK_ID_MAX;

  /// Without a controller there is one process.
  explicit lms3dProcesses(vtkMultiProcessController* controller);

  ///@{
  /// What one process knows of itself.
  bool IsParallel() const { return this->Count > 1; }
  int GetCount() const { return this->Count; }
  int GetRank() const { return this->Rank; }
  bool IsFirst() const { return this->Rank == 0; }
  ///@}

  ///@{
  /// How many of them say so, and whether one does.
  int AllReduceCount(bool mine) const;
  bool AnyOf(bool mine) const { return this->AllReduceCount(mine) > 0; }
  ///@}

  /// Does this process's share of some work; throws std::runtime_error in all of them where it fails
  /// in one, with the words of the first that failed. One process alone throws what the work throws.
  template <typename Work>
  void RunCollectively(const Work& work) const
  {
    if (!this->IsParallel())
    {
      work();
      return;
    }
    this->ThrowError(lms3dRunAndGetError(work, "There is not enough memory."));
  }

  /// Gives all what the first has.
  void Broadcast(lms3dPose& pose, double& time) const;

  /**
   * The number of this process's first cell: where no part has global ids the cells are numbered
   * through, process after process, and it is 0 where all have. Throws std::runtime_error, with words
   * for the user, where only some have, and where volume cells are on several processes: none of them
   * can tell the surface from the seams.
   */
  std::int64_t GetFirstCellNumber(std::int64_t cells, bool hasIds, bool hasVolume) const;

  /**
   * Of what the processes have found along each beam `ranges` becomes that of the nearest hit, and
   * `cells` its cell, in all of them. The nearest is the one with the smallest of
   * `chosenRanges`, and of several the one in the cell with the smallest number: as one process
   * chooses from the whole scene.
   */
  void ReduceToNearest(
    const std::vector<double>& chosenRanges, std::vector<vtkIdType>& cells, double* ranges) const;

private:
  void ThrowError(const std::string& mine) const;

  vtkMultiProcessController* Controller;
  int Count;
  int Rank;
};

#endif
