// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLMS3DRangeErrorFilter
 * @brief   changes the ranges of an ideal scan to the ranges that a real device reports
 *
 * vtkLMS3DScanFilter measures without errors. vtkLMS3DRangeErrorFilter takes such a scan and
 * returns the same scan with the errors of a device, so that both can be compared side by side. A
 * range passes three steps, in this order:
 *
 * 1. RangeBias is added: the systematic error of one device.
 * 2. A normally distributed error with the standard deviation RangeNoise is added.
 * 3. The result is rounded to the nearest multiple of RangeResolution.
 *
 * All errors act along the beam; starts and directions have no errors. By default all errors are
 * off.
 *
 * @par Input
 * A scan: the first output of vtkLMS3DScanFilter, with the point data `Range` and `BeamId`, and the
 * field data `AlphaAngles`, `BetaAngles` and `SensorToWorld`. Returns may have been removed. Each
 * beam may have at most one return.
 *
 * @par Output 0, the scan
 * The input with reported ranges in `Range` (metres), and with points at these ranges on the beams:
 * where the beam starts, which is the sensor's position unless the scan has an AxisOffset, plus
 * range times direction, rounded as vtkLMS3DScanFilter rounds it. Beams belong to a resting sensor
 * with the scan's Mounting, AxisOffset and TurnRate. Points and ranges in single precision stay in
 * single precision. All other arrays are the input's. If all errors are off, the output is the
 * input to the bit, and shares its arrays.
 *
 * @par Output 1, the range image
 * The range image of output 0, as in vtkLMS3DScanFilter: `Range` (float64, metres) for all beams,
 * NaN without a return. If the input has the field data `Status`
 * (vtkLMS3DScanFilter::ComputeStatus), the image has it as point data. vtkLMS3DScanFilter publishes
 * the extent of the image before it scans. An input without a published extent, such as a scan from
 * a file, is updated already when a consumer requests information.
 *
 * @par Beams without a return
 * A beam without a return stays without one. A device counts steps of distance, and 0 stands for no
 * measurement. So a beam gives no return if its reported range would be 0 or less (or would
 * overflow): it is removed from output 0 and NaN in output 1, and its `Status`, if there is one, is
 * TOO_NEAR in both outputs. The filter does not check the limits of ranges again. If returns are
 * removed, output 0 has one new vertex for each remaining return, and no cell data.
 *
 * @par Random numbers
 * An error depends only on NoiseSeed, the time of the scan, and the turn and number of the beam, so
 * it is the same to the bit for every NumberOfThreads, every number of processes, every order of
 * the returns, and whichever other beams have returns. (The generator is Threefry2x64 of the
 * library Random123, with the transform of Box and Muller, in double precision.) The time of the
 * scan is DATA_TIME_STEP of the input. Each time step of a trajectory so has errors of its own, and
 * they are the same each time that the step is shown. A scan without a time has the errors of time
 * 0. To repeat the scan of a sensor at rest, change NoiseSeed. RangeBias and RangeResolution draw
 * no numbers.
 *
 * @par Several processes
 * Returns stay on their process; a scan of vtkLMS3DScanFilter is on the first. Each process has its
 * block of the range image, as VTK distributes images.
 *
 * @par Errors
 * Bad input and bad properties give an error that says what to do, the error code
 * vtkErrorCode::UserError, and empty outputs: a property that is not finite; a negative RangeNoise
 * or RangeResolution; a missing array; a pose or angle that is not finite; a range that is not a
 * finite number above 0; a BeamId outside of the grid or of two returns of one process. The filter
 * reports an error once, until a property or the input changes. The outputs of a stopped update are
 * empty, and the next update runs again. A scan without returns gives a scan without returns and no
 * error.
 *
 * @sa
 * vtkLMS3DScanFilter vtkLMS3DSurfaceReconstructionFilter
 */
#ifndef vtkLMS3DRangeErrorFilter_h
#define vtkLMS3DRangeErrorFilter_h

#include "vtkLMS3DFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

class vtkDoubleArray;
class vtkImageData;
class vtkMultiProcessController;

