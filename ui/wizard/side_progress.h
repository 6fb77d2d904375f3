#pragma once
#include <QObject>
#include <any>
#include <vector>

#include "capture/sequence.h"
#include "ui/wizard/capture_facts.h"
#include "ui/wizard/rig_source.h"

namespace ostraka::ui {

/// How far the photographs of a side are: those that are there, and where the turntable stands.
class SideProgress final : public QObject {
  Q_OBJECT

 public:
  explicit SideProgress(QObject* parent) : QObject(parent) {}

  const std::vector<TakenShot>& shots() const { return shots_; }
  int currentStop() const { return stop_; }  ///< -1: none
  int stopsDone() const { return stops_done_; }
  const PreparedPhotographs& prepared() const { return prepared_; }
  /// Steps of what is photographed now: for calibration those photographs, else the positions.
  PreparedPhotographs steps(int stops) const {
    return prepared_.total > 0 ? prepared_ : PreparedPhotographs{stops_done_, stops};
  }
  const std::vector<capture::ShotName>& retaking() const { return retaking_; }
  int saved() const;  ///< photographs of the side
  QStringList problemsOf(const capture::ShotName& shot) const;

  void forget();
  void begin(std::vector<capture::ShotName> retake);
  void goOn();  ///< with what was asked for again and is not kept yet
  /// These were taken before the window was closed; false: none were.
  bool resume(std::vector<TakenShot> shots, int stops, int cameras);
  void hear(const std::any& told);  ///< a CaptureEvent or PreparedPhotographs
  void standStill() { stop_ = -1; }
  void end() { retaking_.clear(); }

 signals:
  void changed();    ///< the photographs, or the position
  void preparing();  ///< prepared()
  void said(const QString& sentence);

 private:
  void follow(const capture::CaptureEvent& event);
  void keep(const capture::CaptureEvent& event);

  std::vector<TakenShot> shots_;
  std::vector<capture::ShotName> retaking_;  ///< asked for again and not kept yet
  PreparedPhotographs prepared_;
  int stop_ = -1, stops_done_ = 0;
};

}  // namespace ostraka::ui
