#include "catalogue/stamped_rows.h"

#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "small_project.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

TEST(ColumnValue, IsToldWithAllItsDigitsAndNothingForNone) {
  EXPECT_EQ(ColumnValue("a b").told(), "a b");
  EXPECT_EQ(ColumnValue(0.1).told(), "0.1");
  EXPECT_EQ(ColumnValue(7).told(), "7");
  EXPECT_EQ(ColumnValue(store::BagRow{12}).told(), "12");
  EXPECT_EQ(ColumnValue(store::BagRow{}).told(), "");
  EXPECT_EQ(ColumnValue(std::optional<double>()).told(), "");
  EXPECT_EQ(ColumnValue(std::optional<std::string>("x")).told(), "x");
}

// Rows of the table of persons, whose columns are few.
class StampedRows : public SmallProject {
 protected:
  using Changes = Column::Changes;
  static std::vector<Column> person(const std::string& name, const std::string& initials) {
    return {{"name", name},
            {"initials", initials, Changes::Untold},
            {"initials_key", initials, Changes::Never}};
  }
  std::int64_t save(std::int64_t row, const std::vector<Column>& columns) {
    std::int64_t saved = 0;
    const Result<void> done = catalogue().together([&]() -> Result<void> {
      saved = saveRow(catalogue(), anna, "person", row, "", columns);
      return {};
    });
    EXPECT_TRUE(done) << (done ? "" : done.error().sentence().english());
    return saved;
  }
  std::string of(std::int64_t row, const std::string& column) {
    std::string value;
    store::Statement found = catalogue().database().sql(
        "SELECT CAST(" + column + " AS TEXT) FROM person WHERE row = ?", row);
    EXPECT_TRUE(found.read(value)) << column;
    return value;
  }
  std::size_t told(std::int64_t row) { return History(catalogue()).of("person", row)->size(); }
};

TEST_F(StampedRows, AreStampedWithWhoMadeAndWhoChangedThem) {
  const std::int64_t row = save(0, person("Eva", "E"));
  EXPECT_EQ(of(row, "id").size(), 36u);
  EXPECT_EQ(of(row, "created_by"), std::to_string(anna.person.value));
  EXPECT_EQ(of(row, "created_at"), of(row, "updated_at"));
  EXPECT_EQ(of(row, "revision"), "1");
  EXPECT_EQ(save(row, person("Eva B.", "E")), row);
  EXPECT_EQ(of(row, "name"), "Eva B.");
  EXPECT_EQ(of(row, "revision"), "2");
  EXPECT_LT(of(row, "created_at"), of(row, "updated_at"));
  EXPECT_EQ(told(row), 1u);
  EXPECT_EQ(History(catalogue()).of("person", row)->front().old_value, "Eva");
}

TEST_F(StampedRows, ThatAreTheSameAreNotTouched) {
  const std::int64_t row = save(0, person("Eva", "E"));
  save(row, person("Eva", "E"));
  EXPECT_EQ(of(row, "revision"), "1");
  EXPECT_EQ(told(row), 0u);
}

// A key follows from what people see: it goes along with that, and is no change of its own.
TEST_F(StampedRows, TellOnlyOfColumnsThatPeopleSee) {
  const std::int64_t row = save(0, person("Eva", "E"));
  save(row, person("Eva", "EB"));
  EXPECT_EQ(of(row, "initials"), "E");
  save(row, person("Eva B.", "EB"));
  EXPECT_EQ(of(row, "initials"), "EB");
  EXPECT_EQ(of(row, "initials_key"), "E") << "written with a new row alone";
  EXPECT_EQ(told(row), 1u);
}

TEST_F(StampedRows, ThatAreGoneAreNamed) {
  const Result<void> done = catalogue().together([&]() -> Result<void> {
    saveRow(catalogue(), anna, "person", 99, "", person("Eva", "E"));
    return {};
  });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().sentence(), "This person is no longer in the catalogue.");
}

TEST_F(StampedRows, NeverTakeTheNumberOfARowThatTheHistorySpeaksOf) {
  const std::int64_t lost = save(0, person("Eva", "E"));
  save(lost, person("Eva B.", "E"));
  catalogue().database().run("DELETE FROM person WHERE row = ?", lost);
  EXPECT_EQ(save(0, person("Ida", "I")), lost + 1);
}

}  // namespace
}  // namespace ostraka::catalogue
