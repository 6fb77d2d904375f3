#include "ui/settings/project_edit.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "catalogue/settings.h"
#include "ui/frame/project_session.h"
#include "ui/frame/saved_value.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/parts.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

ProjectEdit::ProjectEdit(QWidget* parent)
    : QWidget(parent),
      name_(named<QLineEdit>("projectName", this)),
      code_(named<QLineEdit>("projectCode", this)),
      textures_(named<QComboBox>("projectTextures", this)),
      told_(wrappedLabel(this, QStringLiteral("projectTold"))) {
  setObjectName(QStringLiteral("project"));
  textures_->addItem(tr("As photographed"), false);
  textures_->addItem(tr("Without the light"), true);
  QFormLayout* form = titledForm(this, tr("Open project"));
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->addRow(tr("Na&me"), name_);
  form->addRow(tr("Site &code"), code_);
  form->addRow(tr("Textures of new mo&dels"), textures_);
  form->addRow(QString(), told_);
  for (QLineEdit* field : {name_, code_})
    connect(field, &QLineEdit::editingFinished, this, &ProjectEdit::saveName);
  connect(textures_, &QComboBox::activated, this, &ProjectEdit::saveTextures);
  alignForm(*form);
  hide();
}

void ProjectEdit::setSession(ProjectSession* session) {
  session_ = session != nullptr && session->hasProject() ? session : nullptr;
  setVisible(session_ != nullptr);
  told_->clear();
  showProject();
}

void ProjectEdit::showProject() {
  if (!session_) return;
  const catalogue::Settings settings(session_->project().catalogue());
  const Result<records::ProjectRecord> record = settings.project();
  if (!record) return told_->setText(sentenceOf(record.error()));
  held_ = {QString::fromStdString(record->title), QString::fromStdString(record->code)};
  name_->setText(held_.title);
  code_->setText(held_.code);
  const Result<bool> without = settings.texturesWithoutLight();
  textures_->setCurrentIndex(without && *without ? 1 : 0);
}

void ProjectEdit::saveName() {
  if (!session_) return;
  const Name typed{name_->text().trimmed(), code_->text().trimmed().toUpper()};
  if (typed == held_) return;
  const SavedValue<Name> name = {
      "project",
      [&session = *session_]() -> Result<Name> {
        const auto record = catalogue::Settings(session.project().catalogue()).project();
        if (!record) return record.error();
        return Name{QString::fromStdString(record->title), QString::fromStdString(record->code)};
      },
      [&session = *session_](const Name& wanted, const records::Provenance& by) {
        return catalogue::Settings(session.project().catalogue())
            .rename(wanted.title.toStdString(), wanted.code.toStdString(), by);
      },
      [edit = QPointer<ProjectEdit>(this), &session = *session_] {
        session.tellVocabulariesChanged();
        session.tellSherdsChanged();
        if (!edit) return;
        edit->showProject();
        emit edit->renamed();
      }};
  const Result<void> done = saveValue(*session_, tr("rename the project"), name, typed);
  told_->setText(done ? tr("Saved.") : sentenceOf(done.error()));
}

void ProjectEdit::saveTextures() {
  if (!session_) return;
  const SavedValue<bool> textures = {
      "textures",
      [&session = *session_] {
        return catalogue::Settings(session.project().catalogue()).texturesWithoutLight();
      },
      [&session = *session_](const bool& without, const records::Provenance& by) {
        return catalogue::Settings(session.project().catalogue())
            .setTexturesWithoutLight(without, by);
      },
      [edit = QPointer<ProjectEdit>(this)] {
        if (edit) edit->showProject();
      }};
  const bool wanted = textures_->currentData().toBool();
  if (const Result<bool> held = textures.read(); held && *held == wanted) return;
  const Result<void> done = saveValue(*session_, tr("change the textures"), textures, wanted);
  told_->setText(done ? tr("Saved.") : sentenceOf(done.error()));
}

}  // namespace ostraka::ui
