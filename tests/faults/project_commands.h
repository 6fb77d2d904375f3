#pragma once
#include "exported_project.h"
#include "flipped_bits.h"
#include "program.h"
#include "sherds/sherds.h"
#include "upkeep/backups.h"

/// Commands of the built program on a small project with three sherds.
namespace ostraka::test {

class ProjectCommands : public exchange::ExportedProject {
 protected:
  std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  std::filesystem::path errors() const { return at("errors"); }
  Ended run(const std::vector<std::string>& command) { return runProgram(command, errors()); }
  void copy(const std::string& from, const std::string& to) {
    std::filesystem::remove_all(at(to));
    std::filesystem::copy(at(from), at(to), std::filesystem::copy_options::recursive);
  }
  static void expectDone(const Ended& ended) { EXPECT_EQ(ended.status, 0) << ended.errors; }
  void expectWhole(const std::string& project, std::size_t sherds) {
    const Result<upkeep::Project> open = upkeep::Project::open(at(project));
    ASSERT_TRUE(open) << open.error().sentence();
    const Result<void> whole = open->catalogue().checkIntegrity();
    EXPECT_TRUE(whole) << whole.error().sentence();
    EXPECT_EQ(sherds::Sherds(open->catalogue()).rows({}, {})->size(), sherds);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(at(project)))
      EXPECT_EQ(entry.path().filename().string().find(".partial"), std::string::npos)
          << entry.path();
  }
  void expectReadable(const std::string& project) {
    const Result<upkeep::Project> open = upkeep::Project::open(at(project));
    ASSERT_TRUE(open) << open.error().sentence();
    const Result<void> whole = open->catalogue().checkIntegrity();
    EXPECT_TRUE(whole) << whole.error().sentence();
  }
  void tableOf(int lines) {
    std::string table = "number,site,trench,context,ware\r\n";
    for (int i = 0; i < lines; ++i)
      table += "ARM1-T3-0012-" + std::to_string(1000 + i) + ",ARM1,T3,0012,grey\r\n";
    put(at("table.csv"), table);
  }
  void computeAgain() {
    const std::filesystem::path model = project_->resultsFolder("B0001") / "sherds/01/model.ply";
    std::string bytes = *readFile(model);
    bytes.insert(bytes.find("end_header"), "comment computed again\n");
    put(model, bytes);
    catalogue::ResultFolder::noteModel(project_->resultsFolder("B0001"), "01");
  }
  /// A copy of the project, "damaged", some pages of whose catalogue only the backup still knows;
  /// returns what the catalogue held.
  std::string damagedCopy(std::size_t first_page, std::size_t pages) {
    EXPECT_TRUE(project_->backUp());
    EXPECT_TRUE(set(rows[0], "ware", "red slipped"));
    EXPECT_TRUE(set(rows[1], "note", "newer than the backup"));
    project_.reset();
    std::string content = *catalogue::contentOf(at("project"));
    std::string bytes = catalogue::bytesOf(at("project/catalogue.sqlite"));
    for (std::size_t page = first_page; page < first_page + pages; ++page)
      for (std::size_t k = 0; k < 64; ++k) bytes[page * 4096 + 200 + k] ^= 0x55;
    copy("project", "damaged");
    catalogue::writeBytes(at("damaged/catalogue.sqlite"), bytes);
    return content;
  }
};

}  // namespace ostraka::test
