// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqLevelDisplay
 * @brief updates ParaView's window for filters that show one level
 *
 * ParaView hides the output to which a filter is applied, but no other output of the same source.
 * It requests the ranges of sliders before it executes a filter. So this class hides the level of a
 * carver when Extract Carved LOD is applied to the carver's stream, and requests the ranges again
 * when there is new data.
 *
 * Time picks the level as soon as the time controls are used, and the properties on the panel pick
 * it as soon as one of them is edited: this class switches Follow Time on and off. Faces of the
 * input, which have no priority, get a quiet color.
 */
#ifndef pqLevelDisplay_h
#define pqLevelDisplay_h

#include <QObject>

class pqPipelineSource;
class pqProxy;
class vtkObject;

class pqLevelDisplay : public QObject
{
  Q_OBJECT

public:
  explicit pqLevelDisplay(QObject* parent = nullptr);

  ///@{
  /** ParaView calls these functions when its window starts and ends. */
  void startup();
  void shutdown();
  ///@}

private Q_SLOTS:
  void watch(pqPipelineSource* source);
  void onTargetEdited(vtkObject* target);
  void setColors(pqProxy* colors);
};

#endif
