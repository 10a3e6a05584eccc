// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A further output port of a carver that shows one level.
 */
#ifndef LevelPort_h
#define LevelPort_h

#include "vtkPVExtractCarvedLOD.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <functional>

class vtkCarverAlgorithm;
class vtkDataObject;
class vtkInformationVector;

/**
 * Puts a port 0 with one level before the three ports of a carver, which become 1 to 3. The carver's
 * outputs are kept, so that choosing another level does not carve again.
 */
class LevelPort
{
public:
  explicit LevelPort(vtkCarverAlgorithm* carver);

  vtkPVExtractCarvedLOD* GetExtractor()
  {
    return this->Extractor;
  }
  /** Returns whether it is another one; null is none. */
  bool SetExtractor(vtkPVExtractCarvedLOD* extractor);

  /** What the carver's own ports are among these. */
  static vtkSmartPointer<vtkInformationVector> GetCarverPorts(vtkInformationVector* out);

  void RequestDataObject(vtkInformationVector** in, vtkInformationVector* out);
  void RequestInformation(vtkInformationVector** in, vtkInformationVector* out);

  /**
   * `time` is when a property of the carver has changed. Calls `carve` with the carver's ports if
   * that, or an input, is new; returns what it returns, or 1.
   */
  int RequestData(vtkMTimeType time, vtkInformationVector** in, vtkInformationVector* out,
    const std::function<int(vtkInformationVector*)>& carve);

private:
  bool IsCurrent(const std::array<vtkMTimeType, 3>& times) const;

  vtkCarverAlgorithm* Carver;
  vtkSmartPointer<vtkPVExtractCarvedLOD> Extractor;
  std::array<vtkMTimeType, 3> Times = {}; ///< of the properties and the inputs
  std::array<vtkSmartPointer<vtkDataObject>, 3> Kept;
  bool OffersTime = false;
};

#endif
