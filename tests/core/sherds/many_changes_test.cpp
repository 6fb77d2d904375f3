#include "sherds/many_changes.h"

#include "catalogue/history.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

// Stops after so many reports; counts them.
class Reports final : public Progress {
 public:
  explicit Reports(int until = 1000) : until_(until) {}
  void report(std::int64_t, std::int64_t total) override {
    total_ = total;
    if (++seen_ == until_) stop_.request_stop();
  }
  void note(NoteLevel, const Message&) override {}
  std::stop_token stop() const { return stop_.get_token(); }
  int seen() const { return seen_; }
  std::int64_t total() const { return total_; }

 private:
  int until_, seen_ = 0;
  std::int64_t total_ = 0;
  std::stop_source stop_;
};

class ManyChanges : public catalogue::SmallProject {
 protected:
  static constexpr int kSherds = 250;  // three transactions
  ManyChanges() {
    EXPECT_TRUE(catalogue().together([&]() -> Result<void> {
      for (int i = 0; i < kSherds; ++i) {
        rows.push_back(draft(context12));
        changes.push_back({rows.back(), "ware", "grey"});
        changes.push_back({rows.back(), "note", std::to_string(i)});
      }
      return {};
    }));
  }
  int withWare() {
    int count = 0;
    for (const records::SherdRecord& sherd : catalogue::valueIn(Sherds(catalogue()).of(rows)))
      count += sherd.ware == "grey";
    return count;
  }
  std::vector<store::SherdRow> rows;
  std::vector<records::FieldChange> changes;
};

TEST_F(ManyChanges, AreMadeInSeveralStepsAndUndoneByWhatComesBack) {
  Reports reports;
  const auto undo = changeMany(catalogue(), changes, anna, reports, {});
  ASSERT_TRUE(undo) << undo.error().sentence();
  EXPECT_EQ(withWare(), kSherds);
  EXPECT_EQ(reports.seen(), 5);  // 500 changes, a hundred each
  EXPECT_EQ(reports.total(), 500);
  EXPECT_EQ(undo->size(), changes.size());
  ASSERT_TRUE(changeMany(catalogue(), *undo, anna, reports, {}));
  EXPECT_EQ(withWare(), 0);
  EXPECT_EQ(valueOf(rows[249], "note"), "");
}

TEST_F(ManyChanges, StoppedInTheMiddleAreTakenBack) {
  Reports reports(3);
  const auto undo = changeMany(catalogue(), changes, anna, reports, reports.stop());
  ASSERT_FALSE(undo);
  EXPECT_EQ(undo.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(withWare(), 0);
  EXPECT_EQ(catalogue::History(catalogue()).of(rows[0])->size(), 5u)
      << "added, two changes, both taken back";
}

TEST_F(ManyChanges, OneThatIsRefusedTakesAllBack) {
  changes[481].value = "x";
  changes[481].field = "condition";  // no such term
  Reports reports;
  const auto undo = changeMany(catalogue(), changes, anna, reports, {});
  ASSERT_FALSE(undo);
  EXPECT_EQ(undo.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(withWare(), 0);
}

TEST_F(ManyChanges, OfOneSherdStayTogether) {
  // The parts of a place are looked at together; they must not fall into two transactions.
  std::vector<records::FieldChange> moves(changes.begin(), changes.begin() + 99);
  for (const char* field : {"site", "trench", "context"})
    moves.push_back({rows[249], field,
                     std::string_view(field) == "site"     ? "ARM1"
                     : std::string_view(field) == "trench" ? "T3"
                                                           : "0013"});
  Reports reports;
  ASSERT_TRUE(changeMany(catalogue(), moves, anna, reports, {}));
  EXPECT_EQ(reports.seen(), 1);
  EXPECT_EQ(valueOf(rows[249], "context"), "0013");
}

}  // namespace
}  // namespace ostraka::sherds
