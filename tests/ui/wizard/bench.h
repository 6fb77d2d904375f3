#pragma once
#include "catalogue/batches.h"
#include "fake_rig.h"
#include "records/records.h"
#include "ui/frame/project_session.h"
#include "ui/wizard/batch_description.h"
#include "ui/wizard/capture_text.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/plate_pictures.h"
#include "ui/wizard/rig_connection.h"
#include "ui/wizard/side_progress.h"
#include "upkeep/project.h"

/// A project, new or found in its folder, with a wizard and a rig that answers as a test says.
namespace ostraka::ui {

struct Bench {
  explicit Bench(const std::filesystem::path& folder, JobRunner& jobs)
      : session(projectIn(folder), folder, jobs) {
    wizard.setSession(&session);
  }
  static std::shared_ptr<upkeep::Project> projectIn(const std::filesystem::path& folder) {
    records::ProjectRecord record;
    record.code = "TEST";
    record.title = "Test";
    auto made = upkeep::Project::isProject(folder) ? upkeep::Project::open(folder)
                                                   : upkeep::Project::create(folder, record);
    if (!made) qFatal("%s", made.error().sentence().c_str());
    return std::make_shared<upkeep::Project>(std::move(*made));
  }
  records::BatchRecord batch() {
    return catalogue::Batches(session.project().catalogue()).all()->front();
  }

  FakeRig rig;
  ProjectSession session;
  CaptureWizard wizard;
  CaptureText text{wizard};
};

}  // namespace ostraka::ui
