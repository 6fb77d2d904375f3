#pragma once
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "base/progress.h"
#include "store/database.h"
#include "upkeep/project.h"
#include "upkeep/repair.h"

namespace ostraka::catalogue {

inline std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}
inline void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

/// Everything that the tables hold, and the texts of the search, as one text.
inline Result<std::string> contentOf(store::Database& database) {
  return database.asResult([&] {
    std::string text;
    std::vector<std::string> tables;
    store::Statement names = database.sql(
        "SELECT name FROM pragma_table_list WHERE schema = 'main' AND type IN ('table', "
        "'virtual') AND name NOT LIKE 'sqlite_%' ORDER BY name");
    while (names.next()) names >> tables.emplace_back();
    for (const std::string& table : tables) {
      std::vector<std::string> columns;
      store::Statement about = database.sql("SELECT name FROM pragma_table_info(?)", table);
      while (about.next()) about >> columns.emplace_back();
      std::string list;
      for (const std::string& column : columns)
        list += (list.empty() ? "" : ", ") + ("quote(\"" + column + "\")");
      text += table + "\n";
      store::Statement rows = database.sql("SELECT " + list + " FROM \"" + table + "\"");
      while (rows.next()) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
          std::string value;
          rows >> value;
          text += value + "|";
        }
        text += "\n";
      }
    }
    return text;
  });
}

inline Result<std::string> contentOf(const std::filesystem::path& project) {
  const Result<upkeep::Project> opened = upkeep::Project::open(project);
  if (!opened) return opened.error();
  if (const Result<void> whole = opened->catalogue().checkIntegrity(); !whole) return whole.error();
  return contentOf(opened->catalogue().database());
}

struct Flips {
  int found = 0, harmless = 0, accepted = 0, restored = 0, not_restored = 0;
  std::string unlike;  ///< which were accepted or not restored, and why
};

/// Turns one bit after the other in a project's closed catalogue, by a seed. repaired_of: of the
/// found ones each so-manieth is repaired, and must be what it was.
inline Flips flipBits(const std::filesystem::path& project, int flips, unsigned seed,
                      int repaired_of) {
  const std::filesystem::path file = project / "catalogue.sqlite";
  const std::string content = *contentOf(project);
  const std::string whole = bytesOf(file);
  std::mt19937_64 random(seed);
  Flips result;
  QuietProgress quiet;
  for (int i = 0; i < flips; ++i) {
    std::string bytes = whole;
    const std::size_t at = random() % bytes.size();
    const unsigned long bit = random() % 8;
    bytes[at] ^= static_cast<char>(1 << bit);
    writeBytes(file, bytes);
    const auto unlike = [&](const std::string& why) {
      result.unlike +=
          "byte " + std::to_string(at) + ", bit " + std::to_string(bit) + ": " + why + "\n";
    };
    const Result<std::string> now = contentOf(project);
    if (now) {
      ++(*now == content ? result.harmless : result.accepted);
      if (*now != content) unlike("accepted");
    } else if (++result.found % repaired_of == 0) {
      const Result<upkeep::RepairReport> repaired = upkeep::repairCatalogue(project, quiet, {});
      const Result<std::string> after = contentOf(project);
      const bool same = repaired && after && *after == content;
      ++(same ? result.restored : result.not_restored);
      if (!repaired)
        unlike(repaired.error().sentence().english());
      else if (!after)
        unlike(after.error().sentence().english());
      else if (!same)
        unlike("repaired to another content, " + std::to_string(repaired->pages_lost) +
               " pages lost");
      for (const auto& entry : std::filesystem::directory_iterator(project))
        if (entry.path().filename().string().starts_with("catalogue-damaged"))
          std::filesystem::remove(entry.path());
      std::filesystem::remove_all(project / "backups");
    }
    for (const char* part : {"-wal", "-shm"}) std::filesystem::remove(file.string() + part);
  }
  writeBytes(file, whole);
  return result;
}

}  // namespace ostraka::catalogue
