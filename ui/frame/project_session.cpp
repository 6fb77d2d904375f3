#include "ui/frame/project_session.h"

#include "catalogue/project.h"

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
  person_row_ = 0;
  emit initialsChanged(initials_);
}

catalogue::Act ProjectSession::act(const QString& why) {
  catalogue::Act act;
  act.why = why.toStdString();
  if (initials_.isEmpty()) return act;
  catalogue::Catalogue& catalogue = project_->catalogue();
  const std::string initials = initials_.toStdString();
  if (person_row_ == 0)
    if (const auto persons = catalogue.persons())
      for (const catalogue::PersonRecord& person : *persons)
        if (person.initials == initials) person_row_ = person.row.value;
  if (person_row_ == 0) {
    catalogue::PersonRecord person;
    person.initials = person.name = initials;
    if (const auto saved = catalogue.save(person, act)) person_row_ = saved->value;
  }
  act.person.value = person_row_;
  return act;
}

}  // namespace ostraka::ui
