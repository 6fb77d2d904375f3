#pragma once
#include <QWidget>
#include <vector>

#include "ui/wizard/capture_facts.h"

class QVBoxLayout;

namespace ostraka::ui {

/// What is seen, line by line, with a mark and a colour for what should be looked at.
class FactList final : public QWidget {
  Q_OBJECT

 public:
  explicit FactList(QWidget* parent = nullptr);
  void setFacts(const std::vector<CaptureFact>& facts);

 private:
  QVBoxLayout* column_;
};

}  // namespace ostraka::ui
