// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK arrays in the memory of a pool.
 */
#ifndef lms3dPooledArray_h
#define lms3dPooledArray_h

#include "Pipeline/lms3dMemoryPool.h"

#include <vtkAbstractArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstddef>

/// Returns an array whose values are not initialized. Its memory returns to the pool when the last
/// array that shares it is deleted. Throws as lms3dMemoryPool::Take does.
template <typename ArrayT>
vtkSmartPointer<ArrayT> lms3dMakeArray(
  lms3dMemoryPool& pool, const char* name, vtkIdType count, int components = 1)
{
  using ValueType = typename ArrayT::ValueType;
  const vtkIdType values = count * components;
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetArray(
    static_cast<ValueType*>(pool.Take(static_cast<std::size_t>(values) * sizeof(ValueType))),
    values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(&lms3dMemoryPool::Return);
  return array;
}

#endif
