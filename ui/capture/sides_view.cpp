#include "ui/capture/sides_view.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/frame/elided_label.h"
#include "ui/frame/look.h"
#include "ui/frame/thumbnails.h"

namespace ostraka::ui {
namespace {

constexpr int kPicture = 2 * Look::kThumbnail;

}  // namespace

SidesView::SidesView(QWidget* parent)
    : QWidget(parent),
      parts_{buildPart(QStringLiteral("importFront")), buildPart(QStringLiteral("importBack"))},
      flip_(new QLabel(this)),
      where_(new QSlider(Qt::Horizontal, this)),
      one_side_(new QCheckBox(tr("One side only"), this)),
      swap_(new QPushButton(tr("Swap sides"), this)),
      sheet_(new ElidedLabel(this)) {
  flip_->setObjectName(QStringLiteral("importFlip"));
  flip_->setWordWrap(true);
  where_->setObjectName(QStringLiteral("importDivide"));
  where_->setAccessibleName(tr("First photograph of the second side"));
  where_->setMinimumHeight(controlHeight(*this));
  one_side_->setObjectName(QStringLiteral("importOneSide"));
  swap_->setObjectName(QStringLiteral("importSwap"));
  sheet_->setObjectName(QStringLiteral("importSheet"));
  auto* choose = new QPushButton(tr("Choose sheet…"), this);
  choose->setObjectName(QStringLiteral("importChooseSheet"));
  for (QPushButton* button : {swap_, choose}) button->setMinimumHeight(controlHeight(*this));
  auto* pictures = new QHBoxLayout;
  for (const Part& part : parts_) {
    auto* pair = new QHBoxLayout;
    for (QLabel* picture : part.pictures) pair->addWidget(picture);
    pair->addStretch(1);
    auto* column = new QVBoxLayout;
    column->addWidget(part.words);
    column->addLayout(pair);
    pictures->addLayout(column, 1);
  }
  auto* dividing = new QHBoxLayout;
  dividing->addWidget(where_, 1);
  dividing->addWidget(one_side_);
  dividing->addWidget(swap_);
  auto* beneath = new QHBoxLayout;
  beneath->addWidget(sheet_, 1);
  beneath->addWidget(choose);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(pictures);
  column->addWidget(flip_);
  column->addLayout(dividing);
  column->addLayout(beneath);
  connect(where_, &QSlider::valueChanged, this, [this](int at) {
    plan_.first_second = static_cast<std::size_t>(at);
    plan_.flip_found = true;  // a person said so
    follow();
  });
  connect(one_side_, &QCheckBox::toggled, this, [this](bool on) {
    plan_.one_side = on;
    follow();
  });
  connect(swap_, &QPushButton::clicked, this, [this] {
    plan_.backs_first = !plan_.backs_first;
    follow();
  });
  connect(choose, &QPushButton::clicked, this, &SidesView::chooseSheet);
}

SidesView::Part SidesView::buildPart(const QString& name) {
  Part part{new ElidedLabel(this), {new QLabel(this), new QLabel(this)}};
  part.words->setObjectName(name);
  for (QLabel* picture : part.pictures) {
    picture->setFixedSize(kPicture, kPicture * 3 / 4);
    picture->setAlignment(Qt::AlignCenter);
    picture->setPalette(mattePalette());
    picture->setAutoFillBackground(true);
  }
  return part;
}

void SidesView::setThumbnails(Thumbnails* thumbnails) {
  thumbnails_ = thumbnails;
  if (thumbnails_ != nullptr)
    connect(thumbnails_, &Thumbnails::ready, this, [this] {
      if (isVisible()) follow();
    });
}

void SidesView::setPlan(const SidesPlan& plan) {
  plan_ = plan;
  const QSignalBlocker quiet(where_), silent(one_side_);
  const auto least = static_cast<int>(kLeastOfASide);
  if (plan.divisible) where_->setRange(least, static_cast<int>(plan.files.size()) - least);
  where_->setValue(static_cast<int>(plan.first_second));
  where_->setVisible(plan.divisible);
  one_side_->setChecked(plan.one_side);
  one_side_->setVisible(plan.divisible);
  follow();
}

void SidesView::chooseSheet() {
  auto* dialog = new QFileDialog(this, tr("Sheet under the sherds"), {}, tr("Sheet (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    plan_.sheet = file.toStdString();
    follow();
    emit sheetChosen(file);
  });
  dialog->open();
}

void SidesView::follow() {
  const ImportSides sides = plan_.sides();
  showPart(parts_[0], tr("Front"), sides.front);
  showPart(parts_[1], tr("Back"), sides.back);
  where_->setEnabled(!plan_.one_side);
  swap_->setVisible(!plan_.one_side);
  flip_->setVisible(plan_.divisible && !plan_.one_side);
  flip_->setText(
      plan_.flip_found
          ? tr("The series is divided where the sherds were turned over.")
          : tr("No pause stands out between the photographs. Move the slider to where the "
               "sherds were turned over."));
  sheet_->setText(
      plan_.sheet ? tr("Sheet: %1").arg(QString::fromStdString(plan_.sheet->string()))
                  : tr("No sheet: no plate.json lies beside the photographs. Without it the result "
                       "has no scale."));
  emit changed();
}

void SidesView::showPart(const Part& part, const QString& side,
                         const std::vector<std::filesystem::path>& files) {
  for (QLabel* picture : part.pictures) picture->setVisible(!files.empty());
  if (files.empty()) return part.words->setText(tr("%1: none").arg(side));
  const auto name = [](const std::filesystem::path& file) {
    return QString::fromStdString(file.filename().string());
  };
  part.words->setText(tr("%1: %n photograph(s), %2 to %3", nullptr, static_cast<int>(files.size()))
                          .arg(side, name(files.front()), name(files.back())));
  showPicture(part.pictures[0], files.front());
  showPicture(part.pictures[1], files.back());
}

void SidesView::showPicture(QLabel* label, const std::filesystem::path& file) {
  const QString path = QString::fromStdString(file.string());
  label->setAccessibleName(path);
  label->setToolTip(path);
  const qreal ratio = devicePixelRatioF();
  QPixmap picture = thumbnails_ == nullptr
                        ? QPixmap()
                        : thumbnails_->get(path, (QSizeF(label->size()) * ratio).toSize());
  picture.setDevicePixelRatio(ratio);
  label->setPixmap(picture);
}

}  // namespace ostraka::ui
