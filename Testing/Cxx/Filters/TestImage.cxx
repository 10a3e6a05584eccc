// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLookupTable.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTesting.h"

#include <gtest/gtest.h>

// Eight levels of the bones of a foot look like the approved baseline image.
TEST(Image, LevelsOfBones)
{
  const auto carver = Carve(ReadReal("bones.off"));
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(640, 240);
  vtkNew<vtkLookupTable> colors;
  colors->SetHueRange(0.66, 0.0);
  for (int i = 0; i < 8; ++i)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(GetLevel(carver, i));
    mapper->SetScalarModeToUseCellFieldData();
    mapper->SelectColorArray("Depth");
    mapper->SetLookupTable(colors);
    mapper->SetScalarRange(0, 15);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToFlat();
    vtkNew<vtkRenderer> renderer;
    const double x = 0.25 * (i % 4), y = i < 4 ? 0.5 : 0.0;
    renderer->SetViewport(x, y, x + 0.25, y + 0.5);
    renderer->SetBackground(1, 1, 1);
    renderer->AddActor(actor);
    window->AddRenderer(renderer);
    renderer->GetActiveCamera()->SetPosition(0.4, 0.4, 1);
    renderer->ResetCameraScreenSpace(GetLevel(carver, 0)->GetBounds());
  }
  window->Render();
  vtkNew<vtkTesting> testing;
  testing->AddArgument("-V");
  testing->AddArgument(BASELINES "/LevelsOfBones.png");
  testing->AddArgument("-T");
  testing->AddArgument(testing::TempDir().c_str());
  testing->SetRenderWindow(window);
  EXPECT_EQ(testing->RegressionTest(15.0), vtkTesting::PASSED);
}
