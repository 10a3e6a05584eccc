// SPDX-License-Identifier: BSD-3-Clause
#include "ProfileFile.h"

#include "FileName.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkDataArray.h"
#include "vtkDelimitedTextWriter.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlot.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include "vtksys/SystemTools.hxx"

#include <X11/Xlib.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>

namespace
{

struct Curve
{
  const char* Column;
  const char* Label;
  unsigned char Color[3];
};

/** Without a display, VTK would end the process. */
bool HasDisplay()
{
  Display* display = XOpenDisplay(nullptr);
  return display && XCloseDisplay(display) == 0;
}

double GetMaximum(vtkTable* table, const char* column)
{
  return vtkDataArray::SafeDownCast(table->GetColumnByName(column))->GetRange()[1];
}

/** The columns of the chart. On a logarithmic axis, numbers without a logarithm are omitted. */
vtkNew<vtkTable> MakeColumns(vtkTable* profile, const Curve (&curves)[3], bool logarithmic)
{
  vtkNew<vtkTable> columns;
  columns->AddColumn(profile->GetColumnByName("Vertices"));
  for (const Curve& curve : curves)
  {
    auto* from = vtkDataArray::SafeDownCast(profile->GetColumnByName(curve.Column));
    vtkNew<vtkDoubleArray> to;
    to->SetName(curve.Label);
    for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
    {
      const double value = from->GetTuple1(i);
      to->InsertNextValue(
        logarithmic && value <= 0.0 ? std::numeric_limits<double>::quiet_NaN() : value);
    }
    columns->AddColumn(to);
  }
  return columns;
}

/** Sets the titles, scales and ranges of both axes. `most` is the greatest number of all curves. */
void SetAxes(vtkChartXY* chart, vtkTable* profile, bool logarithmic, double most)
{
  vtkAxis* across = chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* up = chart->GetAxis(vtkAxis::LEFT);
  across->SetTitle("vertices of the level");
  up->SetTitle(logarithmic ? "number (none where no line is)" : "number");
  for (vtkAxis* axis : { across, up })
  {
    axis->GetTitleProperties()->SetFontSize(16);
    axis->GetLabelProperties()->SetFontSize(14);
  }
  chart->GetLegend()->SetLabelSize(16);
  const double* vertices =
    vtkDataArray::SafeDownCast(profile->GetColumnByName("Vertices"))->GetRange();
  across->SetLogScale(vertices[1] > 10.0 * vertices[0]);
  across->SetBehavior(vtkAxis::FIXED);
  across->SetUnscaledRange(vertices[0], std::max(vertices[1], vertices[0] + 1.0));
  up->SetLogScale(logarithmic);
  up->SetBehavior(vtkAxis::FIXED);
  up->SetUnscaledRange(logarithmic ? 0.8 : 0.0, std::max(2.0, 1.2 * most));
}

bool WriteChart(const std::string& fileName, vtkTable* profile, bool contours)
{
  const Curve curves[3] = { { "Components", "components", { 31, 119, 180 } },
    { "Tunnels", contours ? "holes" : "tunnels", { 214, 39, 40 } },
    { "Voids", "voids", { 44, 160, 44 } } };
  double most = 0.0;
  for (const Curve& curve : curves)
  {
    most = std::max(most, GetMaximum(profile, curve.Column));
  }
  const bool logarithmic = most > 50.0;
  const vtkNew<vtkTable> columns = MakeColumns(profile, curves, logarithmic);

  vtkNew<vtkContextView> view;
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetMultiSamples(8);
  view->GetRenderWindow()->SetSize(900, 540);
  vtkNew<vtkChartXY> chart;
  view->GetScene()->AddItem(chart);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::LEFT);
  for (int i = 0; i < 3; ++i)
  {
    vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
    plot->SetInputData(columns, 0, i + 1);
    plot->SetColor(curves[i].Color[0], curves[i].Color[1], curves[i].Color[2], 255);
    plot->SetWidth(2.5);
  }
  SetAxes(chart, profile, logarithmic, most);
  view->GetRenderWindow()->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(view->GetRenderWindow());
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

bool WriteTable(const std::string& fileName, vtkTable* profile)
{
  vtkNew<vtkTable> columns;
  columns->ShallowCopy(profile);
  if (std::isnan(profile->GetValueByName(0, "Error").ToDouble()))
  {
    columns->RemoveColumnByName("Error"); // not asked for
  }
  vtkNew<vtkDelimitedTextWriter> writer;
  writer->SetInputData(columns);
  writer->WriteToOutputStringOn(); // the writer does not notice a full disk
  writer->Write();
  const std::unique_ptr<char[]> text(writer->RegisterAndGetOutputString());
  std::ofstream file(fileName, std::ios::binary);
  file << text.get();
  file.close();
  return file.good();
}

} // namespace

bool ProfileFile::IsChart(const std::string& fileName)
{
  return FileName::GetExtension(fileName) == ".png";
}

std::string ProfileFile::Check(const std::string& fileName)
{
  return !IsChart(fileName) || HasDisplay() ? ""
                                            : "cannot draw " + fileName +
      ": there is no X display. Run carve under xvfb-run, or write a .csv";
}

std::string ProfileFile::Write(const std::string& fileName, vtkTable* profile, bool contours)
{
  if (profile->GetNumberOfRows() == 0)
  {
    return "there is no profile to write: nothing has been carved";
  }
  const bool good =
    IsChart(fileName) ? WriteChart(fileName, profile, contours) : WriteTable(fileName, profile);
  return good ? "" : "cannot write " + fileName;
}
