#include "ui/frame/lines.h"

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMargins>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/look/look.h"
#include "ui/look/state_colours.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {
namespace {

constexpr int kFewBatches = 5;
constexpr int kSaidFor_ms = 12000;

QLabel* label(QWidget* parent, const QString& name, const QString& object) {
  auto* made = named<ElidedLabel>({object, name}, parent);
  made->setTextFormat(Qt::PlainText);
  return made;
}

void tint(QLabel* words, State state, bool plain) {
  QPalette colours;  // the one colour only: all others follow the theme
  if (!plain)
    colours.setColor(QPalette::WindowText, StateColours(QApplication::palette()).of(state));
  words->setPalette(colours);
}

QMargins edges(bool compact) {
  return compact ? QMargins(Look::kGap, 0, Look::kGap, 0)
                 : QMargins(Look::kGroup, Look::kGap / 2, Look::kGroup, Look::kGap / 2);
}

QToolButton* button(QWidget* parent, QAction* action) {
  auto* made = new QToolButton(parent);
  made->setDefaultAction(action);
  made->setObjectName(action->objectName() + QStringLiteral("FootButton"));
  made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  made->setAutoRaise(true);
  made->setAccessibleName(action->text());
  return made;
}

}  // namespace

QString momentWords(const QDateTime& moment) {
  return QLocale::c().toString(moment, QStringLiteral("yyyy-MM-dd HH:mm"));
}

// No finer than it is known.
QString timeLeftWords(double seconds) {
  if (seconds < 0 || !std::isfinite(seconds)) return {};
  if (seconds < 55) return QCoreApplication::translate("Time", "less than a minute left");
  const double minutes = seconds / 60;
  const double step = minutes < 7.5 ? 1 : minutes < 27.5 ? 5 : minutes < 55 ? 10 : 30;
  const double rounded = step * std::round(minutes / step);
  if (rounded < 60) return QCoreApplication::translate("Time", "about %1 min left").arg(rounded);
  return QCoreApplication::translate("Time", "about %1 h left")
      .arg(QLocale().toString(rounded / 60));
}

HeaderLine::HeaderLine(QWidget* parent)
    : QFrame(parent),
      where_(label(this, tr("Where"), QStringLiteral("headerWhere"))),
      rig_(label(this, tr("Rig"), QStringLiteral("headerRig"))),
      // Never cut short: 4… is not 44.
      room_(named<QLabel>({"headerRoom", tr("Room on the disk")}, this)) {
  QFont bold = where_->font();
  bold.setBold(true);
  where_->setFont(bold);
  filled(new QHBoxLayout(this), {{where_, 3}, {rig_, 2}, room_});
  rig_->setAlignment(Qt::AlignCenter);
  room_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setCompact(false);
}

void HeaderLine::setWhere(const QString& words) {
  where_->setText(words);
}

void HeaderLine::setRig(const QString& words, bool ready) {
  rig_->setText(words.isEmpty() ? QString() : tr("Rig: %1").arg(words));
  tint(rig_, State::Ask, ready);
}

void HeaderLine::setRoom(int batches) {
  room_->setText(batches < 0 ? QString()
                             : tr("Disk: room for %n batch(es)", nullptr, std::min(batches, 9999)));
  tint(room_, State::Failed, batches < 0 || batches > kFewBatches);
}

void HeaderLine::setCompact(bool compact) {
  layout()->setContentsMargins(edges(compact));
}

void FooterLine::setCompact(bool compact) {
  layout()->setContentsMargins(edges(compact));
}

FooterLine::FooterLine(QAction* pause, QAction* log, QWidget* parent)
    : QFrame(parent),
      work_(label(this, tr("What the computer does"), QStringLiteral("footerWork"))),
      bar_(new QProgressBar(this)),
      said_(label(this, tr("What was done"), QStringLiteral("footerSaid"))) {
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Progress of the computation"));
  bar_->setMaximumWidth(fontMetrics().averageCharWidth() * 24);
  // Each gets what its words need; where there is too little for both they share it.
  for (QLabel* words : {work_, said_})
    words->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  filled(new QHBoxLayout(this),
         {{work_, 1}, bar_, Part::room(), {said_, 1}, button(this, pause), button(this, log)});
  setWork({}, -1);
  setCompact(false);
}

void FooterLine::setWork(const QString& words, double fraction) {
  work_->setText(words.isEmpty() ? tr("Idle") : words);
  bar_->setVisible(fraction >= 0);
  bar_->setValue(static_cast<int>(std::lround(1000 * std::clamp(fraction, 0.0, 1.0))));
}

void FooterLine::say(const QString& sentence) {
  said_->setText(sentence);
  QTimer::singleShot(kSaidFor_ms, said_, [label = said_, sentence] {
    if (label->text() == sentence) label->clear();
  });
}

}  // namespace ostraka::ui
