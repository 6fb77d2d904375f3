#include "ui/import/sides_view.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/import/print_sheet_button.h"
#include "ui/look/look.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/thumbnails.h"

namespace ostraka::ui {
namespace {

constexpr int kPicture = 2 * Look::kThumbnail;
constexpr double kLargestMarker_mm = 500;

}  // namespace

SidesView::SidesView(QWidget* parent)
    : QWidget(parent),
      parts_{buildPart(QStringLiteral("importFront")), buildPart(QStringLiteral("importBack"))},
      flip_(wrappedLabel(this, QStringLiteral("importFlip"))),
      where_(named<QSlider>({"importDivide", tr("First photograph of the second side")},
                            Qt::Horizontal, this)),
      divided_(named<QPushButton>("importDivided", tr("Divide here"), this)),
      one_side_(named<QCheckBox>("importOneSide", tr("One side only"), this)),
      swap_(named<QPushButton>("importSwap", tr("Swap sides"), this)),
      sheet_(named<ElidedLabel>("importSheet", this)),
      clear_sheet_(named<QPushButton>("importClearSheet", tr("Clear sheet"), this)),
      marker_label_(new QLabel(tr("Side of a marker's &black square"), this)),
      marker_(named<QDoubleSpinBox>("importMarker", this)) {
  where_->setMinimumHeight(controlHeight(*this));
  auto* choose = named<QPushButton>("importChooseSheet", tr("Choose sheet…"), this);
  marker_->setKeyboardTracking(false);  // a size is typed when it is whole
  marker_->setRange(0, kLargestMarker_mm);
  marker_->setDecimals(2);
  marker_->setSpecialValueText(tr("Unknown"));
  marker_->setSuffix(tr(" mm"));
  marker_label_->setBuddy(marker_);
  auto* pictures = new QHBoxLayout;
  for (const Part& part : parts_) {
    auto* pair = filled(new QHBoxLayout, {part.pictures[0], part.pictures[1], ui::Part::room(1)});
    pictures->addLayout(filled(new QVBoxLayout, {part.words, pair}), 1);
  }
  auto* back = named<QPushButton>("importBackFolder", tr("Choose back folder…"), this);
  back->setToolTip(
      tr("A folder that holds both sides is split where the sherds were turned over; the folder of "
         "the back photographs replaces the split"));
  auto* dividing =
      filled(new QHBoxLayout, {{where_, 1}, divided_, one_side_, swap_, ui::Part::room(), back});
  connect(back, &QPushButton::clicked, this, &SidesView::backWanted);
  auto* print = new PrintSheetButton(QStringLiteral("importPrintSheet"), this);
  auto* beneath = filled(new QHBoxLayout, {{sheet_, 1}, clear_sheet_, choose, print});
  connect(print, &PrintSheetButton::printed, this, &SidesView::sheetPrinted);
  connect(print, &PrintSheetButton::failed, this, &SidesView::sheetNotPrinted);
  auto* marked = filled(new QHBoxLayout, {marker_label_, marker_, ui::Part::room()});
  filled(bareLayout<QVBoxLayout>(this), {pictures, flip_, dividing, beneath, marked});
  QWidget* before = swap_;
  for (QWidget* next :
       std::initializer_list<QWidget*>{back, clear_sheet_, choose, print, marker_}) {
    setTabOrder(before, next);
    before = next;
  }
  connect(where_, &QSlider::valueChanged, this, [this](int at) {
    plan_.first_second = static_cast<std::size_t>(at);
    confirmDivision();
  });
  connect(where_, &QSlider::sliderReleased, this, &SidesView::confirmDivision);
  connect(divided_, &QPushButton::clicked, this, [this] {
    where_->setFocus();  // the button goes
    confirmDivision();
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
  connect(clear_sheet_, &QPushButton::clicked, this, [this] { useSheet({}); });
  connect(marker_, &QDoubleSpinBox::valueChanged, this, [this](double side_mm) {
    plan_.marker_mm = side_mm > 0 ? std::optional(side_mm) : std::nullopt;
    plan_.marker_proposed = false;
    follow();
    emit markerChosen(side_mm);
  });
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
  const QSignalBlocker quiet(where_), silent(one_side_), still(marker_);
  marker_->setValue(plan.marker_mm.value_or(0));
  const auto least = static_cast<int>(kLeastOfASide);
  if (plan.divisible) where_->setRange(least, static_cast<int>(plan.files.size()) - least);
  where_->setValue(static_cast<int>(plan.first_second));
  where_->setVisible(plan.divisible);
  one_side_->setChecked(plan.one_side);
  one_side_->setVisible(plan.divisible);
  follow();
}

// A person said so.
void SidesView::confirmDivision() {
  plan_.flip_found = true;
  follow();
}

void SidesView::chooseSheet() {
  connect(askForFile(this, tr("Sheet under the sherds"), {}, tr("Sheet (*.json)")),
          &QFileDialog::fileSelected, this, &SidesView::useSheet);
}

void SidesView::useSheet(const QString& file) {
  plan_.sheet.reset();
  if (!file.isEmpty()) plan_.sheet = file.toStdString();
  follow();
  emit sheetChosen(file);
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
          : tr("No pause stands out between the photographs. Where the two pictures beside the "
               "division show the sherds before and after they were turned over, divide here; "
               "else move the slider, or choose the folder of the back photographs."));
  divided_->setVisible(plan_.divisible && !plan_.one_side && !plan_.flip_found);
  clear_sheet_->setVisible(plan_.sheet.has_value());
  for (QWidget* widget : {static_cast<QWidget*>(marker_label_), static_cast<QWidget*>(marker_)})
    widget->setVisible(!plan_.sheet);
  if (plan_.sheet)
    sheet_->setText(tr("Sheet: %1").arg(QString::fromStdString(plan_.sheet->string())));
  else if (plan_.marker_mm && plan_.marker_proposed)
    sheet_->setText(tr("The marker size is proposed from the last import: check it with a ruler."));
  else if (plan_.marker_mm)
    sheet_->setText(tr("The sheet will be found in the photographs."));
  else
    sheet_->setText(tr("No sheet file (plate.json) and no marker size: the result has no scale."));
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
