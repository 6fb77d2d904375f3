#include "cluster/access.h"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "files/json.h"

namespace ostraka::cluster {
namespace {

namespace fs = std::filesystem;

// Beside the window's settings; empty where this computer has no such folder, or the project no id.
fs::path memoryOf(const std::string& project_id) {
  if (project_id.empty()) return {};
  for (const auto& [variable, below] :
       {std::pair("XDG_CONFIG_HOME", "ostraka"), std::pair("HOME", ".config/ostraka")})
    if (const char* folder = std::getenv(variable);
        folder != nullptr && fs::path(folder).is_absolute())
      return fs::path(folder) / below / "clusters" / (sha256(project_id) + ".json");
  return {};
}

struct Memory {
  std::string host;
  std::string computer;  // random: tells this computer's copies of the project from all others
};

Result<Memory> readMemory(const fs::path& memory) {
  std::error_code failed;
  if (memory.empty() || !fs::exists(memory, failed)) return Memory();
  const Result<nlohmann::json> value = readJson(memory);
  if (!value) return value.error();
  if (!value->is_object() || !value->contains("host") || !value->at("host").is_string())
    return Error::unusable(message("Not a file in which Ostraka remembers the host of a cluster; "
                                   "delete it, then name the host with --host."),
                           memory.string());
  const auto computer = value->find("computer");
  return Memory{value->at("host").get<std::string>(),
                computer != value->end() && computer->is_string() ? computer->get<std::string>()
                                                                  : std::string()};
}

Result<void> writeMemory(const fs::path& file, const std::string& project_id,
                         const Memory& memory) {
  if (file.empty()) return {};
  if (const Result<void> made = makeFolder(file.parent_path()); !made) return made;
  return writeJson(file,
                   {{"project", project_id}, {"host", memory.host}, {"computer", memory.computer}});
}

Result<std::string> hostFor(const std::string& named, const std::string& remembered,
                            const Tasks& tasks) {
  if (!tasks.anyUncollected()) return named.empty() ? remembered : named;
  if (!named.empty() && named != tasks.host)
    return Error::unusable(
        message("Batches of this project are on another cluster or in another folder; collect them "
                "before you submit to this one."),
        named);
  if (named.empty() && !tasks.host.empty() && tasks.host != remembered)
    return Error::unusable(
        message("Batches of this project were submitted to this host, which was not named on this "
                "computer; nothing was sent to it. If you trust it, name it once with --host."),
        tasks.host);
  return tasks.host;
}

}  // namespace

Result<Place> reach(const catalogue::Catalogue& catalogue, const fs::path& project,
                    const Access& access, Tasks& tasks) {
  const Result<records::ProjectRecord> record = catalogue::Settings(catalogue).project();
  if (!record) return record.error();
  const fs::path memory = memoryOf(record->id);
  const Result<Memory> remembered = readMemory(memory);
  if (!remembered) return remembered.error();
  const Result<std::string> host = hostFor(access.host, remembered->host, tasks);
  if (!host) return host.error();
  Result<Place> place = Place::of(project, *host);
  if (!place) return place;
  tasks.host = *host;
  if (!access.host.empty() && access.host != remembered->host)
    if (const Result<void> written =
            writeMemory(memory, record->id, {access.host, remembered->computer});
        !written)
      return written.error();
  if (place->isRemote() && access.contacting) access.contacting(place->name());
  return place;
}

Result<std::string> ownerOf(const catalogue::Catalogue& catalogue, const fs::path& project) {
  const Result<records::ProjectRecord> record = catalogue::Settings(catalogue).project();
  if (!record) return record.error();
  const fs::path file = memoryOf(record->id);
  Result<Memory> memory = readMemory(file);
  if (!memory) return memory.error();
  if (memory->computer.empty()) {
    memory->computer = newId(catalogue.now());
    if (const Result<void> written = writeMemory(file, record->id, *memory); !written)
      return written.error();
  }
  std::error_code ignored;
  return sha256(record->id + "\n" + memory->computer + "\n" +
                fs::weakly_canonical(project, ignored).string());
}

}  // namespace ostraka::cluster
