// Three copies of one project, edited at random: whatever is merged into what, in any order and as
// often as one likes, they end as the same project, and nothing is lost.
#include <gmock/gmock.h>

#include <map>
#include <random>
#include <set>

#include "two_houses.h"

namespace ostraka::merge {
namespace {

using namespace catalogue;

class Orders : public TwoHouses, public testing::WithParamInterface<unsigned> {
 protected:
  using Random = std::mt19937_64;

  // What a person sees of the project, known by uuids, but for places, which are known by numbers.
  static std::set<std::string> seen(const upkeep::Project& project) {
    std::set<std::string> lines;
    const Catalogue& catalogue = project.catalogue();
    const sherds::Sherds all(catalogue);
    for (const store::SherdRow row : valueIn(all.rows(sherds::Filter{}, {}))) {
      const records::SherdRecord sherd = valueIn(all.get(row));
      for (const records::SherdField& field : sherds::sherdFields())
        lines.insert(sherd.id + " " + field.name + ": " + sherds::textOf(sherd, field.name));
      for (const char* own : {"extra.drawer", "extra.shelf"})
        lines.insert(sherd.id + " " + own + ": " + sherds::textOf(sherd, own));
    }
    for (const records::ContextRecord& c : valueIn(Places(catalogue).contexts()))
      lines.insert("context " + c.site_code + c.trench_code + c.number + " " + c.period);
    for (const records::BatchRecord& b : valueIn(Batches(catalogue).all()))
      lines.insert("batch " + b.id + " " + b.note);
    return lines;
  }

