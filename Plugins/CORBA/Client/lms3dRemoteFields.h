// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles and field data of what a server sends.
 */
#ifndef lms3dRemoteFields_h
#define lms3dRemoteFields_h

#include <cstdint>

class vtkDoubleArray;
class vtkFieldData;
class vtkPolyData;
class vtkTypeInt32Array;

/// Sets points, and triangles of three indices each. Shares the arrays.
void lms3dSetTriangles(vtkDoubleArray* points, vtkTypeInt32Array* connectivity, vtkPolyData* data);

/// Sets the points. Shares the array.
void lms3dSetPoints(vtkDoubleArray* points, vtkPolyData* data);

///@{
/// Adds one value that ParaView does not offer for colouring.
void lms3dAddField(const char* name, std::uint64_t number, vtkFieldData* fieldData);
void lms3dAddField(const char* name, const char* text, vtkFieldData* fieldData);
///@}

#endif
