#include "cluster/place.h"

#include <gmock/gmock.h>

#include "fake_cluster.h"

namespace ostraka::cluster {
namespace {

using testing::HasSubstr;

class PlaceOfCluster : public FakeCluster {
 protected:
  PlaceOfCluster() { program("rsync", ""); }
};

TEST_F(PlaceOfCluster, AHostIsReadAsAHostAndNothingElse) {
  for (const char* host : {"login", "login:", "login:folder", "-oProxyCommand=x:/f", ":/f",
                           "login:/f;rm", "lo gin:/f", "login:/f g", "login:/$(id)"})
    EXPECT_FALSE(Place::of(project_->folder(), host)) << host;
  const Result<Place> place = Place::of(project_->folder(), "anna@login.uni-x.de:/scratch/anna");
  ASSERT_TRUE(place) << place.error().sentence();
  EXPECT_EQ(place->name(), "anna@login.uni-x.de:/scratch/anna");
}

// A node's shell and a login node's read the words as they stand.
TEST_F(PlaceOfCluster, WordsArriveAsTheyStandHereAndThere) {
  const fs::path there = folder_.path() / "there";
  fs::create_directories(there);
  const std::string far = "anna@login:" + there.string();
  for (const std::string& host : {std::string(), far}) {
    const Result<Place> place = Place::of(project_->folder(), host);
    ASSERT_TRUE(place) << place.error().sentence();
    const Result<std::string> said =
        place->run({"printf", "<%s>", "a b", "it's", "$HOME", "\"`;", ""}, {});
    ASSERT_TRUE(said) << said.error().sentence();
    EXPECT_EQ(*said, "<a b><it's><$HOME><\"`;><>") << host;
    EXPECT_EQ(*place->run({"pwd"}, {}),
              (host.empty() ? fs::canonical(project_->folder()) : there).string() + "\n");
  }
}

TEST_F(PlaceOfCluster, WhatAProgramSaidLastStandsInTheError) {
  const Result<Place> place = Place::of(project_->folder(), {});
  const Result<std::string> failed =
      place->run({"sh", "-c", "printf %0500d 7; echo; echo 'no such partition' >&2; exit 2"}, {});
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::Failed);
  EXPECT_EQ(failed.error().where, place->name());
  // 400 bytes of it: 382 of the number, a line's end as a blank, and the sentence.
  const std::string end = "(..." + std::string(381, '0') + "7 no such partition)";
  EXPECT_THAT(failed.error().what.english(), HasSubstr(end));
  const Result<std::string> absent = place->run({"no-such-program"}, {});
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().code, ErrorCode::Missing);
}

TEST_F(PlaceOfCluster, NoFolderIsMadeThroughALinkOnTheCluster) {
  const fs::path there = folder_.path() / "there", elsewhere = folder_.path() / "elsewhere";
  fs::create_directories(there / "cluster");
  fs::create_directories(elsewhere);
  const Result<Place> place = Place::of(project_->folder(), "anna@login:" + there.string());
  ASSERT_TRUE(place) << place.error().sentence();
  for (const char* name : {"cluster/log", "cluster"}) {
    fs::remove(there / name);
    fs::create_directory_symlink(elsewhere, there / name);
    const Result<void> refused = place->prepare("anna's", {});
    ASSERT_FALSE(refused) << name;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(refused.error().where, "anna@login:" + (there / name).string());
    EXPECT_TRUE(fs::is_empty(elsewhere)) << name;
    fs::remove(there / name);
  }
  const Result<void> prepared = place->prepare("anna's", {});
  EXPECT_TRUE(prepared) << prepared.error().sentence();
  EXPECT_TRUE(fs::is_directory(there / "cluster/log"));
}

TEST_F(PlaceOfCluster, APathThatSlurmReadsAsSomethingElseIsRefused) {
  for (const char* name : {"100%", "a\\b", "a\nb"}) {
    const fs::path folder = folder_.path() / name;
    fs::create_directories(folder);
    const Result<Place> place = Place::of(folder, {});
    ASSERT_FALSE(place) << name;
    EXPECT_EQ(place.error().code, ErrorCode::UnusableInput);
    EXPECT_TRUE(Place::of(folder, "login:/dig")) << "only the folder there counts";
  }
}

}  // namespace
}  // namespace ostraka::cluster
