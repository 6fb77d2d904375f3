// Two programs that enter results of one batch at the same time, and what a killed one left.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "files/folder_lock.h"
#include "store/database.h"
#include "tests/core/intake/entering.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;

class EnteringTogether : public Entering {
 protected:
  fs::path models() const { return project_->folder() / "models/B0001"; }
  // As another program does it, with a connection of its own.
  Result<EnteredResults> enterElsewhere(std::stop_token stop) {
    Result<catalogue::Catalogue> rows = upkeep::Project::connect(project_->folder());
    if (!rows) return rows.error();
    QuietProgress unheard;
    return enterResults(*rows, project_->folder(), batch, project_->resultsFolder("B0001"), {},
                        unheard, std::move(stop));
  }
};

TEST_F(EnteringTogether, TheSecondWaitsUntilTheFirstHasEnded) {
  std::optional<Result<FolderLock>> first = FolderLock::take(models());
  ASSERT_TRUE(first->has_value());
  std::atomic<bool> ended = false;
  std::optional<Result<EnteredResults>> second;
  std::thread other([&] {
    second = enterElsewhere({});
    ended = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // five times what it takes alone
  EXPECT_FALSE(ended);
  first.reset();
  other.join();
  ASSERT_TRUE(*second) << second->error().sentence();
  EXPECT_EQ((*second)->models, 3);
}

TEST_F(EnteringTogether, TheSecondCanBeStoppedWhileItWaits) {
  const Result<FolderLock> first = FolderLock::take(models());
  std::stop_source stop;
  std::thread person([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop.request_stop();
  });
  const Result<EnteredResults> second = enterElsewhere(stop.get_token());
  person.join();
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::Cancelled);
  EXPECT_TRUE(sherds().empty());
}

TEST_F(EnteringTogether, NoneOfThreeProcessesTakesAModelFromAnother) {
  for (int round = 0; round < 4; ++round) {
    out.length_mm = 50 + round;
    out.write();
    for (const char* number : {"01", "02", "03"}) {
      ASSERT_TRUE(writeFileAtomically(
          project_->resultsFolder("B0001") / "sherds" / number / "model.ply",
          std::string("model ") + number + " of round " + std::to_string(round)));
      out.noteModel(project_->resultsFolder("B0001"), number);
    }
    std::vector<pid_t> processes;
    for (int i = 0; i < 3; ++i)
      if (const pid_t child = ::fork(); child == 0)
        ::_exit(enterElsewhere({}) ? 0 : 1);
      else
        processes.push_back(child);
    for (const pid_t child : processes) {
      int status = -1;
      ASSERT_EQ(::waitpid(child, &status, 0), child);
      EXPECT_EQ(status, 0) << "round " << round;
    }
    for (const records::SherdRecord& sherd : sherds())
      EXPECT_TRUE(fs::exists(project_->folder() / sherd.model_path)) << sherd.model_path;
  }
}

TEST_F(EnteringTogether, WhatAKilledRunLeftIsRemovedAndNothingOfAPerson) {
  ASSERT_TRUE(writeFileAtomically(models() / "new.partial/model-a1B2c3/content/model.ply", "half"));
  ASSERT_TRUE(writeFileAtomically(models() / "new.partial/model.ply", "half, by an older version"));
  ASSERT_TRUE(writeFileAtomically(models() / "from the museum/model.ply", "another scan"));
  enter();
  EXPECT_FALSE(fs::exists(models() / "new.partial"));
  EXPECT_TRUE(fs::exists(models() / "from the museum/model.ply"));
}

}  // namespace
}  // namespace ostraka::intake
