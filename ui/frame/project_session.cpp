#include "ui/frame/project_session.h"

namespace ostraka::ui {

ProjectSession::ProjectSession(std::shared_ptr<catalogue::Project> project,
                               std::filesystem::path folder, JobRunner& runner, QObject* parent)
    : QObject(parent),
      project_(std::move(project)),
      folder_(std::move(folder)),
      runner_(runner),
      undo_(this) {}

ProjectSession::~ProjectSession() = default;

void ProjectSession::setInitials(const QString& initials) {
  if (initials == initials_) return;
  initials_ = initials;
  emit initialsChanged(initials_);
}

}  // namespace ostraka::ui
