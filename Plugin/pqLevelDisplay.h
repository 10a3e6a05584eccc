// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLevelDisplay
 * @brief what ParaView's window has to do for filters that show one level
 *
 * ParaView hides the output that a filter is applied to and no other of the same source, and it asks for
 * the ranges of sliders before it executes the filter. So this hides the level of a carver to whose stream
 * Extract Carved LOD is applied, and asks for the ranges again as soon as there is new data.
 */
#ifndef pqLevelDisplay_h
#define pqLevelDisplay_h

#include <QObject>

class pqPipelineSource;

class pqLevelDisplay : public QObject
{
  Q_OBJECT

public:
  explicit pqLevelDisplay(QObject* parent = nullptr);

  ///@{
  /** Called when ParaView's window starts and ends. */
  void startup();
  void shutdown();
  ///@}

private Q_SLOTS:
  void watch(pqPipelineSource* source);
};

#endif
