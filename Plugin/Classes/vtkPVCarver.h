// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVCarver
 * @brief a carver with a further output port that shows one level
 *
 * ParaView shows the first output port. So port 0 of this filter is a single level, which a
 * vtkPVExtractCarvedLOD picks; ports 1 to 3 are the ports 0 to 2 of vtkCarverAlgorithm: all levels,
 * the stream and the profile. The outputs of the carver are kept, so that picking another level
 * does not carve again.
 */
#ifndef vtkPVCarver_h
#define vtkPVCarver_h

#include "vtkCarverAlgorithm.h"
#include "vtkSmartPointer.h"                  // for the extractor
#include "vtkTopologyCarvingParaViewModule.h" // for export macro

#include <array> // for the kept outputs

class vtkPVExtractCarvedLOD;

class VTKTOPOLOGYCARVINGPARAVIEW_EXPORT vtkPVCarver : public vtkCarverAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkPVCarver, vtkCarverAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The filter that picks the level of port 0. The default is an extractor of the carver's own. */
  void SetExtractor(vtkPVExtractCarvedLOD* extractor);
  vtkPVExtractCarvedLOD* GetExtractor();
  ///@}

  ///@{
  /** See vtkCarverAlgorithm. The level of port 0 is simplified, too. */
  void SetLevelSimplification(int value) override;
  void SetMaximumVertices(int value) override;
  ///@}

  /** The time of the last change of the carver or its extractor. */
  vtkMTimeType GetMTime() override;

protected:
  /** 3 for meshes in space, 2 for contours in a plane. */
  explicit vtkPVCarver(int dimension);
  ~vtkPVCarver() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

private:
  vtkPVCarver(const vtkPVCarver&) = delete;
  void operator=(const vtkPVCarver&) = delete;

  /**
   * Fills the carver's own ports and keeps their data. Returns false after an error or an abort.
   */
  bool CarveAndKeep(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* ports);
  /** Fills port 0 from the kept stream. */
  void ExtractLevel(vtkInformationVector* out);

  vtkSmartPointer<vtkPVExtractCarvedLOD> Extractor;
  std::array<vtkSmartPointer<vtkDataObject>, 3> Kept; ///< the data of the carver's own ports
  bool OffersTime = false;
};

#endif
