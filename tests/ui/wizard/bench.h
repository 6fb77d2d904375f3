#pragma once
#include <QtTest>

#include "../project_in.h"
#include "catalogue/batches.h"
#include "fake_rig.h"
#include "ui/frame/project_session.h"
#include "ui/wizard/batch_description.h"
#include "ui/wizard/capture_text.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/plate_pictures.h"
#include "ui/wizard/rig_connection.h"
#include "ui/wizard/side_progress.h"

/// A project, new or found in its folder, with a wizard and a rig that answers as a test says.
namespace ostraka::ui {

struct Bench {
  explicit Bench(const std::filesystem::path& folder, JobRunner& jobs)
      : session(projectIn(folder), folder, jobs) {
    wizard.setSession(&session);
  }
  records::BatchRecord batch() {
    return catalogue::Batches(session.project().catalogue()).all()->front();
  }
  void goOn(CapturePhase to) {
    wizard.next();
    QTRY_COMPARE(wizard.phase(), to);
  }
  void toPlace() {
    wizard.rig()->choose(sourceOf(rig));
    QTRY_COMPARE(wizard.phase(), CapturePhase::Place);
  }
  void toFlip() {
    toPlace();
    goOn(CapturePhase::Flip);
  }
  void toDone() {
    toFlip();
    goOn(CapturePhase::Done);
  }

  FakeRig rig;
  ProjectSession session;
  CaptureWizard wizard;
  CaptureText text{wizard};
};

}  // namespace ostraka::ui
