#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <memory>

#include "ui/look/state_colours.h"

namespace ostraka::ui {

class JobHandle;
class JobRunner;
class ProjectLock;

/// Repairs the damaged catalogue of a project that no window has open, and tells what came back
/// from where, row by row.
class CatalogueRepair final : public QObject {
  Q_OBJECT

 public:
  explicit CatalogueRepair(JobRunner& runner, QObject* parent = nullptr);
  ~CatalogueRepair() override;
  void repair(const QString& folder);

 signals:
  /// project: may be opened now; empty while it is repaired and when it could not be.
  void told(ostraka::ui::State state, const QString& headline, const QString& words,
            const QString& project);

 private:
  JobRunner& runner_;
  QPointer<JobHandle> job_;
  std::unique_ptr<ProjectLock> lock_;
};

}  // namespace ostraka::ui
