#include "cluster/access.h"

#include <gmock/gmock.h>

#include "fake_cluster.h"

namespace ostraka::cluster {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ReachCluster : public FakeCluster {};

TEST_F(ReachCluster, NoHostThatAProjectBringsIsContacted) {
  queuedBatch();
  submitting.access.host = "anna@login:" + (folder_.path() / "there").string();
  std::vector<std::string> contacted;
  submitting.access.contacting = [&](const std::string& host) { contacted.push_back(host); };
  put(fault() / "down", "");
  EXPECT_FALSE(submitAll());
  EXPECT_THAT(contacted, ElementsAre(submitting.access.host));

  const std::string named = submitting.access.host, strange = "evil@attacker.example:/x";
  submitting.access = {};
  fs::remove(fault() / "down");
  Tasks tasks;
  tasks.host = strange;
  tasks.tasks = {{"B0001", "ostraka-0123456789ab", 1, 2000, 30, {}, false}};
  ASSERT_TRUE(writeTasks(project_->folder(), tasks));
  for (const auto& refused : {submitAll().error(), status(project_->folder(), {}, {}).error(),
                              collect(*project_, {}, quiet, {}).error()}) {
    EXPECT_EQ(refused.code, ErrorCode::UnusableInput);
    EXPECT_THAT(refused.sentence().english(), HasSubstr(strange));
  }
  EXPECT_FALSE(fs::exists(fault() / "logins"));
  // Without tasks there it is of no account: the host is the one that was named here.
  Tasks none;
  none.host = strange;
  const Result<Place> place = reach(catalogue(), project_->folder(), {}, none);
  ASSERT_TRUE(place) << place.error().sentence();
  EXPECT_EQ(place->name(), named);
}

TEST_F(ReachCluster, AHostIsRememberedForItsProjectAlone) {
  Tasks none;
  const std::string host = "anna@login:/dig";
  ASSERT_TRUE(reach(catalogue(), project_->folder(), {host, {}}, none));
  records::ProjectRecord record;
  record.code = "OTHER";
  const auto other = upkeep::Project::create(folder_.path() / "other", record);
  ASSERT_TRUE(other);
  Tasks of_other;
  const Result<Place> here = reach(other->catalogue(), other->folder(), {}, of_other);
  ASSERT_TRUE(here) << here.error().sentence();
  EXPECT_FALSE(here->isRemote());
  EXPECT_THAT(of_other.host, testing::IsEmpty());
}

// Copies of a project that are sent to one login node must not be taken for one another there.
TEST_F(ReachCluster, AnOwnerIsThatOfACopyOfTheProjectOnAComputer) {
  const fs::path copy = folder_.path() / "copy";
  const std::string owner = *ownerOf(catalogue(), project_->folder());
  EXPECT_EQ(owner.size(), 64u);
  EXPECT_EQ(owner, *ownerOf(catalogue(), project_->folder())) << "whenever it is asked";
  EXPECT_EQ(owner, *ownerOf(catalogue(), project_->folder() / ".")) << "however it is written";
  EXPECT_NE(owner, *ownerOf(catalogue(), copy));
  Tasks none;
  ASSERT_TRUE(reach(catalogue(), project_->folder(), {"anna@login:/dig", {}}, none));
  EXPECT_EQ(owner, *ownerOf(catalogue(), project_->folder())) << "also with another host";
  ::setenv("XDG_CONFIG_HOME", (folder_.path() / "another computer").c_str(), 1);
  EXPECT_NE(owner, *ownerOf(catalogue(), project_->folder()));
}

TEST_F(ReachCluster, AMemoryThatCannotBeReadIsNamed) {
  ASSERT_TRUE(ownerOf(catalogue(), project_->folder()));
  fs::path memory;
  for (const fs::directory_entry& file :
       fs::directory_iterator(folder_.path() / "config/ostraka/clusters"))
    memory = file.path();
  for (const char* text : {"[]", "{}", R"({"host": 5})"}) {
    put(memory, text);
    Tasks none;
    const Result<Place> place = reach(catalogue(), project_->folder(), {}, none);
    ASSERT_FALSE(place) << text;
    EXPECT_EQ(place.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(place.error().where, memory.string());
    EXPECT_FALSE(ownerOf(catalogue(), project_->folder())) << text;
  }
}

TEST_F(ReachCluster, BatchesThatAreElsewhereKeepAnotherHostAway) {
  Tasks tasks;
  tasks.host = "anna@login:/dig";
  tasks.tasks = {{"B0001", "ostraka-0123456789ab", 1, 2000, 30, {}, false}};
  const Access other{"anna@other:/dig", {}};
  EXPECT_EQ(reach(catalogue(), project_->folder(), other, tasks).error().where, other.host);
  EXPECT_EQ(tasks.host, "anna@login:/dig");
  tasks.tasks.front().collected = true;
  EXPECT_EQ(reach(catalogue(), project_->folder(), other, tasks)->name(), other.host);
  EXPECT_EQ(tasks.host, other.host);
}

}  // namespace
}  // namespace ostraka::cluster
