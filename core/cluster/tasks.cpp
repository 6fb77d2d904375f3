#include "cluster/tasks.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cluster/job_script.h"
#include "cluster/queue_text.h"
#include "files/contained_path.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "upkeep/file_check.h"

namespace ostraka::cluster {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTasksFormat = "ostraka-cluster/1";

fs::path tasksFile(const fs::path& project) {
  return clusterFolder(project) / "tasks.json";
}

bool isUsable(const Task& task) {
  const Result<ContainedPath> batch = ContainedPath::parse(task.batch);
  return batch && batch->parts().size() == 1 && isJobName(task.job);
}

}  // namespace

Task* Tasks::of(const std::string& batch) {
  const auto found = std::ranges::find(tasks, batch, &Task::batch);
  return found == tasks.end() ? nullptr : &*found;
}

bool Tasks::anyUncollected() const {
  return std::any_of(tasks.begin(), tasks.end(), [](const Task& t) { return !t.collected; });
}

fs::path clusterFolder(const fs::path& project) {
  return project / "cluster";
}

Result<Tasks> readTasks(const fs::path& project) {
  if (const Result<void> own = upkeep::checkNoLinkInCluster(project); !own) return own.error();
  Tasks tasks;
  const fs::path file = tasksFile(project);
  std::error_code failed;
  if (!fs::exists(file, failed)) return tasks;
  const Result<nlohmann::json> value = readJson(file);
  if (!value) return value.error();
  const Error bad = Error::unusable(
      message(
          "Not a list of the batches on a cluster; restore an earlier one, or delete it: batches "
          "that are on the cluster are then processed again."),
      file.string());
  try {
    if (value->at("format") != kTasksFormat) return bad;
    tasks.host = value->at("host");
    for (const nlohmann::json& one : value->at("tasks")) {
      const Task task{.batch = one.at("batch"),
                      .job = one.at("job"),
                      .number = wholeAt(one, "task", 1, kMostTasks),
                      .memory_mb = wholeAt(one, "memory_mb", 1, kMostMemory_mb),
                      .minutes = wholeAt(one, "minutes", 1, kMostMinutes),
                      .photographs = one.at("photographs"),
                      .collected = one.at("collected")};
      if (!isUsable(task)) return bad;
      tasks.tasks.push_back(task);
    }
  } catch (const nlohmann::json::exception&) {
    return bad;
  }
  return tasks;
}

Result<void> writeTasks(const fs::path& project, const Tasks& tasks) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Task& task : tasks.tasks)
    list.push_back({{"batch", task.batch},
                    {"job", task.job},
                    {"task", task.number},
                    {"memory_mb", task.memory_mb},
                    {"minutes", task.minutes},
                    {"photographs", task.photographs},
                    {"collected", task.collected}});
  return writeJson(tasksFile(project),
                   {{"format", kTasksFormat}, {"host", tasks.host}, {"tasks", list}});
}

}  // namespace ostraka::cluster
