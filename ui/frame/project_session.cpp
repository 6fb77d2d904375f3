#include "ui/frame/project_session.h"

#include <QTimer>
#include <system_error>

#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

ProjectSession::ProjectSession(std::shared_ptr<upkeep::Project> project,
                               std::filesystem::path folder, JobRunner& runner, QObject* parent)
    : QObject(parent),
      project_(std::move(project)),
      folder_(std::move(folder)),
      runner_(runner),
      undo_(this) {
  if (!hasProject()) return;
  if (const auto writes = project_->catalogue().writesOfOthers()) writes_of_others_ = *writes;
  auto* look = new QTimer(this);
  connect(look, &QTimer::timeout, this, &ProjectSession::lookForOthers);
  look->start(kLook_ms);
}

ProjectSession::~ProjectSession() = default;

void ProjectSession::setInitials(const QString& initials) {
  const QString kept = initials.trimmed().toUpper();
  if (kept == initials_ && kept == initials) return;
  if (kept != initials_) person_row_ = 0;
  initials_ = kept;
  emit initialsChanged(initials_);
}

QString ProjectSession::whyReadOnly() const {
  return hasProject() && project_->catalogue().readOnly()
             ? tr("This project is read-only: you can look at everything, but change nothing.")
             : QString();
}

bool ProjectSession::isThere() const {
  std::error_code failed;
  return !hasProject() || std::filesystem::exists(folder_ / "catalogue.sqlite", failed);
}

Error ProjectSession::goneError() const {
  return {ErrorCode::Missing,
          tr("The project's folder is not there any more: it was moved, renamed, or its disk was "
             "taken out. Open the project again where it is now.")
              .toStdString(),
          folder_.string()};
}

void ProjectSession::lookForOthers() {
  const Result<std::int64_t> writes = project_->catalogue().writesOfOthers();
  if (!writes || *writes == writes_of_others_) return;
  writes_of_others_ = *writes;
  emit sherdsChanged();
  emit othersWrote();
}

QString ProjectSession::setting(const char* key) const {
  const Result<std::string> kept = catalogue::Settings(project_->catalogue()).value(key);
  return kept ? QString::fromStdString(*kept) : QString();
}

void ProjectSession::keepSetting(const char* key, const QString& value) {
  (void)catalogue::Settings(project_->catalogue()).setValue(key, value.toStdString(), provenance());
}

void ProjectSession::noteSetting(const char* key, const QString& value) {
  (void)catalogue::Settings(project_->catalogue()).setValue(key, value.toStdString());
}

records::Provenance ProjectSession::provenance(const QString& why) {
  records::Provenance provenance;
  provenance.why = why.toStdString();
  if (initials_.isEmpty()) return provenance;
  if (person_row_ == 0) {
    const auto person =
        catalogue::People(project_->catalogue()).byInitials(initials_.toStdString(), provenance);
    if (!person) emit personRefused(sentenceOf(person.error()));
    if (person) person_row_ = person->value;
  }
  provenance.person.value = person_row_;
  return provenance;
}

}  // namespace ostraka::ui
