#include "cluster/tasks.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cluster_project.h"
#include "files/json.h"

namespace ostraka::cluster {
namespace {

class ListOfTasks : public ClusterProject {
 protected:
  static Tasks two() {
    return {"anna@login:/dig",
            {{"B0001", "ostraka-0123456789ab", 1, 2000, 30, "2026-09-21", false},
             {"B0002", "ostraka-0123456789ab", 2, 4000, 60, {}, true}}};
  }
};

TEST_F(ListOfTasks, ComesBackAsItWasWritten) {
  EXPECT_TRUE(readTasks(project_->folder())->tasks.empty()) << "there is none yet";
  ASSERT_TRUE(writeTasks(project_->folder(), two()));
  Tasks back = catalogue::valueIn(readTasks(project_->folder()));
  EXPECT_EQ(back.host, two().host);
  EXPECT_EQ(back.tasks, two().tasks);
  EXPECT_EQ(back.of("B0002"), &back.tasks[1]);
  EXPECT_EQ(back.of("B0003"), nullptr);
  EXPECT_TRUE(back.anyUncollected());
  back.of("B0001")->collected = true;
  EXPECT_FALSE(back.anyUncollected());
}

TEST_F(ListOfTasks, WithNumbersThatNoJobHasIsRefused) {
  ASSERT_TRUE(writeTasks(project_->folder(), two()));
  const fs::path file = clusterFolder(project_->folder()) / "tasks.json";
  const Result<nlohmann::json> good = readJson(file);
  ASSERT_TRUE(good);
  for (const auto& [key, value] :
       {std::pair("task", "4294967297"), std::pair("task", "1.5"), std::pair("task", "0"),
        std::pair("memory_mb", "-5"), std::pair("memory_mb", "2000000000"),
        std::pair("minutes", "1e99"), std::pair("minutes", "true"), std::pair("collected", "1"),
        std::pair("photographs", "1")}) {
    nlohmann::json changed = *good;
    changed["tasks"][0][key] = nlohmann::json::parse(value);
    put(file, changed.dump());
    EXPECT_FALSE(readTasks(project_->folder())) << key << " " << value;
  }
}

TEST_F(ListOfTasks, ThatAnybodyChangedIsRefused) {
  ASSERT_TRUE(writeTasks(project_->folder(), two()));
  const fs::path file = clusterFolder(project_->folder()) / "tasks.json";
  const std::string text = textOf(file);
  for (const auto& [from, to] : {std::pair("B0001", "../B01"), std::pair("ostraka-cluster/1", "x"),
                                 std::pair("\"job\": \"ostraka-", "\"job\": \"../../../")}) {
    std::string changed = text;
    ASSERT_NE(changed.find(from), std::string::npos) << from;
    put(file, changed.replace(changed.find(from), std::string(from).size(), to));
    EXPECT_FALSE(readTasks(project_->folder())) << to;
  }
}

}  // namespace
}  // namespace ostraka::cluster
