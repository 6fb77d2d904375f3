#include "ui/settings/rights_edit.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QUndoCommand>
#include <QVBoxLayout>
#include <utility>

#include "catalogue/settings.h"
#include "ui/frame/project_session.h"
#include "ui/look/look.h"
#include "ui/widgets/form_rows.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

/// Texts only; the project's record is read anew each time.
class RightsCommand final : public QUndoCommand {
 public:
  struct Rights {
    QString licence, holder;
  };
  RightsCommand(RightsEdit& edit, Rights before, Rights after)
      : QUndoCommand(RightsEdit::tr("change the rights")),
        edit_(&edit),
        before_(std::move(before)),
        after_(std::move(after)) {}
  void redo() override {
    if (std::exchange(first_, false)) return;  // it was saved before the command was made
    hold(after_);
  }
  void undo() override { hold(before_); }

 private:
  void hold(const Rights& rights) {
    if (!edit_) return;
    const Result<void> done = edit_->hold(rights.licence, rights.holder);
    if (done) return;
    setObsolete(true);
    edit_->told_->setText(sentenceOf(done.error()));
  }

  QPointer<RightsEdit> edit_;
  Rights before_, after_;
  bool first_ = true;
};

RightsEdit::RightsEdit(QWidget* parent)
    : QWidget(parent),
      licence_(new QLineEdit(this)),
      holder_(new QLineEdit(this)),
      told_(new QLabel(this)) {
  setObjectName(QStringLiteral("rights"));
  auto* heading = new QLabel(tr("Rights to the open project"), this);
  heading->setFont(scaledFont(*this, Look::kSection, true));
  licence_->setObjectName(QStringLiteral("licence"));
  licence_->setPlaceholderText(tr("for instance CC-BY-4.0; empty: none is named"));
  holder_->setObjectName(QStringLiteral("rightsHolder"));
  told_->setObjectName(QStringLiteral("rightsTold"));
  told_->setWordWrap(true);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->addRow(tr("&Licence of what is exported"), licence_);
  form->addRow(tr("Who &holds the rights"), holder_);
  form->addRow(QString(), told_);
  for (QLineEdit* field : {licence_, holder_}) {
    field->setMinimumHeight(controlHeight(*this));
    connect(field, &QLineEdit::editingFinished, this, &RightsEdit::save);
  }
  alignForm(*form);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(heading);
  column->addLayout(form);
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
  licence_->setText(QString::fromStdString(record->licence));
  holder_->setText(QString::fromStdString(record->rights_holder));
}

Result<void> RightsEdit::hold(const QString& licence, const QString& holder) {
  if (!session_) return {};
  Result<records::ProjectRecord> record =
      catalogue::Settings(session_->project().catalogue()).project();
  if (!record) return record.error();
  record->licence = licence.toStdString();
  record->rights_holder = holder.toStdString();
  if (Result<void> done = catalogue::Settings(session_->project().catalogue())
                              .setProject(*record, session_->provenance());
      !done)
    return done;
  showRights();
  return {};
}

void RightsEdit::save() {
  if (!session_) return;
  const Result<records::ProjectRecord> record =
      catalogue::Settings(session_->project().catalogue()).project();
  if (!record) return told_->setText(sentenceOf(record.error()));
  const RightsCommand::Rights before{QString::fromStdString(record->licence),
                                     QString::fromStdString(record->rights_holder)};
  const RightsCommand::Rights after{licence_->text().trimmed(), holder_->text().trimmed()};
  if (before.licence == after.licence && before.holder == after.holder) return;
  if (const Result<void> done = hold(after.licence, after.holder); !done)
    return told_->setText(sentenceOf(done.error()));
  session_->undo().push(new RightsCommand(*this, before, after));
  told_->setText(tr("Saved."));
}

}  // namespace ostraka::ui
