// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The devices that users can choose, with the values of all properties that describe a
 * device.
 *
 * All interfaces take their lists of devices from this table. Mounting, AxisOffset, TurnRate and
 * the angles describe the rig, and RangeBias one unit's own error: a device sets no rig, and its
 * bias is 0.
 *
 * Sources: TD is SICK's technical description 8008970 of 06-2003, TL SICK's telegram listing
 * 8007954.
 * - LMS200-mm: spot 12 mm and 4.4 mrad (TL 114); pulse of about 1 m (TL 111); 10 m at 10 percent
 *   (TD 7, 33); standard deviation 5 mm up to 8 m (TD 34); digits of 1 mm (TL 17); 8 m, the range
 *   of 13 bits in millimetres.
 * - LMS200-cm: the same device with digits of 10 mm, up to 80 m. TD has no standard deviation for
 *   this mode; the value is that of the mode in millimetres.
 * - LMS291: the outdoor device, in centimetres: spot 16 mm and 11.9 mrad (TL 114); standard
 *   deviation 10 mm (TD 34); 30 m at 10 percent (the working range that open_karto quotes from
 *   SICK).
 *
 * The number of samples is a choice: 7 rays are the fewest that have a ring.
 */
#ifndef lms3dDevices_h
#define lms3dDevices_h

#include <string>

/// Metres, except BeamDivergence (metres for each metre) and BeamSamples. Each member has the
/// meaning of the property of vtkLMS3DScanFilter or vtkLMS3DRangeErrorFilter with its name.
struct lms3dDevice
{
  const char* Name;
  double MaximumRange;
  double BeamDiameter;
  double BeamDivergence;
  int BeamSamples;
  double PulseLength;
  double RangeAtTenPercent;
  double RangeBias;
  double RangeNoise;
  double RangeResolution;
};

int lms3dGetNumberOfDevices();

/// Returns the device of a number, null if there is none.
const lms3dDevice* lms3dGetDevice(int number);

/// Returns the name of a device, null if there is none of this number.
const char* lms3dGetDeviceName(int number);

/// Returns the value of a property by its name, NaN if there is no such device or property.
double lms3dGetDeviceValue(int number, const std::string& property);

/// Returns the number of the first device that a function accepts, -1 if it accepts none.
template <class Accepts>
int lms3dFindDevice(const Accepts& accepts)
{
  for (int i = 0; i < lms3dGetNumberOfDevices(); ++i)
  {
    if (accepts(*lms3dGetDevice(i)))
    {
      return i;
    }
  }
  return -1;
}

#endif
