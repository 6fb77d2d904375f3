#pragma once
#include <QPushButton>
#include <filesystem>

#include "base/result.h"

namespace ostraka::ui {

/// 'Print a sheet…': for a paper size the sheet of markers that lies under sherds photographed by
/// hand, as a PDF with its plate.json, opened to be printed.
class PrintSheetButton final : public QPushButton {
  Q_OBJECT

 public:
  PrintSheetButton(const QString& name, QWidget* parent);

 signals:
  void printed(const QString& headline, const QString& words);  ///< where it is, and what to do
  void failed(const ostraka::Error& error);
};

/// plate.json of the sheet that was printed so last; empty: none was.
std::filesystem::path printedSheet();

}  // namespace ostraka::ui
