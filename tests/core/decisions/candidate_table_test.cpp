#include "decisions/candidate_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "files/files.h"
#include "files/scratch_folder.h"

namespace ostraka::decisions {
namespace {

TEST(CandidateTable, KeepsWhatEachSideLayOn) {
  CandidateTable table;
  table.supports[1].emplace();
  table.supports[1]->reach_mm = 180;
  table.supports[1]->coefficients_mm[2] = -1.5;
  const ScratchFolder folder = std::move(*ScratchFolder::make("table"));
  const std::filesystem::path file = folder.path() / "candidates.json";
  ASSERT_TRUE(writeFileAtomically(file, toJson(table).dump()));
  const Result<CandidateTable> read = readCandidates(file);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_FALSE(read->supports[0].has_value());
  ASSERT_TRUE(read->supports[1].has_value());
  EXPECT_EQ(read->supports[1]->reach_mm, 180);
  EXPECT_EQ(read->supports[1]->coefficients_mm, table.supports[1]->coefficients_mm);

  nlohmann::json foreign = toJson(table);
  foreign["supports"]["back"]["reach"] = 0;
  ASSERT_TRUE(writeFileAtomically(file, foreign.dump()));
  EXPECT_FALSE(readCandidates(file).has_value());
}

TEST(CandidateTable, OfThePapersPairingStatesDistancesAndNoLikelihoods) {
  CandidateTable table;
  table.method = pairing::Method::Paper;
  table.fronts.push_back({batch::Side::Front, "f001", Eigen::Vector2d::Zero(), {}});
  table.backs.push_back({batch::Side::Back, "b001", Eigen::Vector2d::Zero(), {}});
  RegisteredCandidate candidate;
  candidate.evidence.distance_rad = 0.25;
  candidate.starts.emplace_back();
  table.candidates.push_back(candidate);
  const nlohmann::json json = toJson(table);
  EXPECT_TRUE(json.at("candidates").at(0).at("log_likelihood").is_null());
  EXPECT_TRUE(json.at("candidates").at(0).at("starts").at(0).at("log_likelihood").is_null());
  const ScratchFolder folder = std::move(*ScratchFolder::make("table"));
  const std::filesystem::path file = folder.path() / "candidates.json";
  ASSERT_TRUE(writeFileAtomically(file, json.dump()));
  const Result<CandidateTable> read = readCandidates(file);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(read->method, pairing::Method::Paper);
  ASSERT_EQ(read->candidates.size(), 1u);
  EXPECT_EQ(read->candidates[0].evidence.distance_rad, 0.25);
}

}  // namespace
}  // namespace ostraka::decisions
