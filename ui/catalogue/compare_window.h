#pragma once
#include <QDialog>
#include <array>

#include "records/sherd.h"
#include "ui/frame/term_words.h"

class QAction;
class QCheckBox;
class QLabel;
class QTableWidget;

namespace ostraka::ui {

class LinkedViews;
class ModelPane;
class ProjectSession;

/// Two sherds beside each other, for near-duplicates and joins: their models, turned as one and in
/// one scale, and below them what is known of both, with a mark at what differs. It shows only, and
/// follows what is changed in the catalogue.
class CompareWindow final : public QDialog {
  Q_OBJECT

 public:
  explicit CompareWindow(ProjectSession& session, QWidget* parent = nullptr);

  void showSherds(store::SherdRow first, store::SherdRow second);

 private:
  struct Side {
    store::SherdRow sherd;
    QLabel *name, *why_no_model;
    ModelPane* model;
  };
  void buildLayout();
  QWidget* buildModels();
  QWidget* buildFields();
  void refresh();
  void settle(std::size_t side);
  void sayWhyNoModel(std::size_t side);
  void showFields(const std::array<records::SherdRecord, 2>& sherds);

  ProjectSession& session_;
  TermWords words_;
  std::array<Side, 2> sides_{};
  LinkedViews* views_ = nullptr;
  QCheckBox* together_ = nullptr;
  QAction* section_ = nullptr;
  QLabel* summary_ = nullptr;
  QTableWidget* fields_ = nullptr;
};

}  // namespace ostraka::ui
