#include "ui/widgets/message_panel.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/look/look.h"
#include "ui/look/state_colours.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/flow_row.h"
#include "ui/widgets/parts.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

MessagePanel::MessagePanel(const QString& name, QWidget* parent)
    : QFrame(parent),
      picture_(new QLabel(this)),
      headline_(new QLabel(this)),
      words_(new QLabel(this)),
      act_(new BigButton(QStringLiteral("messageAct"), tr("OK"), this)),
      second_(named<QPushButton>("messageSecondAct", tr("Dismiss"), this)) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setObjectName(name);
  headline_->setWordWrap(true);
  headline_->setTextFormat(Qt::PlainText);
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::PlainText);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  words_->setAccessibleName(tr("What happened"));
  second_->hide();
  auto* text = filled(new QVBoxLayout, {headline_, words_});
  auto* row = filled(new QHBoxLayout, {{picture_, 0, Qt::AlignTop},
                                       {text, 1},
                                       {second_, 0, Qt::AlignVCenter},
                                       {act_, 0, Qt::AlignVCenter}});
  setLayout(row);
  connect(act_, &QPushButton::clicked, this, &MessagePanel::acted);
  connect(second_, &QPushButton::clicked, this, &MessagePanel::actedSecond);
  lay();
  hide();
}

void MessagePanel::showError(const Error& error, const QString& act, const QString& key) {
  showWords(error.code == ErrorCode::Cancelled ? State::Ask : State::Failed,
            QString::fromStdString(error.where), wordsOf(error.what), act, key);
}

void MessagePanel::showWords(State state, const QString& headline, const QString& words,
                             const QString& act, const QString& key) {
  state_ = state;
  headline_->setText(headline);
  headline_->setVisible(!headline.isEmpty());
  words_->setText(words);
  act_->setText(act);
  act_->setKeyHint(key);
  act_->setVisible(!act.isEmpty());
  act_->setPrimary(!beside_primary_ && state != State::Busy);
  setAccessibleName(headline.isEmpty() ? words : headline + QStringLiteral(": ") + words);
  lay();
  show();
}

void MessagePanel::setSecondAct(const QString& act) {
  second_->setText(act);
  second_->setVisible(!act.isEmpty());
}

void MessagePanel::setBesidePrimary() {
  beside_primary_ = true;
  act_->setPrimary(false);
}

QAbstractButton* MessagePanel::act() const {
  return isHidden() || act_->isHidden() ? nullptr : act_;
}

void MessagePanel::setCompact(bool compact) {
  compact_ = compact;
  lay();
}

QString MessagePanel::headline() const {
  return headline_->text();
}

QString MessagePanel::words() const {
  return words_->text();
}

void MessagePanel::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationPaletteChange)
    lay();
}

void MessagePanel::lay() {
  const StateColours colours(QApplication::palette());
  QPalette ground;  // the one colour only: buttons on it follow the theme
  ground.setColor(QPalette::Window, colours.behind(state_));
  if (ground.color(QPalette::Window) != palette().color(QPalette::Window)) setPalette(ground);
  headline_->setFont(scaledFont(*this, Look::kSection, true));
  words_->setFont(scaledFont(*this, compact_ ? 1 : Look::kSection));
  const int size = Look::kIcon * (compact_ ? 1 : 2);
  const QString name = state_ == State::Failed ? QStringLiteral("error")
                       : state_ == State::Sure ? QStringLiteral("check")
                       : state_ == State::Busy ? QStringLiteral("clock")
                                               : QStringLiteral("warning");
  picture_->setPixmap(icon(name, colours.of(state_)).pixmap(size, size));
}

EmptyState::EmptyState(const QString& icon_name, const QString& headline, const QString& words,
                       QWidget* parent)
    : QWidget(parent), icon_name_(icon_name) {
  picture_ = new QLabel(this);
  picture_->setAlignment(Qt::AlignCenter);
  headline_ = new QLabel(headline, this);
  headline_->setFont(scaledFont(*this, Look::kTitle, true));
  headline_->setAlignment(Qt::AlignCenter);
  headline_->setWordWrap(true);
  words_ = new QLabel(words, this);
  words_->setAlignment(Qt::AlignCenter);
  words_->setWordWrap(true);
  auto* acts = new FlowRow;
  acts->setCentred(true);
  acts_ = acts;
  auto* column = filled(new QVBoxLayout(this),
                        {Part::room(2), picture_, headline_, {words_, 0, Qt::AlignHCenter}});
  column->addSpacing(Look::kGap);
  filled(column, {acts, Part::room(3)});
  lay();
}

void EmptyState::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) lay();
}

// A layout would give the words a column's width or a line's height.
void EmptyState::lay() {
  const int width = fontMetrics().averageCharWidth() * 65;
  words_->setFixedSize(width, words_->heightForWidth(width));
  const QColor ink = coloursOf(palette()).secondary;
  picture_->setPixmap(icon(icon_name_, ink).pixmap(Look::kEmptyIcon, Look::kEmptyIcon));
}

void EmptyState::setHeadline(const QString& headline) {
  headline_->setText(headline);
}

void EmptyState::setWords(const QString& words) {
  words_->setText(words);
  lay();
}

QPushButton* EmptyState::addAct(const QString& text, const QString& object_name) {
  QPushButton* button = nullptr;
  if (acts_->count() == 0) {
    button = new BigButton(object_name, text, this);
  } else {
    button = new QPushButton(text, this);
    button->setObjectName(object_name);
    button->setMinimumHeight(targetSize(*this));
  }
  acts_->addWidget(button);
  return button;
}

}  // namespace ostraka::ui
