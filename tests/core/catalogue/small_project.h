#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "catalogue/batches.h"
#include "catalogue/places.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/filter.h"
#include "sherds/numbers.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "tests/core/files/temporary_folder.h"
#include "upkeep/project.h"

namespace ostraka::catalogue {

using ostraka::TemporaryFolder;

/// The value of a temporary, for loops.
template <class T>
T valueIn(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().sentence().english());
  return std::move(*result);
}

/// Site ARM1, trench T3, contexts 0012 and 0013, bags 4 and 5 in 0012, bag 1 in 0013, person AP.
class SmallProject : public ::testing::Test {
 protected:
  SmallProject() {
    records::ProjectRecord record;
    record.code = "ARM";
    record.title = "Trial";
    Result<upkeep::Project> made =
        upkeep::Project::create(folder_.path() / "project", record, [this] {
          return now_ms += 1;  // every provenance has a time of its own
        });
    if (!made) throw std::runtime_error(made.error().sentence().english());
    project_ = std::make_unique<upkeep::Project>(std::move(*made));
    anna = {*People(catalogue()).save(records::PersonRecord{{}, {}, "Anna P.", "AP", {}}, {}),
            "test", ""};
    records::SiteRecord s;
    s.code = "ARM1";
    s.name = "Hill";
    site = *Places(catalogue()).save(s, anna);
    records::TrenchRecord t;
    t.site = site;
    t.code = "T3";
    trench = *Places(catalogue()).save(t, anna);
    context12 = context("0012");
    context13 = context("0013");
    bag4 = bag(context12, "4");
    bag5 = bag(context12, "5");
    bag1 = bag(context13, "1");
  }

  Catalogue& catalogue() { return project_->catalogue(); }
  store::ContextRow context(const std::string& number) {
    records::ContextRecord c;
    c.site = site;
    c.trench = trench;
    c.number = number;
    return *Places(catalogue()).save(c, anna);
  }
  store::BagRow bag(store::ContextRow in, const std::string& number) {
    records::BagRecord b;
    b.context = in;
    b.number = number;
    return *Places(catalogue()).save(b, anna);
  }
  store::SherdRow draft(store::ContextRow in, store::BagRow of = {}) {
    records::SherdRecord s;
    s.context = in;
    s.bag = of;
    return *sherds::Sherds(catalogue()).add(s, anna);
  }
  store::SherdRow numbered(store::ContextRow in) {
    const store::SherdRow row = draft(in);
    EXPECT_TRUE(sherds::Numbers(catalogue()).assign(std::span(&row, 1), anna));
    return row;
  }
  store::BatchRow newBatch(std::vector<store::BagRow> bags) {
    records::BatchRecord b;
    b.bags = std::move(bags);
    b.counted = 3;
    return *Batches(catalogue()).add(b, anna);
  }
  store::ScanRow scan(store::BatchRow batch, batch::Side side, int index) {
    records::ScanRecord s;
    s.batch = batch;
    s.side = side;
    s.index = index;
    s.name = (side == batch::Side::Front ? "f00" : "b00") + std::to_string(index);
    s.path = "results/B0001/scans/" + s.name + ".ply";
    return *Batches(catalogue()).save(s, anna);
  }
  /// As a person does who answers yes to what is asked.
  Result<std::vector<records::FieldChange>> set(store::SherdRow sherd, const std::string& field,
                                                const std::string& value) {
    const records::FieldChange change{sherd, field, value, records::Confirmation::Given};
    return sherds::SherdChanges(catalogue()).apply(std::span(&change, 1), anna);
  }
  std::string valueOf(store::SherdRow sherd, const std::string& field) {
    return sherds::textOf(*sherds::Sherds(catalogue()).get(sherd), field);
  }
  /// Numbers of the sherds that the filter line finds, in order.
  std::vector<std::string> found(const std::string& line, const records::SherdOrder& order = {}) {
    const Result<sherds::Filter> filter = sherds::parseFilter(line);
    EXPECT_TRUE(filter) << (filter ? "" : filter.error().sentence());
    if (!filter) return {"?"};
    const Result<std::vector<store::SherdRow>> rows =
        sherds::Sherds(catalogue()).rows(*filter, order);
    EXPECT_TRUE(rows) << (rows ? "" : rows.error().sentence());
    if (!rows) return {"?"};
    std::vector<std::string> numbers;
    for (const records::SherdRecord& sherd : valueIn(sherds::Sherds(catalogue()).of(*rows)))
      numbers.push_back(sherd.number);
    return numbers;
  }

  std::int64_t now_ms = 1'790'000'000'000;  // 21 September 2026
  TemporaryFolder folder_;
  std::unique_ptr<upkeep::Project> project_;
  records::Provenance anna;
  store::SiteRow site;
  store::TrenchRow trench;
  store::ContextRow context12, context13;
  store::BagRow bag4, bag5, bag1;
};

}  // namespace ostraka::catalogue
