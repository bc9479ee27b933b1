// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK arrays of a given size, hidden field data, and the offsets of cells that all have the
 * same size.
 */
#ifndef lms3dArray_h
#define lms3dArray_h

#include <vtkAbstractArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstddef>

/// An array of `count` tuples whose values are not set.
template <typename ArrayT>
vtkSmartPointer<ArrayT> lms3dMakeArray(const char* name, std::size_t count, int components = 1)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

/// Adds an array that ParaView does not offer for colouring.
inline void lms3dAddHiddenArray(vtkAbstractArray* array, vtkFieldData* data)
{
  array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
  data->AddArray(array);
}

/// Fills the `cells + 1` offsets of a vtkCellArray whose cells all have `size` points.
template <typename IntegerT>
void lms3dFillOffsets(IntegerT* offsets, std::size_t cells, int size)
{
  for (std::size_t cell = 0; cell <= cells; ++cell)
  {
    offsets[cell] = static_cast<IntegerT>(cell) * static_cast<IntegerT>(size);
  }
}

#endif
