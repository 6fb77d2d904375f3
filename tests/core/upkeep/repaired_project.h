#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "store/database.h"
#include "store/page_checksums.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"
#include "upkeep/repair.h"

namespace ostraka::upkeep {

/// A project that is repaired once one of its tables is destroyed, which has only what the backup
/// and the history tell.
class RepairedProject : public catalogue::SmallProject {
 protected:
  std::filesystem::path folder() const { return folder_.path() / "project"; }
  std::filesystem::path file() const { return folder() / "catalogue.sqlite"; }
  // All of a small table lies on its first page. The words of the rows; the project is open again.
  std::vector<std::string> repairedWithout(const std::string& table) {
    const auto page = catalogue()
                          .database()
                          .sql("SELECT rootpage FROM sqlite_schema WHERE name = ?", table)
                          .one<std::int64_t>();
    project_.reset();
    std::string bytes = catalogue::bytesOf(file());
    const std::size_t at = static_cast<std::size_t>(page - 1) * store::kPageBytes;
    for (std::size_t i = 0; i < store::kPageBytes; ++i) bytes[at + i] = static_cast<char>(i * 7);
    catalogue::writeBytes(file(), bytes);
    QuietProgress quiet;
    const RepairReport report =
        catalogue::valueIn(repairCatalogue(folder(), quiet, {}, [this] { return now_ms += 1; }));
    EXPECT_EQ(report.pages_lost, 1);
    EXPECT_FALSE(report.all_from_backup);
    project_ = std::make_unique<Project>(*Project::open(folder()));
    EXPECT_TRUE(catalogue().checkIntegrity());
    std::vector<std::string> words;
    for (const RepairedRow& row : report.rows) words.push_back(row.words("backup").english());
    return words;
  }
  // As a table enters it, whose history names its place.
  store::SherdRow placed(const std::string& in_site, const std::string& in_trench,
                         const std::string& in_context, const std::string& number) {
    const store::SherdRow sherd = *sherds::Sherds(catalogue()).add({}, anna);
    const auto given = records::Confirmation::Given;
    const std::vector<records::FieldChange> changes = {{sherd, "site", in_site, given},
                                                       {sherd, "trench", in_trench, given},
                                                       {sherd, "context", in_context, given},
                                                       {sherd, "number", number, given}};
    EXPECT_TRUE(sherds::SherdChanges(catalogue()).apply(changes, anna));
    return sherd;
  }
  std::string numberOf(store::SherdRow row) { return valueOf(row, "number"); }
};

}  // namespace ostraka::upkeep
