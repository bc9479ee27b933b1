// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Kernels/lms3dPacketKernels.h"

#include "Kernels/lms3dPacketKernelSets.h"

#include <vtkObject.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace
{
// From the narrowest to the widest.
std::vector<const lms3dPacketKernels*> FindKernels()
{
  std::vector<const lms3dPacketKernels*> kernels = { &lms3dPacketKernelsBaseline };
#ifdef LMS3D_X86_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    kernels.push_back(&lms3dPacketKernelsAVX2);
  }
  if (__builtin_cpu_supports("fma") && __builtin_cpu_supports("avx512f") &&
    __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
    __builtin_cpu_supports("avx512bw"))
  {
    kernels.push_back(&lms3dPacketKernelsAVX512);
  }
#endif
  return kernels;
}

const std::vector<const lms3dPacketKernels*>& GetAllKernels()
{
  static const std::vector<const lms3dPacketKernels*> kernels = FindKernels();
  return kernels;
}

std::string GetAllNames()
{
  std::string names;
  for (const lms3dPacketKernels* kernels : GetAllKernels())
  {
    names += std::string(names.empty() ? "" : ", ") + kernels->Name;
  }
  return names;
}

// Returns the widest kernels, or the ones that the environment names, so that all can be measured.
const lms3dPacketKernels& ChooseKernels()
{
  const lms3dPacketKernels& widest = *GetAllKernels().back();
  const char* name = std::getenv("LMS3D_KERNELS");
  if (!name)
  {
    return widest;
  }
  for (const lms3dPacketKernels* kernels : GetAllKernels())
  {
    if (std::strcmp(name, kernels->Name) == 0)
    {
      return *kernels;
    }
  }
  vtkGenericWarningMacro(<< "LMS3D_KERNELS is \"" << name << "\"; this processor has "
                         << GetAllNames() << ". Using " << widest.Name << ".");
  return widest;
}
} // namespace

const lms3dPacketKernels& lms3dGetPacketKernels()
{
  static const lms3dPacketKernels& kernels = ChooseKernels();
  return kernels;
}

int lms3dGetNumberOfPacketKernels()
{
  return static_cast<int>(GetAllKernels().size());
}

const lms3dPacketKernels& lms3dGetPacketKernels(int i)
{
  return *GetAllKernels()[i];
}
