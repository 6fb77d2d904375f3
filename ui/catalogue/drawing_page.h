#pragma once
#include <QPointer>
#include <QWidget>
#include <map>
#include <memory>
#include <vector>

#include "catalogue/catalogue.h"
#include "exchange/drawn_sherds.h"
#include "records/sherd.h"
#include "ui/jobs/job.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace ostraka::ui {

class ProjectSession;
class SheetView;
class SurfaceChoice;

/// The archaeological drawing of the sherd that is chosen, or plates of many: section, views, scale
/// bar, mouth; saved as SVG or PDF, printed in true scale. One is drawn as soon as the page is
/// looked at, many when they are asked for; always by a worker.
class DrawingPage final : public QWidget {
  Q_OBJECT

 public:
  explicit DrawingPage(QWidget* parent = nullptr);

  /// session: nullptr when no project is open.
  void setSherds(ProjectSession* session, std::vector<store::SherdRow> sherds);
  /// What is drawn now; empty before and while something is drawn.
  const std::vector<Page>& pages() const;

 public slots:
  void draw();
  void stop();
  /// .svg: a file each sheet; .png, .tif: the views of each sherd; everything else is a PDF of all.
  /// kind: as a dialog names it, "PNG (*.png)"; it counts where no other ending than .pdf is typed.
  void saveTo(const QString& file, const QString& kind = {});

 signals:
  void said(const QString& sentence);
  /// The mouth's diameter and what is kept of the rim, to be entered.
  void measuresWanted(const std::vector<records::FieldChange>& changes);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Drawn {
    exchange::DrawnSherds sherds;
    std::vector<Page> pages;
    exchange::DrawSherdsOptions how;
  };
  void buildLayout();
  QLayout* buildChoices();
  QLayout* buildActs();
  exchange::DrawSherdsOptions options() const;
  QString fileName() const;  ///< without an ending; there is a drawing
  void forget();
  void choicesChanged();
  void rimChosen();
  void showRim();
  void arrived(const std::shared_ptr<const Drawn>& drawn);
  void showPage(int page);
  void refresh();
  /// Of the one sherd that is drawn, where the rim says it and nobody measured it.
  const drawing::Mouth* mouth() const;
  QString words() const;
  void save();
  void print();
  void saveAs(const QString& file, const std::shared_ptr<const Drawn>& drawn);
  using Writing = std::function<Result<void>(const std::vector<Page>&, Progress&, std::stop_token)>;
  void write(const std::shared_ptr<const Drawn>& drawn, Writing work, const QString& done);
  void enterRim();

  ProjectSession* session_ = nullptr;
  std::vector<store::SherdRow> sherds_;
  /// What a person said of individual sherds, whatever is shown; kept with the project.
  std::map<store::SherdRow, drawing::RimChoice> rims_;
  std::shared_ptr<const Drawn> drawn_;
  QPointer<JobHandle> drawing_, painting_, writing_;
  QString problem_;
  int page_ = 0;
  QComboBox* scale_ = nullptr;
  SurfaceChoice* surface_ = nullptr;
  QComboBox* rim_ = nullptr;
  QPushButton* draw_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* stop_ = nullptr;
  SheetView* view_ = nullptr;
  QToolButton* previous_ = nullptr;
  QToolButton* next_ = nullptr;
  QLabel* where_ = nullptr;
  QLabel* words_ = nullptr;
  QPushButton* enter_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* print_ = nullptr;
};

}  // namespace ostraka::ui