class VTKLMS3DFILTERS_EXPORT vtkLMS3DRangeErrorFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkLMS3DRangeErrorFilter* New();
  vtkTypeMacro(vtkLMS3DRangeErrorFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The devices that SetDevice can choose. Documentation/guide.md lists their values, with sources.
   *
   * IDEAL: the defaults of all properties.
   * LMS200: a SICK LMS 200 that measures in millimetres, up to 8 m.
   * LMS200_CENTIMETRES: the same device in centimetres, up to 80 m.
   * LMS291: a SICK LMS 291, for outdoor use, in centimetres, up to 80 m. Its beam is wider.
   */
  enum Devices
  {
    IDEAL = 0,
    LMS200 = 1,
    LMS200_CENTIMETRES = 2,
    LMS291 = 3
  };

  ///@{
  /**
   * SetDevice sets RangeBias, RangeNoise and RangeResolution to the values of one of Devices. Each
   * can be changed afterwards. Another number is an error (vtkErrorMacro) and changes nothing.
   * RangeBias is 0 for all devices, because it is the error of one unit. (vtkLMS3DScanFilter has
   * the beams of the same devices.) GetDevice returns the first device that has the present values
   * of these properties, -1 if there is none. The default is IDEAL.
   */
  virtual void SetDevice(int device);
  int GetDevice() const;
  void SetDeviceToIdeal() { this->SetDevice(IDEAL); }
  void SetDeviceToLMS200() { this->SetDevice(LMS200); }
  void SetDeviceToLMS200Centimetres() { this->SetDevice(LMS200_CENTIMETRES); }
  void SetDeviceToLMS291() { this->SetDevice(LMS291); }
  ///@}

  ///@{
  /**
   * For user interfaces that list all devices: their number; the name of a device ("Ideal",
   * "LMS200-mm", "LMS200-cm", "LMS291"), null if there is none; and the value that a device gives
   * to a property of vtkLMS3DScanFilter or vtkLMS3DRangeErrorFilter, NaN if there is no such device
   * or if devices do not set this property.
   */
  static int GetNumberOfDevices();
  static const char* GetDeviceName(int device);
  static double GetDeviceValue(int device, const char* property);
  ///@}

  ///@{
  /**
   * The systematic error, metres: added to every range. Any finite number. The default is 0. (The
   * data sheet of the LMS 200 allows -0.015 to 0.015 at 1 to 8 m.)
   */
  vtkSetMacro(RangeBias, double);
  vtkGetMacro(RangeBias, double);
  ///@}

  ///@{
  /**
   * The statistical error, metres: one standard deviation (not a variance, and not two standard
   * deviations) of the normally distributed error of each range. Finite, at least 0. The default is
   * 0. (The data sheet of the LMS 200 says 0.005 up to 8 m.)
   */
  vtkSetMacro(RangeNoise, double);
  vtkGetMacro(RangeNoise, double);
  ///@}

  ///@{
  /**
   * The step of the reported ranges, metres: ranges are rounded to its nearest multiple. Half-way
   * between two multiples, the even one is taken. Finite, at least 0; 0, the default, rounds
   * nothing. (The LMS 200 reports multiples of 0.001 or 0.01.) If 1 / RangeResolution is a whole
   * number, as for 0.001, a reported range is the double nearest to the decimal number.
   */
  vtkSetMacro(RangeResolution, double);
  vtkGetMacro(RangeResolution, double);
  ///@}

  ///@{
  /**
   * Selects the random numbers of RangeNoise. Any int. Two seeds give independent errors. The
   * default is 0.
   */
  vtkSetMacro(NoiseSeed, int);
  vtkGetMacro(NoiseSeed, int);
  ///@}

  ///@{
  /**
   * The number of threads, 0 to 1024. 0, the default, uses all cores. Other values are clamped. The
   * outputs do not depend on it.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The processes that work together. Null, or a controller of one process, stands for this process
   * alone. The default is the global controller at the time of construction. All processes must
   * update the filter, with the same properties.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /**
   * Output 1, the range image.
   */
  vtkImageData* GetRangeImage();

  /**
   * Replaces the ranges of one turn of a scan by the ones that the device reports, without the
   * pipeline: for a device in real time. The results equal the ranges of the filter's output for a
   * scan with the DATA_TIME_STEP `time` (seconds). `turn` counts from 0. `ranges` are metres, above
   * 0, or NaN without a return; a return that the errors remove becomes NaN. The error code does
   * not change.
   *
   * Returns false after an error (vtkErrorMacro): without `ranges`, for a `turn` below 0, or for
   * bad properties. `ranges` then stay.
   */
  bool AddErrors(double time, int turn, vtkDoubleArray* ranges);

protected:
  vtkLMS3DRangeErrorFilter();
  ~vtkLMS3DRangeErrorFilter() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLMS3DRangeErrorFilter(const vtkLMS3DRangeErrorFilter&) = delete;
  void operator=(const vtkLMS3DRangeErrorFilter&) = delete;

  double RangeBias = 0.0;
  double RangeNoise = 0.0;
  double RangeResolution = 0.0;
  int NoiseSeed = 0;
  int NumberOfThreads = 0;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
