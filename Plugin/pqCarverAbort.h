// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCarverAbort
 * @brief makes the button beside ParaView's progress bar stop a carving
 *
 * In ParaView 5.11 the button only emits a signal, and nobody looks at the mouse while a filter runs.
 * So while a carver of the built-in server reports progress, its button is enabled and events are
 * processed: those of the button and of painting, none by which the user could start something else.
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
  /** Called when ParaView's window starts and ends. */
  void startup();
  void shutdown();
  ///@}

  /** Filters the application's events, while those of a running carver are processed. */
  bool eventFilter(QObject* receiver, QEvent* event) override;

private Q_SLOTS:
  void watch(pqPipelineSource* source);
  void onProgress(vtkObject* carver);
  void onEnd(vtkObject* carver);
};

#endif
