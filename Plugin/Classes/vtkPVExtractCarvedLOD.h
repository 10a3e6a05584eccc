// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVExtractCarvedLOD
 * @brief vtkExtractCarvedLOD with a target for each type, for a panel with a slider for each
 *
 * The target of the current LevelTargetType becomes the LevelTarget. FollowTime is off by default,
 * and time steps are offered all the same, so that ParaView's time controls are ready to be used.
 */
#ifndef vtkPVExtractCarvedLOD_h
#define vtkPVExtractCarvedLOD_h

#include "vtkExtractCarvedLOD.h"
#include "vtkTopologyCarvingParaViewModule.h" // for export macro

class VTKTOPOLOGYCARVINGPARAVIEW_EXPORT vtkPVExtractCarvedLOD : public vtkExtractCarvedLOD
{
public:
  static vtkPVExtractCarvedLOD* New();
  vtkTypeMacro(vtkPVExtractCarvedLOD, vtkExtractCarvedLOD);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The LevelTarget for each LevelTargetType. A VertexTarget of 0, the default, stands for the
   * geometric mean of its range, so that the level is between hull and mesh, or for the vertices of
   * the largest hull in a collection if these are more. Lengths that are not finite are refused
   * with an error.
   */
  void SetVertexTarget(int target);
  vtkGetMacro(VertexTarget, int);
  vtkSetClampMacro(TriangleTarget, int, 0, VTK_INT_MAX);
  vtkGetMacro(TriangleTarget, int);
  void SetFeatureSizeTarget(double target);
  vtkGetMacro(FeatureSizeTarget, double);
  vtkSetClampMacro(TunnelsTarget, int, 0, VTK_INT_MAX);
  vtkGetMacro(TunnelsTarget, int);
  vtkSetClampMacro(ComponentTarget, int, 0, VTK_INT_MAX);
  vtkGetMacro(ComponentTarget, int);
  void SetErrorBoundTarget(double target);
  vtkGetMacro(ErrorBoundTarget, double);
  vtkSetClampMacro(StepTarget, int, 0, VTK_INT_MAX);
  vtkGetMacro(StepTarget, int);
  ///@}

  /** The VertexTarget of the last update, also where the property is 0. */
  vtkGetMacro(ShownVertices, int);

  ///@{
  /**
   * The range of each target in the input as it is now. Without an input, the range is centered on
   * the target, since ParaView puts a new slider in the middle of its range.
   */
  double* GetVertexRange() VTK_SIZEHINT(2);
  double* GetTriangleRange() VTK_SIZEHINT(2);
  double* GetFeatureSizeRange() VTK_SIZEHINT(2);
  double* GetTunnelsRange() VTK_SIZEHINT(2);
  double* GetComponentRange() VTK_SIZEHINT(2);
  double* GetErrorBoundRange() VTK_SIZEHINT(2);
  double* GetStepRange() VTK_SIZEHINT(2);
  ///@}

  /** Also adds the time steps if FollowTime is off. Returns whether time picks the level. */
  bool OfferTimes(vtkInformation* input, vtkInformation* output) override;

protected:
  vtkPVExtractCarvedLOD();
  ~vtkPVExtractCarvedLOD() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  int VertexTarget = 0;
  int TriangleTarget = 2000;
  double FeatureSizeTarget = 0.0;
  int TunnelsTarget = 0;
  int ComponentTarget = 1;
  double ErrorBoundTarget = 0.0;
  int StepTarget = 0;

private:
  vtkPVExtractCarvedLOD(const vtkPVExtractCarvedLOD&) = delete;
  void operator=(const vtkPVExtractCarvedLOD&) = delete;

  double* GetRange(int type, double target);

  int ShownVertices = 0;
  double Range[2] = { 0.0, 0.0 };
};

#endif
