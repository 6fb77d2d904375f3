#include "ui/settings/rights_edit.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "catalogue/settings.h"
#include "ui/frame/project_session.h"
#include "ui/frame/saved_command.h"
#include "ui/look/look.h"
#include "ui/widgets/form_rows.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

RightsEdit::RightsEdit(QWidget* parent)
    : QWidget(parent),
      licence_(new QLineEdit(this)),
      holder_(new QLineEdit(this)),
      told_(wrappedLabel(this, QStringLiteral("rightsTold"))) {
  setObjectName(QStringLiteral("rights"));
  licence_->setObjectName(QStringLiteral("licence"));
  licence_->setPlaceholderText(tr("for instance CC-BY-4.0; empty: none is named"));
  holder_->setObjectName(QStringLiteral("rightsHolder"));
  QFormLayout* form = titledForm(this, tr("Rights to the open project"));
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->addRow(tr("&Licence of what is exported"), licence_);
  form->addRow(tr("Who &holds the rights"), holder_);
  form->addRow(QString(), told_);
  for (QLineEdit* field : {licence_, holder_})
    connect(field, &QLineEdit::editingFinished, this, &RightsEdit::save);
  alignForm(*form);
  hide();
}

void RightsEdit::setSession(ProjectSession* session) {
  session_ = session != nullptr && session->hasProject() ? session : nullptr;
  setVisible(session_ != nullptr);
  told_->clear();
  showRights();
}

void RightsEdit::showRights() {
  if (!session_) return;
  const Result<records::ProjectRecord> record =
      catalogue::Settings(session_->project().catalogue()).project();
  if (!record) return told_->setText(sentenceOf(record.error()));
  held_ = {QString::fromStdString(record->licence), QString::fromStdString(record->rights_holder)};
  licence_->setText(held_.licence);
  holder_->setText(held_.holder);
}

Result<void> RightsEdit::hold(const Rights& rights) {
  if (!session_) return {};
  Result<records::ProjectRecord> record =
      catalogue::Settings(session_->project().catalogue()).project();
  if (!record) return record.error();
  record->licence = rights.licence.toStdString();
  record->rights_holder = rights.holder.toStdString();
  if (Result<void> done = catalogue::Settings(session_->project().catalogue())
                              .setProject(*record, session_->provenance());
      !done)
    return done;
  showRights();
  return {};
}

void RightsEdit::save() {
  if (!session_) return;
  const Rights before = held_, after{licence_->text().trimmed(), holder_->text().trimmed()};
  if (before == after) return;
  if (const Result<void> done = hold(after); !done) return told_->setText(sentenceOf(done.error()));
  const QPointer<RightsEdit> edit(this);
  const auto saves = [edit](const Rights& rights) {
    return [edit, rights] { return edit ? edit->hold(rights) : Result<void>(); };
  };
  session_->undo().push(
      new SavedCommand(tr("change the rights"), saves(after), saves(before), *session_));
  told_->setText(tr("Saved."));
}

}  // namespace ostraka::ui
