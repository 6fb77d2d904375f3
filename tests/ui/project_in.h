#pragma once
#include <QtGlobal>
#include <filesystem>
#include <memory>

#include "records/records.h"
#include "upkeep/project.h"

namespace ostraka::ui {

/// The project of a folder, made where there is none yet.
inline std::shared_ptr<upkeep::Project> projectIn(const std::filesystem::path& folder,
                                                  const char* code = "TEST") {
  records::ProjectRecord record;
  record.code = code;
  record.title = "Test";
  auto made = upkeep::Project::isProject(folder) ? upkeep::Project::open(folder)
                                                 : upkeep::Project::create(folder, record);
  if (!made) qFatal("%s", made.error().sentence().english().c_str());
  return std::make_shared<upkeep::Project>(std::move(*made));
}

}  // namespace ostraka::ui
