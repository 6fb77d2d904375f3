#pragma once
#include <QTemporaryDir>
#include <QtTest>

#include "../named.h"
#include "bench.h"
#include "ui/capture/capture_screen.h"
#include "ui/widgets/message_panel.h"

namespace ostraka::ui {

/// The screen Capture in a window, with a rig that answers as a test says.
class CaptureBench : public QObject {
 protected:
  void open() {
    folder_ = std::make_unique<QTemporaryDir>();
    bench_ = std::make_unique<Bench>(folder_->filePath("p").toStdString(), jobs_);
    session_ = &bench_->session;
    rig_ = &bench_->rig;
    wizard_ = &bench_->wizard;
    screen_ = std::make_unique<CaptureScreen>(wizard_);
    screen_->resize(1200, 640);
    screen_->openProject(*session_);
    activate(*screen_);
    screen_->setInFront(true);
  }
  void close() {
    screen_->closeProject();
    screen_.reset();
    bench_.reset();
  }
  template <class T>
  T* child(const char* name) {
    return named<T>(*screen_, name);
  }
  MessagePanel* shownMessage() {
    for (auto* panel : screen_->findChildren<MessagePanel*>())
      if (panel->isVisible()) return panel;
    return nullptr;
  }
  void toPlace() { bench_->toPlace(); }

  InlineJobRunner jobs_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<Bench> bench_;
  ProjectSession* session_ = nullptr;
  FakeRig* rig_ = nullptr;
  CaptureWizard* wizard_ = nullptr;
  std::unique_ptr<CaptureScreen> screen_;
};

}  // namespace ostraka::ui
