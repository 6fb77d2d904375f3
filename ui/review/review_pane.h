#pragma once
#include <Eigen/Geometry>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

class QAction;
class QLabel;
class QSplitter;

namespace ostraka::ui {

class BigButton;
class CandidateBar;
class CardInHand;
class CardList;
class JoinMode;
class OutlinePlot;
class PairReview;
class PicturePair;
class SherdView;
class ToolRow;
struct PairScene;

/// The screen of one batch's pairs: cards, photographs, outlines, 3D, candidates, and the keys.
class ReviewPane final : public QWidget {
  Q_OBJECT

 public:
  explicit ReviewPane(PairReview& review, QWidget* parent = nullptr);

  SherdView& view() { return *view_; }
  BigButton* accept() const { return accept_; }
  void setCompact(bool compact);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitCards();
  void fitPlot();
  void buildLayout();
  void buildActions();
  void buildViewActions();
  void buildPieceActions();
  template <class... To>
  QAction* keyed(const char* name, const QString& picture, const QString& text,
                 const QList<QKeySequence>& keys, To... to);
  QAction* step(const char* name, const QString& text, const QKeySequence& key, int by,
                void (CardInHand::*slot)(int), void (PicturePair::*line)(int));
  QAction* toggle(const char* name, const QString& picture, const QString& text,
                  const QKeySequence& key);
  void showCard();
  bool showsOther() const;  ///< what is seen is not of the pair in hand
  void blankOther();
  void namePictures();  ///< after the pair in hand
  void markCard();
  void acceptMarked();
  void next();
  void previous();
  void leave();
  void showSettling(const Eigen::Isometry3d& front_from_back, const std::vector<double>& rms_mm);
  void showFigures();
  QString words() const;  ///< what to do next, or about the card
  void showScene(const PairScene& scene);
  void colourFracture();
  void measure(const Eigen::Vector3d& point);
  void forgetMeasured();

  PairReview& review_;
  CardInHand& hand_;
  CardList* cards_ = nullptr;
  PicturePair* pictures_ = nullptr;
  OutlinePlot* plot_ = nullptr;
  SherdView* view_ = nullptr;
  CandidateBar* candidates_ = nullptr;
  QLabel *reason_ = nullptr, *figures_ = nullptr;
  BigButton* accept_ = nullptr;
  ToolRow* tools_ = nullptr;
  QSplitter* compared_ = nullptr;
  QAction *mirror_ = nullptr, *apart_ = nullptr, *section_ = nullptr, *measure_ = nullptr,
          *along_fracture_ = nullptr, *closed_ = nullptr, *cut_ = nullptr, *join_ = nullptr;
  JoinMode* joining_ = nullptr;
  std::shared_ptr<const PairScene> scene_;  ///< what is seen; null: nothing
  QTimer blanking_;
  std::vector<Eigen::Vector3d> measured_;
  Eigen::Isometry3d measured_at_ = Eigen::Isometry3d::Identity();  ///< the back's pose then
};

}  // namespace ostraka::ui
