#include "ui/frame/plate_screen.h"

#include <QComboBox>
#include <QLabel>
#include <algorithm>

#include "ui/frame/batch_place.h"
#include "ui/frame/project_session.h"
#include "ui/look/look.h"
#include "upkeep/project.h"

namespace ostraka::ui {

PlateScreen::PlateScreen(const QString& title, const QString& icon_name, QWidget* parent)
    : Screen(title, icon_name, parent),
      batches_(new QComboBox(this)),
      message_(wrappedLabel(this, "message")) {
  batches_->setObjectName("batch");
  batches_->setAccessibleName(tr("Batch"));
  batches_->setFocusPolicy(Qt::TabFocus);
  connect(batches_, &QComboBox::activated, this,
          [this](int index) { showBatch(batches_->itemText(index)); });
}

QString PlateScreen::chosen() const {
  return batch_.isEmpty() ? QString() : kPlate + batch_;
}

QString PlateScreen::whereWords() const {
  return session_ && session_->hasProject() && !batch_.isEmpty()
             ? batchWords(session_->project().catalogue(), batch_)
             : batch_;
}

void PlateScreen::takeChosen(const QString& what) {
  if (what.startsWith(kPlate) && what != chosen() &&
      batches_->findText(what.mid(kPlate.size())) >= 0)
    showBatch(what.mid(kPlate.size()));
}

QStringList PlateScreen::reviewable() const {
  QStringList names;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(session_->folder() / "results", ignored))
    if (std::filesystem::exists(entry.path() / "work" / "pairs" / "candidates.json", ignored))
      names << QString::fromStdString(entry.path().filename().string());
  std::sort(names.begin(), names.end(), std::greater<>());
  return names;
}

std::filesystem::path PlateScreen::outputOf(const QString& batch) const {
  return session_->folder() / "results" / batch.toStdString();
}

void PlateScreen::say(const QString& sentence) {
  message_->setText(sentence);
  // Once: the status bar tells only what is out of sight.
  if (!message_->isVisible()) emit said(sentence);
}

}  // namespace ostraka::ui
