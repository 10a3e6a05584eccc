// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVContourCarver
 * @brief vtkContourCarver with a further output port that shows one level
 *
 * Port 0 is one level, picked like that of vtkPVExtractCarvedLOD by the level's own properties, which
 * do not carve again; ports 1 to 3 are the ports 0 to 2 of vtkContourCarver: all levels, the stream and
 * the profile. So it is the one level that ParaView shows first.
 */
#ifndef vtkPVContourCarver_h
#define vtkPVContourCarver_h

#include "vtkContourCarver.h"
#include "vtkTopologyCarvingParaViewModule.h" // for export macro

#include <memory> // for std::unique_ptr

class LevelPort;
class vtkPVExtractCarvedLOD;

class VTKTOPOLOGYCARVINGPARAVIEW_EXPORT vtkPVContourCarver : public vtkContourCarver
{
public:
  static vtkPVContourCarver* New();
  vtkTypeMacro(vtkPVContourCarver, vtkContourCarver);

  ///@{
  /** The filter that picks the level of port 0; by default one of its own. */
  void SetExtractor(vtkPVExtractCarvedLOD* extractor);
  vtkPVExtractCarvedLOD* GetExtractor();
  ///@}

  /** The extractor's changes count as well. */
  vtkMTimeType GetMTime() override;

protected:
  vtkPVContourCarver();
  ~vtkPVContourCarver() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

private:
  vtkPVContourCarver(const vtkPVContourCarver&) = delete;
  void operator=(const vtkPVContourCarver&) = delete;

  std::unique_ptr<LevelPort> Level;
};

#endif
