#pragma once
#include <QWidget>
#include <array>

#include "ui/import/import_sides.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace ostraka::ui {

class ElidedLabel;
class Thumbnails;

/// The sides of photographs by hand before they are imported: first and last photograph of each,
/// where one series is divided, and the sheet under the sherds; all of it can be changed.
class SidesView final : public QWidget {
  Q_OBJECT

 public:
  explicit SidesView(QWidget* parent = nullptr);
  void setThumbnails(Thumbnails* thumbnails);  ///< null takes them away
  void setPlan(const SidesPlan& plan);
  const SidesPlan& plan() const { return plan_; }

 signals:
  void changed();
  void sheetChosen(const QString& file);  ///< empty: there is no file
  void markerChosen(double side_mm);
  void sheetPrinted(const QString& headline, const QString& words);
  void sheetNotPrinted(const ostraka::Error& error);
  void backWanted();  ///< from a folder of its own

 private:
  struct Part {
    QLabel* words;
    std::array<QLabel*, 2> pictures;
  };
  Part buildPart(const QString& name);
  void chooseSheet();
  void useSheet(const QString& file);
  void follow();
  void confirmDivision();
  void showPart(const Part& part, const QString& side,
                const std::vector<std::filesystem::path>& files);
  void showPicture(QLabel* label, const std::filesystem::path& file);

  SidesPlan plan_;
  Thumbnails* thumbnails_ = nullptr;
  std::array<Part, 2> parts_;
  QLabel* flip_;
  QSlider* where_;
  QPushButton* divided_;  ///< here, where a person need not move it
  QCheckBox* one_side_;
  QPushButton* swap_;
  ElidedLabel* sheet_;
  QPushButton* clear_sheet_;
  QLabel* marker_label_;
  QDoubleSpinBox* marker_;
};

}  // namespace ostraka::ui
