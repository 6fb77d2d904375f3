#pragma once
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "catalogue/files.h"
#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "exported_project.h"
#include "flipped_bits.h"
#include "merge/merge.h"
#include "sherds/measurements.h"
#include "sherds/pair_decisions.h"

namespace ostraka::merge {

/// A project with a batch of three described sherds, and copies of it that go their own ways.
class TwoHouses : public exchange::ExportedProject {
 protected:
  /// Rows have the numbers that they have in the first project.
  upkeep::Project copied(const std::string& name) {
    namespace fs = std::filesystem;
    const fs::path to = folder_.path() / name;
    fs::create_directories(to);
    for (const char* part : {"batches", "results", "models"})
      fs::copy(project_->folder() / part, to / part, fs::copy_options::recursive);
    if (const Result<void> saved = catalogue().backup(to / "catalogue.sqlite"); !saved)
      throw std::runtime_error(saved.error().sentence().english());
    return catalogue::valueIn(upkeep::Project::open(to, [this] { return now_ms += 1; }));
  }
  Result<MergeReport> tried(upkeep::Project& a, const upkeep::Project& b, const Settled& settled) {
    return mergeInto(a, b.folder(), MergeMode::Enter, settled, {{}, "merge", {}}, quiet, {});
  }
  MergeReport merged(upkeep::Project& a, const upkeep::Project& b, const Settled& settled = {}) {
    return catalogue::valueIn(tried(a, b, settled));
  }
  void say(upkeep::Project& project, store::SherdRow sherd, const std::string& field,
           const std::string& value) {
    const records::FieldChange change{sherd, field, value, records::Confirmation::Given};
    const auto done = sherds::SherdChanges(project.catalogue()).apply(std::span(&change, 1), anna);
    EXPECT_TRUE(done) << (done ? "" : done.error().sentence().english());
  }
  static std::string saidOf(const upkeep::Project& project, const std::string& id,
                            const std::string& field) {
    const sherds::Sherds all(project.catalogue());
    return sherds::textOf(*all.get(*all.byId(id)), field);
  }
  std::string idOf(store::SherdRow sherd) { return sherds::Sherds(catalogue()).get(sherd)->id; }
  store::SherdRow newSherd(upkeep::Project& project, store::ContextRow in, bool numbered) {
    records::SherdRecord sherd;
    sherd.context = in;
    const store::SherdRow row = *sherds::Sherds(project.catalogue()).add(sherd, anna);
    if (numbered) {
      EXPECT_TRUE(sherds::Numbers(project.catalogue()).assign(std::span(&row, 1), anna));
    }
    return row;
  }
  static std::string contentIn(const upkeep::Project& project) {
    return *catalogue::contentOf(project.catalogue().database());
  }
  static std::vector<std::string> openIn(const MergeReport& report) {
    std::vector<std::string> ids;
    for (const Conflict& conflict : report.conflicts)
      if (!conflict.settled) ids.push_back(conflict.id);
    return ids;
  }
  static Choice take(Take side) { return {side, {}}; }
};

/// The first project, and one copy of it.
class TwoCopies : public TwoHouses {
 protected:
  TwoCopies() : b_(copied("b")) {}
  upkeep::Project b_;
};

/// Two copies of which both houses changed something.
class Conflicts : public TwoCopies {
 protected:
  /// Nothing is written before it is settled; afterwards neither direction asks again.
  void settle(const Settled& settled) {
    const std::string before = contentIn(*project_), before_b = contentIn(b_);
    const MergeReport open = merged(*project_, b_);
    EXPECT_FALSE(open.entered);
    std::vector<std::string> ids;
    for (const auto& [id, choice] : settled) ids.push_back(id);
    EXPECT_THAT(openIn(open), testing::UnorderedElementsAreArray(ids));
    EXPECT_EQ(contentIn(*project_), before);
    const MergeReport done = merged(*project_, b_, settled);
    EXPECT_TRUE(done.entered);
    EXPECT_THAT(openIn(done), testing::IsEmpty());
    EXPECT_EQ(contentIn(b_), before_b);
    const std::string after = contentIn(*project_);
    EXPECT_THAT(openIn(merged(*project_, b_)), testing::IsEmpty());
    EXPECT_EQ(contentIn(*project_), after);
    EXPECT_THAT(openIn(merged(b_, *project_)), testing::IsEmpty());
    EXPECT_TRUE(project_->catalogue().checkIntegrity());
    EXPECT_TRUE(b_.catalogue().checkIntegrity());
  }
};

}  // namespace ostraka::merge
