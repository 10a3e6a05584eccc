// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVTopologyCarver
 * @brief vtkTopologyCarver with a further output port that shows one level
 *
 * Port 0 is one level, picked like that of vtkPVExtractCarvedLOD by the level's own properties, which
 * do not carve again; ports 1 to 3 are the ports 0 to 2 of vtkTopologyCarver: all levels, the stream and
 * the profile. So it is the one level that ParaView shows first.
 */
#ifndef vtkPVTopologyCarver_h
#define vtkPVTopologyCarver_h

#include "vtkTopologyCarver.h"
#include "vtkTopologyCarvingParaViewModule.h" // for export macro

#include <memory> // for std::unique_ptr

class LevelPort;
class vtkPVExtractCarvedLOD;

class VTKTOPOLOGYCARVINGPARAVIEW_EXPORT vtkPVTopologyCarver : public vtkTopologyCarver
{
public:
  static vtkPVTopologyCarver* New();
  vtkTypeMacro(vtkPVTopologyCarver, vtkTopologyCarver);

  ///@{
  /** The filter that picks the level of port 0; by default one of its own. */
  void SetExtractor(vtkPVExtractCarvedLOD* extractor);
  vtkPVExtractCarvedLOD* GetExtractor();
  ///@}

  /** The extractor's changes count as well. */
  vtkMTimeType GetMTime() override;

protected:
  vtkPVTopologyCarver();
  ~vtkPVTopologyCarver() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

private:
  vtkPVTopologyCarver(const vtkPVTopologyCarver&) = delete;
  void operator=(const vtkPVTopologyCarver&) = delete;

  std::unique_ptr<LevelPort> Level;
};

#endif
