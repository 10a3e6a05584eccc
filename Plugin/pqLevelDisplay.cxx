// SPDX-License-Identifier: BSD-3-Clause
#include "pqLevelDisplay.h"

#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqServerManagerModel.h"
#include "pqView.h"
#include "vtkNew.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <QString>

namespace
{

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

} // namespace

//------------------------------------------------------------------------------
pqLevelDisplay::pqLevelDisplay(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void pqLevelDisplay::startup()
{
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(
    model, SIGNAL(sourceAdded(pqPipelineSource*)), this, SLOT(watch(pqPipelineSource*)));
  for (pqPipelineSource* source : model->findItems<pqPipelineSource*>())
  {
    this->watch(source);
  }
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
    [source] { source->getProxy()->UpdatePropertyInformation(); });
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
