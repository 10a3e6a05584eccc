// SPDX-License-Identifier: BSD-3-Clause
#include "pqLevelDisplay.h"

#include "pqAnimationScene.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"
#include "pqTimeKeeper.h"
#include "pqView.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSMViewProxy.h"

#include <QString>

#include <algorithm>

namespace
{

/** The properties that pick the level while Follow Time is off. */
constexpr const char* Targets[] = { "LevelBy", "Vertices", "Triangles", "FeatureSize", "Tunnels",
  "Components", "ErrorBound", "Step" };

/** Faces of the input have no priority. ParaView's yellow for them would outshine all others. */
constexpr double ColorOfInput[] = { 0.87, 0.84, 0.78 };

pqServerManagerModel* GetModel()
{
  return pqApplicationCore::instance()->getServerManagerModel();
}

bool IsCarver(pqPipelineSource* source)
{
  const QString name = source->getProxy()->GetXMLName();
  return name == "TopologyCarver" || name == "ContourCarver";
}

bool IsExtractor(pqPipelineSource* source)
{
  return QString(source->getProxy()->GetXMLName()) == "ExtractCarvedLOD";
}

/** Hides all outputs of the carver in every view that shows the extracted level. */
void HideCarver(pqPipelineFilter* extractor)
{
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  for (pqOutputPort* input : extractor->getAllInputs())
  {
    if (!IsCarver(input->getSource()))
    {
      continue;
    }
    for (pqView* view : extractor->getOutputPort(0)->getViews())
    {
      for (pqOutputPort* port : input->getSource()->getOutputPorts())
      {
        if (port->getRepresentation(view))
        {
          controller->Hide(port->getSourceProxy(), port->getPortNumber(), view->getViewProxy());
        }
      }
    }
  }
}

/** Shows in the panel which level the filter has chosen because the panel had none. */
void UpdatePanel(vtkSMProxy* proxy)
{
  proxy->UpdatePropertyInformation();
  vtkSMPropertyHelper vertices(proxy, "Vertices");
  const int shown = vtkSMPropertyHelper(proxy, "ShownVertices").GetAsInt();
  if (vertices.GetAsInt() == 0 && shown > 0)
  {
    vertices.Set(shown);
    proxy->UpdateVTKObjects();
  }
}

/** Whether an animation track moves one of the properties that pick the level. */
bool IsAnimated(pqPipelineSource* source)
{
  for (pqAnimationScene* scene : GetModel()->findItems<pqAnimationScene*>(source->getServer()))
  {
    if (std::any_of(std::begin(Targets), std::end(Targets),
          [&](const char* name) { return scene->getCue(source->getProxy(), name, 0); }))
    {
      return true;
    }
  }
  return false;
}

/** Lets time pick the level, since the time controls have been used. */
void FollowTime(pqPipelineSource* source)
{
  vtkSMProxy* proxy = source->getProxy();
  vtkSMPropertyHelper follow(proxy, "FollowTime");
  if (follow.GetAsInt() == 0 && source->modifiedState() != pqProxy::UNINITIALIZED &&
    !pqApplicationCore::instance()->isLoadingState() && !IsAnimated(source))
  {
    follow.Set(1);
    proxy->UpdateVTKObjects();
  }
}

} // namespace

//------------------------------------------------------------------------------
pqLevelDisplay::pqLevelDisplay(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void pqLevelDisplay::startup()
{
  pqServerManagerModel* model = GetModel();
  QObject::connect(
    model, SIGNAL(sourceAdded(pqPipelineSource*)), this, SLOT(watch(pqPipelineSource*)));
  for (pqPipelineSource* source : model->findItems<pqPipelineSource*>())
  {
    this->watch(source);
  }
  QObject::connect(model, &pqServerManagerModel::proxyAdded, this, &pqLevelDisplay::setColors);
}

//------------------------------------------------------------------------------
void pqLevelDisplay::shutdown()
{
}

//------------------------------------------------------------------------------
void pqLevelDisplay::watch(pqPipelineSource* source)
{
  if (!IsCarver(source) && !IsExtractor(source))
  {
    return;
  }
  QObject::connect(source, QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), this,
    [source] { UpdatePanel(source->getProxy()); });
  QObject::connect(source->getServer()->getTimeKeeper(), &pqTimeKeeper::timeChanged, source,
    [source] { FollowTime(source); });
  for (const char* name : Targets)
  {
    pqCoreUtilities::connect(source->getProxy()->GetProperty(name),
      vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(onTargetEdited(vtkObject*)));
  }
  if (!IsExtractor(source))
  {
    return;
  }
  QObject::connect(source, &pqProxy::modifiedStateChanged, this,
    [source, fresh = false]() mutable
    {
      const pqProxy::ModifiedState state = source->modifiedState();
      if (fresh && state == pqProxy::UNMODIFIED) // has been applied for the first time
      {
        HideCarver(qobject_cast<pqPipelineFilter*>(source));
      }
      fresh = state == pqProxy::UNINITIALIZED;
    });
}

//------------------------------------------------------------------------------
void pqLevelDisplay::onTargetEdited(vtkObject* caller)
{
  auto* target = vtkSMProperty::SafeDownCast(caller);
  // A value is unchecked until the user applies it.
  if (vtkSMUncheckedPropertyHelper(target).GetAsDouble() !=
    vtkSMPropertyHelper(target).GetAsDouble())
  {
    vtkSMUncheckedPropertyHelper(target->GetParent(), "FollowTime").Set(0);
  }
}

//------------------------------------------------------------------------------
void pqLevelDisplay::setColors(pqProxy* colors)
{
  const QList<pqPipelineSource*> sources = GetModel()->findItems<pqPipelineSource*>();
  if (colors->getSMGroup() == "lookup_tables" && colors->getSMName().startsWith("Priority.") &&
    std::any_of(sources.begin(), sources.end(),
      [](pqPipelineSource* source) { return IsCarver(source) || IsExtractor(source); }))
  {
    vtkSMPropertyHelper(colors->getProxy(), "NanColor").Set(ColorOfInput, 3);
    colors->getProxy()->UpdateVTKObjects();
  }
}