  // Each field of each sherd belongs to one of the projects, so that no two say different things.
  void edit(std::vector<upkeep::Project*>& projects, Random& random) {
    const std::vector<std::string> fields = {"ware",   "fabric",       "note",        "vessel",
                                             "period", "extra.drawer", "extra.shelf", "weight_g"};
    for (int i = 0; i < 40; ++i) {
      const std::size_t sherd = random() % rows.size(), field = random() % fields.size();
      upkeep::Project& project = *projects[(sherd * 5 + field * 3) % projects.size()];
      std::string value = random() % 4 == 0 ? "" : std::to_string(1 + random() % 50);
      say(project, rows[sherd], fields[field], value);
    }
    for (std::size_t i = 0; i < projects.size(); ++i) {
      upkeep::Project& project = *projects[i];
      for (std::uint64_t n = random() % 4; n > 0; --n) {
        records::ContextRecord c;
        c.site = site;
        c.trench = trench;
        c.number = "9" + std::to_string(random() % 6);  // several make the same one
        const auto made = Places(project.catalogue()).save(c, anna);
        if (!made) continue;  // it is there
        const store::SherdRow row = newSherd(project, *made, false);
        say(project, row, "note", "of " + std::to_string(i) + " " + std::to_string(now_ms));
      }
      records::BatchRecord record;  // each is the next one, B0002
      record.note = "of " + std::to_string(i);
      EXPECT_TRUE(Batches(project.catalogue()).add(record, anna));
    }
  }
};

TEST_P(Orders, EndAsTheSameProject) {
  Random random(GetParam());
  upkeep::Project b = copied("b"), c = copied("c");
  std::vector<upkeep::Project*> projects = {&*project_, &b, &c};
  edit(projects, random);
  std::set<std::string> notes;  // of what each made
  for (const upkeep::Project* project : projects)
    for (const std::string& line : seen(*project))
      if (line.find(": of ") != std::string::npos || line.starts_with("batch ")) notes.insert(line);
  const auto once = [&](std::size_t into, std::size_t from) {
    const Result<MergeReport> report = tried(*projects[into], *projects[from], {});
    ASSERT_TRUE(report) << report.error().sentence();
    for (const Conflict& conflict : report->conflicts) ADD_FAILURE() << conflict.id;
    ASSERT_TRUE(report->entered);
  };
  for (int i = 0; i < 5; ++i) {
    const std::size_t into = random() % 3;
    once(into, (into + 1 + random() % 2) % 3);
  }
  const std::vector<std::pair<std::size_t, std::size_t>> all_pairs = {{0, 1}, {0, 2}, {1, 0},
                                                                      {2, 0}, {1, 2}, {2, 1}};
  for (const auto& [into, from] : all_pairs) once(into, from);
  const std::set<std::string> end = seen(*project_);
  EXPECT_EQ(seen(b), end);
  EXPECT_EQ(seen(c), end);
  for (const std::string& line : notes) EXPECT_TRUE(end.contains(line)) << line << " is lost";
  for (const upkeep::Project* project : projects) {
    EXPECT_TRUE(project->catalogue().checkIntegrity());
    EXPECT_EQ(Batches(project->catalogue()).all()->size(), 4u);
  }
  for (const auto& [into, from] : all_pairs) {
    const std::string before = contentIn(*projects[into]);
    once(into, from);
    EXPECT_EQ(contentIn(*projects[into]), before) << "merging once more changes nothing";
  }
}

// Each house gives the number N3 to a sherd of its own, and takes the other's word on all numbers.
TEST_P(Orders, GiveEachNumberToOneSherdThatSomeProjectGaveItTo) {
  Random random(GetParam());
  upkeep::Project b = copied("b"), c = copied("c");
  const std::vector<upkeep::Project*> projects = {&*project_, &b, &c};
  for (upkeep::Project* project : projects)
    say(*project, newSherd(*project, context13, false), "number", "N3");
  const auto numbersIn = [](const upkeep::Project& project) {
    std::map<std::string, std::string> numbers;  // by sherd
    const sherds::Sherds held(project.catalogue());
    for (const store::SherdRow row : valueIn(held.rows(sherds::Filter{}, {}))) {
      const records::SherdRecord sherd = valueIn(held.get(row));
      if (!sherd.number.empty()) numbers[sherd.id] = sherd.number;
    }
    return numbers;
  };
  for (int i = 0; i < 6; ++i) {
    const std::size_t into = random() % 3, from = (into + 1 + random() % 2) % 3;
    const auto before = numbersIn(*projects[into]), theirs = numbersIn(*projects[from]);
    Settled settled;
    MergeReport report = merged(*projects[into], *projects[from]);
    for (int round = 0; round < 3 && !report.entered; ++round) {
      for (const std::string& id : openIn(report)) settled[id] = take(Take::B);
      report = merged(*projects[into], *projects[from], settled);
    }
    ASSERT_TRUE(report.entered);
    std::set<std::string> borne;
    for (const auto& [sherd, number] : numbersIn(*projects[into])) {
      EXPECT_TRUE(borne.insert(number).second) << number;
      const auto mine = before.find(sherd), other = theirs.find(sherd);
      const bool given = (mine != before.end() && mine->second == number) ||
                         (other != theirs.end() && other->second == number);
      EXPECT_TRUE(given || report.new_numbers.contains(sherd)) << number << " came unnamed";
      EXPECT_TRUE(given || other == theirs.end()) << "not " << other->second << ", but " << number;
    }
    EXPECT_TRUE(projects[into]->catalogue().checkIntegrity());
    const std::string content = contentIn(*projects[into]);
    EXPECT_THAT(openIn(merged(*projects[into], *projects[from])), testing::IsEmpty());
    EXPECT_EQ(contentIn(*projects[into]), content);
  }
}

// Each house entered the sherd N3 from its own list, and says that it is one sherd.
TEST_P(Orders, MakeOneSherdOfTheRecordsOfEachHouse) {
  Random random(GetParam());
  upkeep::Project b = copied("b"), c = copied("c");
  const std::vector<upkeep::Project*> projects = {&*project_, &b, &c};
  const std::vector<std::string> fields = {"ware", "note", "vessel"};
  for (std::size_t i = 0; i < projects.size(); ++i) {
    const store::SherdRow sherd = newSherd(*projects[i], context13, false);
    say(*projects[i], sherd, "number", "N3");
    say(*projects[i], sherd, fields[i], "of " + std::to_string(i));
    say(*projects[i], sherd, "weight_g", "7");
  }
  const auto once = [&](std::size_t into, std::size_t from) {
    Settled settled;
    MergeReport report = merged(*projects[into], *projects[from]);
    for (const Conflict& conflict : report.conflicts) {
      EXPECT_TRUE(conflict.offers(Take::One)) << conflict.id;
      settled[conflict.id] = take(Take::One);
    }
    if (!report.entered) report = merged(*projects[into], *projects[from], settled);
    ASSERT_TRUE(report.entered) << openIn(report).front();
    EXPECT_THAT(report.new_numbers, testing::IsEmpty());
  };
  for (int i = 0; i < 4; ++i) {
    const std::size_t into = random() % 3;
    once(into, (into + 1 + random() % 2) % 3);
  }
  const std::vector<std::pair<std::size_t, std::size_t>> all_pairs = {{0, 1}, {0, 2}, {1, 0},
                                                                      {2, 0}, {1, 2}, {2, 1}};
  for (const auto& [into, from] : all_pairs) once(into, from);
  for (const upkeep::Project* project : projects) {
    const sherds::Sherds held(project->catalogue());
    EXPECT_EQ(valueIn(held.rows(sherds::Filter{}, {})).size(), rows.size() + 1);
    const store::SherdRow sherd = valueIn(held.byNumber("N3"));
    ASSERT_TRUE(sherd);
    for (std::size_t i = 0; i < projects.size(); ++i)
      EXPECT_EQ(sherds::textOf(valueIn(held.get(sherd)), fields[i]), "of " + std::to_string(i));
    EXPECT_EQ(sherds::textOf(valueIn(held.get(sherd)), "weight_g"), "7");
    EXPECT_TRUE(project->catalogue().checkIntegrity());
  }
  for (const auto& [into, from] : all_pairs) {
    const std::string before = contentIn(*projects[into]);
    EXPECT_THAT(merged(*projects[into], *projects[from]).conflicts, testing::IsEmpty());
    EXPECT_EQ(contentIn(*projects[into]), before) << "merging once more changes nothing";
  }
}

INSTANTIATE_TEST_SUITE_P(AnyOrder, Orders, testing::Range(1u, 7u));

}  // namespace
}  // namespace ostraka::merge
