#include "ui/settings/rights_edit.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "catalogue/settings.h"
#include "ui/frame/project_session.h"
#include "ui/frame/saved_value.h"
#include "ui/look/look.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/parts.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

RightsEdit::RightsEdit(QWidget* parent)
    : QWidget(parent),
      licence_(named<QLineEdit>("licence", this)),
      holder_(named<QLineEdit>("rightsHolder", this)),
      told_(wrappedLabel(this, QStringLiteral("rightsTold"))) {
  setObjectName(QStringLiteral("rights"));
  licence_->setPlaceholderText(tr("for instance CC-BY-4.0; empty: none is named"));
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
  const Result<Rights> rights = rightsIn(*session_);
  if (!rights) return told_->setText(sentenceOf(rights.error()));
  held_ = *rights;
  licence_->setText(held_.licence);
  holder_->setText(held_.holder);
}

Result<RightsEdit::Rights> RightsEdit::rightsIn(ProjectSession& session) {
  const Result<records::ProjectRecord> record =
      catalogue::Settings(session.project().catalogue()).project();
  if (!record) return record.error();
  return Rights{QString::fromStdString(record->licence),
                QString::fromStdString(record->rights_holder)};
}

Result<void> RightsEdit::setRights(ProjectSession& session, const Rights& rights,
                                   const records::Provenance& provenance) {
  catalogue::Settings settings(session.project().catalogue());
  Result<records::ProjectRecord> record = settings.project();
  if (!record) return record.error();
  record->licence = rights.licence.toStdString();
  record->rights_holder = rights.holder.toStdString();
  return settings.setProject(*record, provenance);
}

void RightsEdit::save() {
  if (!session_) return;
  const Rights typed{licence_->text().trimmed(), holder_->text().trimmed()};
  if (typed == held_) return;
  const auto shown = [edit = QPointer<RightsEdit>(this)] {
    if (edit) edit->showRights();
  };
  const SavedValue<Rights> rights = {
      "rights", [&session = *session_] { return rightsIn(session); },
      [&session = *session_](const Rights& wanted, const records::Provenance& by) {
        return setRights(session, wanted, by);
      },
      shown};
  const Result<void> done = saveValue(*session_, tr("change the rights"), rights, typed);
  told_->setText(done ? tr("Saved.") : sentenceOf(done.error()));
}

}  // namespace ostraka::ui
