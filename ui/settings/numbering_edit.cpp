#include "ui/settings/numbering_edit.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/look/look.h"
#include "ui/settings/numbering_model.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {
namespace {

constexpr qsizetype kGapLines = 8;

}  // namespace

NumberingEdit::NumberingEdit(QWidget* parent)
    : QWidget(parent),
      model_(new NumberingModel(this)),
      scheme_(named<QLineEdit>("numberingScheme", this)),
      first_(named<QSpinBox>({"numberingFirst", tr("First number of this computer")}, this)),
      last_(named<QSpinBox>({"numberingLast", tr("Last number of this computer")}, this)),
      example_(named<QLabel>("numberingExample", this)),
      told_(named<QLabel>("numberingTold", this)),
      gaps_(named<QLabel>("numberingGaps", this)),
      apply_(named<QPushButton>("numberingApply", tr("Use this &numbering"), this)) {
  setObjectName(QStringLiteral("numbering"));
  scheme_->setToolTip(
      tr("{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; "
         "{n:04} has four digits at least"));
  for (QSpinBox* box : {first_, last_}) box->setRange(1, NumberingModel::kLastNumber);
  example_->setFont(scaledFont(*this, Look::kSection));
  for (QLabel* label : {told_, gaps_}) label->setWordWrap(true);
  buildLayout();
  connect(model_, &NumberingModel::changed, this, &NumberingEdit::showModel);
  connect(model_, &NumberingModel::gapsChanged, this, &NumberingEdit::showGaps);
  connect(scheme_, &QLineEdit::textEdited, model_, &NumberingModel::setScheme);
  for (QSpinBox* box : {first_, last_})
    connect(box, &QSpinBox::valueChanged, this,
            [this] { model_->setBlock(first_->value(), last_->value()); });
  connect(apply_, &QPushButton::clicked, this, &NumberingEdit::apply);
  connect(scheme_, &QLineEdit::returnPressed, this, &NumberingEdit::apply);
  setVisible(false);
}

void NumberingEdit::buildLayout() {
  QFormLayout* form = titledForm(this, tr("Numbers of the open project"));
  form->addRow(tr("N&umbering"), scheme_);
  form->addRow(tr("Example"), example_);
  auto* block = new QHBoxLayout;
  block->addWidget(first_, 1);
  auto* to = new QLabel(tr("to"), this);
  to->setMargin(fontMetrics().averageCharWidth());
  filled(block, {to, {last_, 1}});
  form->addRow(tr("Num&bers of this computer"), block);
  if (auto* label = qobject_cast<QLabel*>(form->labelForField(block))) label->setBuddy(first_);
  form->addRow(QString(), told_);
  form->addRow(QString(), apply_);
  form->addRow(tr("Skipped numbers"), gaps_);
  alignForm(*form);
}

void NumberingEdit::setSession(ProjectSession* session) {
  model_->setSession(session);
  setVisible(session != nullptr);
}

void NumberingEdit::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  model_->lookAgain();
}

void NumberingEdit::showModel() {
  const NumberingModel::Numbering& numbering = model_->numbering();
  if (scheme_->text().trimmed() != numbering.scheme) scheme_->setText(numbering.scheme);
  const QSignalBlocker first(first_), last(last_);
  first_->setValue(numbering.first);
  last_->setValue(numbering.last);
  example_->setText(model_->example());
  const QString keeps =
      tr("What has a number keeps it; the next sherds follow. No number is ever given twice.");
  told_->setText(!model_->refusal().isEmpty()   ? model_->refusal()
                 : !model_->warning().isEmpty() ? model_->warning()
                                                : keeps);
  apply_->setEnabled(model_->canApply());
}

void NumberingEdit::showGaps() {
  QStringList lines = model_->gaps().mid(0, kGapLines);
  if (const auto more = model_->gaps().size() - lines.size(); more > 0)
    lines << tr("and in %n more context(s)", nullptr, static_cast<int>(more));
  gaps_->setText(lines.isEmpty() ? tr("none") : lines.join(QLatin1Char('\n')));
}

void NumberingEdit::apply() {
  if (!model_->canApply()) return;
  if (const QString why = model_->apply(); !why.isEmpty()) told_->setText(why);
}

}  // namespace ostraka::ui
