// SPDX-License-Identifier: BSD-3-Clause
#include "pqCarverAbort.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPipelineSource.h"
#include "pqProgressManager.h"
#include "pqServerManagerModel.h"
#include "vtkCarverAlgorithm.h"
#include "vtkCommand.h"
#include "vtkSMProxy.h"

#include <QCoreApplication>
#include <QInputEvent>

namespace
{

pqProgressManager* GetProgressManager()
{
  return pqApplicationCore::instance()->getProgressManager();
}

} // namespace

//------------------------------------------------------------------------------
pqCarverAbort::pqCarverAbort(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void pqCarverAbort::startup()
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
void pqCarverAbort::shutdown()
{
}

//------------------------------------------------------------------------------
void pqCarverAbort::watch(pqPipelineSource* source)
{
  // Null if the filter is in another process.
  auto* carver = vtkCarverAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
  if (carver)
  {
    pqCoreUtilities::connect(carver, vtkCommand::ProgressEvent, this, SLOT(onProgress(vtkObject*)));
    pqCoreUtilities::connect(carver, vtkCommand::EndEvent, this, SLOT(onEnd(vtkObject*)));
  }
}

//------------------------------------------------------------------------------
void pqCarverAbort::onProgress(vtkObject* caller)
{
  auto* carver = vtkCarverAlgorithm::SafeDownCast(caller);
  if (!carver->GetProgressText())
  {
    return; // the filter extracts a level, and does not carve
  }
  pqProgressManager* manager = GetProgressManager();
  manager->setEnableAbort(true);
  const auto connection = QObject::connect(
    manager, &pqProgressManager::abort, this, [carver] { carver->SetAbortExecute(1); });
  // The manager's own event filter would block events of the window before they reach the button.
  const bool unblocked = manager->unblockEvents(true);
  QCoreApplication::instance()->installEventFilter(this);
  // Timers start renderings, which would need the output of the running filter.
  QCoreApplication::processEvents(
    QEventLoop::ExcludeSocketNotifiers | QEventLoop::X11ExcludeTimers);
  QCoreApplication::instance()->removeEventFilter(this);
  manager->unblockEvents(unblocked);
  QObject::disconnect(connection);
}

//------------------------------------------------------------------------------
void pqCarverAbort::onEnd(vtkObject* caller)
{
  // Otherwise, the next carving would stop at once.
  vtkCarverAlgorithm::SafeDownCast(caller)->SetAbortExecute(0);
  GetProgressManager()->setEnableAbort(false);
}

//------------------------------------------------------------------------------
bool pqCarverAbort::eventFilter(QObject* receiver, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Close:
    case QEvent::DragEnter:
    case QEvent::Drop:
    case QEvent::Shortcut:
      event->ignore();
      return true;
    default:
      // A window passes events of the mouse on to its widgets. The manager knows the button among
      // them.
      return dynamic_cast<QInputEvent*>(event) && !receiver->isWindowType() &&
        !GetProgressManager()->nonBlockableObjects().contains(receiver);
  }
}
