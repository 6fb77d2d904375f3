#pragma once
#include <QImage>
#include <QObject>
#include <QPointer>
#include <QPolygonF>
#include <filesystem>
#include <vector>

#include "decisions/mask_strokes.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// The masks of a batch: one photograph after the other with what is sherd on it, and a brush. Each
/// stroke is saved at once and can be undone; the next computation follows them. No widget.
class MaskModel final : public QObject {
  Q_OBJECT

 public:
  explicit MaskModel(QObject* parent = nullptr) : QObject(parent) {}

  /// Reads which photographs there are, and shows the first; `changed` or `failed` follows.
  void openBatch(ProjectSession& session, const QString& batch);
  void close();

  const QString& batch() const { return batch_; }
  int count() const { return static_cast<int>(photographs_.size()); }
  QString title(int index) const;  ///< "front, camera A, stop 1"
  int index() const { return index_; }
  bool isEdited(int index) const;                   ///< somebody painted on it
  int edited() const;                               ///< how many photographs are
  bool canCompute() const { return can_compute_; }  ///< masks are others than were computed

  /// The photograph, and an overlay of what is sherd; null while they are read.
  const QImage& photograph() const { return photograph_; }
  const QImage& overlay() const { return overlay_; }

  void show(int index);
  /// path: in pixels of the photograph.
  void paint(decisions::MaskPaint paint, const QPolygonF& path, double radius_px);

 signals:
  void changed();  ///< photographs, or which is shown
  void overlayChanged();
  void failed(const QString& sentence);

 private:
  friend class StrokeCommand;
  struct Shown {
    QImage photograph, overlay;
    std::string hash;  ///< of the photograph's file
  };
  std::vector<decisions::MaskStroke> strokesOn(int index) const;
  Result<void> hold(std::vector<decisions::MaskStroke> strokes);
  void compare();
  void drawOverlay();
  void settle(ProjectSession* session, const QString& batch);
  static Result<Shown> read(const decisions::MaskedPhotograph& photograph);

  QPointer<ProjectSession> session_;
  QString batch_;
  std::filesystem::path output_;
  std::vector<decisions::MaskedPhotograph> photographs_;
  std::vector<std::string> hashes_;  ///< of photographs; empty where none was asked for
  std::vector<decisions::MaskStroke> strokes_;
  bool can_compute_ = false;
  int index_ = -1;
  QImage photograph_, found_overlay_, overlay_;
  QPointer<JobHandle> job_, settling_;
  QString settle_next_;  ///< a batch that was painted on meanwhile
};

}  // namespace ostraka::ui
