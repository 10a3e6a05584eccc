// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCarverAbort
 * @brief makes the button beside ParaView's progress bar stop a carving
 *
 * In ParaView 5.11, the button only emits a signal, and no events of the mouse are processed while
 * a filter runs. So this class enables the button while a carver reports progress, and processes
 * the events of the button and of painting, but no event by which the user could start another
 * action. The button does not work with a remote server.
 */
#ifndef pqCarverAbort_h
#define pqCarverAbort_h

#include <QObject>

class pqPipelineSource;
class vtkObject;

class pqCarverAbort : public QObject
{
  Q_OBJECT

public:
  explicit pqCarverAbort(QObject* parent = nullptr);

  ///@{
  /** ParaView calls these functions when its window starts and ends. */
  void startup();
  void shutdown();
  ///@}

  /** Suppresses all other events of the application while a carver runs. */
  bool eventFilter(QObject* receiver, QEvent* event) override;

private Q_SLOTS:
  void watch(pqPipelineSource* source);
  void onProgress(vtkObject* carver);
  void onEnd(vtkObject* carver);
};

#endif
