#include "ui/settings/settings_page.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QSlider>
#include <QSpinBox>
#include <QThread>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/settings/numbering_edit.h"
#include "ui/settings/project_edit.h"
#include "ui/settings/rights_edit.h"
#include "ui/settings/vocabulary_edit.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {

SettingsPage::SettingsPage(QWidget* parent)
    : QWidget(parent),
      theme_(named<QComboBox>("settingsTheme", this)),
      language_(named<QComboBox>("settingsLanguage", this)),
      restart_(named<QPushButton>("settingsRestart", tr("Restart now"), this)),
      text_(named<QSlider>("settingsText", Qt::Horizontal, this)),
      text_words_(new QLabel(this)),
      said_(wrappedLabel(this, QStringLiteral("settingsSaid"))),
      initials_(named<QLineEdit>("settingsInitials", this)),
      threads_(named<QSpinBox>("settingsThreads", this)),
      project_(new ProjectEdit(this)),
      numbering_(new NumberingEdit(this)),
      vocabulary_(new VocabularyEdit(this)),
      rights_(new RightsEdit(this)) {
  setObjectName(QStringLiteral("settings"));
  for (const auto& [theme, words] :
       {std::pair(Theme::System, tr("Follow system")), std::pair(Theme::Light, tr("Light")),
        std::pair(Theme::Dark, tr("Dark, for the tent")),
        std::pair(Theme::Sunlight, tr("Sunlight: black on white, thick lines"))})
    theme_->addItem(words, static_cast<int>(theme));
  language_->addItem(tr("Follow system"), QString());
  // As each stands in a list; a locale would name a country, too, and begin without a capital.
  for (const auto& [code, name] :
       {std::pair("en", "English"), std::pair("de", "Deutsch"), std::pair("fr", "Français"),
        std::pair("es", "Español"), std::pair("el", "Ελληνικά"), std::pair("tr", "Türkçe"),
        std::pair("hy", "Հայերեն")})
    language_->addItem(QString::fromUtf8(name), QString::fromLatin1(code));
  text_->setRange(9, 20);  // tens of per cent
  text_->setPageStep(1);
  initials_->setMaxLength(5);
  initials_->setValidator(new QRegularExpressionValidator(
      QRegularExpression(QStringLiteral("\\p{L}{0,5}")), initials_));
  threads_->setRange(0, QThread::idealThreadCount());
  threads_->setSpecialValueText(tr("all"));
  buildLayout();
  connect(project_, &ProjectEdit::renamed, this, &SettingsPage::projectRenamed);
  for (QComboBox* box : {theme_, language_})
    connect(box, &QComboBox::currentIndexChanged, this, &SettingsPage::gather);
  connect(restart_, &QPushButton::clicked, this, &SettingsPage::restartWanted);
  connect(text_, &QSlider::valueChanged, this, &SettingsPage::gather);
  connect(initials_, &QLineEdit::editingFinished, this, &SettingsPage::gather);
  connect(threads_, &QSpinBox::valueChanged, this, &SettingsPage::gather);
}

void SettingsPage::buildLayout() {
  auto* title = new QLabel(tr("Settings"), this);
  title->setFont(scaledFont(*this, Look::kTitle, true));
  auto* form = new QFormLayout;
  form->addRow(tr("&Your initials"), initials_);
  const auto hint = [this, form](const QString& words) {
    auto* label = new QLabel(words, this);
    label->setWordWrap(true);
    form->addRow(QString(), label);
  };
  hint(tr("Recorded with each decision."));
  form->addRow(tr("&Theme"), theme_);
  auto* size = filled(new QHBoxLayout, {{text_, 1}, text_words_});
  form->addRow(tr("Te&xt size"), size);
  auto* size_label = qobject_cast<QLabel*>(form->labelForField(size));
  if (size_label != nullptr) size_label->setBuddy(text_);
  text_->setAccessibleName(tr("Text size"));
  form->addRow(tr("&Language"), language_);
  auto* when = new QLabel(tr("Takes effect after restart."), this);
  form->addRow(QString(), filled(new QHBoxLayout, {{when, 1}, restart_}));
  form->addRow(tr("&Processors for computing"), threads_);
  text_->setMinimumHeight(controlHeight(*this));
  alignForm(*form);
  auto* middle = new QWidget(this);
  auto* parts = new QVBoxLayout(middle);
  parts->addLayout(form);
  for (QWidget* part :
       std::initializer_list<QWidget*>{project_, numbering_, vocabulary_, rights_}) {
    parts->addSpacing(Look::kMargin);
    parts->addWidget(part);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(Look::kMargin, Look::kGroup, Look::kMargin, 0);
  auto* close =
      iconButton(this, "settingsClose", "previous", tr("Back (Esc)"), this, &SettingsPage::closed);
  close->setShortcut(QKeySequence(Qt::Key_Escape));
  auto* head = filled(new QHBoxLayout, {{title, 1}, close});
  filled(column, {head, said_});
  say({});
  auto* page = new QWidget(this);
  auto* across = bareLayout<QHBoxLayout>(page);  // lines of a readable length, in each text size
  filled(across, {{middle, 3}, Part::room(2)});
  parts->addStretch(1);
  column->addWidget(area_ = new PageArea(page, this), 1);
}

void SettingsPage::showPart(const QString& name) {
  auto* part = area_->findChild<QWidget*>(name);
  if (part == nullptr) return;
  // A page that was never shown has its places once events are processed.
  QTimer::singleShot(0, part, [this, part] { area_->ensureWidgetVisible(part, 0, 0); });
  if (auto* field = part->findChild<QLineEdit*>()) field->setFocus();
}

void SettingsPage::say(const QString& sentence) {
  said_->setText(sentence);
  said_->setVisible(!sentence.isEmpty());
}

void SettingsPage::setSession(ProjectSession* session) {
  project_->setSession(session);
  numbering_->setSession(session);
  vocabulary_->setSession(session);
  rights_->setSession(session);
}

void SettingsPage::setSettings(const WindowSettings& settings) {
  filling_ = true;
  settings_ = settings;
  theme_->setCurrentIndex(theme_->findData(static_cast<int>(settings.theme)));
  language_->setCurrentIndex(qMax(0, language_->findData(settings.language)));
  text_->setValue(settings.text_percent / 10);
  text_words_->setText(tr("%1 %").arg(text_->value() * 10));
  initials_->setText(settings.initials);
  threads_->setValue(settings.threads);
  followLanguage();
  filling_ = false;
}

// Only where the window speaks another language than the chosen one.
void SettingsPage::followLanguage() {
  restart_->setVisible(localeOf(settings_).language() != QLocale().language());
}

void SettingsPage::gather() {
  if (filling_) return;
  settings_.theme = static_cast<Theme>(theme_->currentData().toInt());
  settings_.language = language_->currentData().toString();
  settings_.text_percent = text_->value() * 10;
  settings_.initials = initials_->text().toUpper();
  settings_.threads = threads_->value();
  text_words_->setText(tr("%1 %").arg(settings_.text_percent));
  followLanguage();
  emit changed(settings_);
}

}  // namespace ostraka::ui
