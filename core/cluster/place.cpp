#include "cluster/place.h"

#include <algorithm>
#include <string_view>

#include "base/message.h"
#include "colmap/colmap_program.h"
#include "files/files.h"
#include "files/folder_lock.h"
#include "files/output_place.h"
#include "files/scratch_folder.h"

namespace ostraka::cluster {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOutput = std::size_t{64} << 20, kShownOutput = 400;
// It never asks: what runs beside a window or in a script has nobody who answers.
constexpr const char* kNeverAsk = "BatchMode=yes";
constexpr const char* kSoon = "ConnectTimeout=30";
// Prints which folder is a link, else makes the folders and prints the owner of the whole, which is
// the first who asks. The text of a link is written whole or not at all, also on a full disk, and
// never over another.
constexpr const char* kClaim =
    "for f in cluster cluster/state cluster/log; do [ ! -L $f ] || { echo \"link: $f.\"; exit; }; "
    "done; mkdir -p batches results cluster/state cluster/log || exit; "
    "[ -e catalogue.sqlite ] || [ -L cluster/owner ] || ln -s \"$1\" cluster/owner || exit; "
    "echo \"owner: $(readlink cluster/owner)\"";

// Letters, digits and what neither a shell, ssh, rsync nor Slurm reads as something else.
bool isPlain(std::string_view text, std::string_view also) {
  return !text.empty() && text.front() != '-' && std::ranges::all_of(text, [&](unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           also.find(static_cast<char>(c)) != std::string_view::npos;
  });
}

// Slurm replaces %x in the names of files, and reads \ as an escape.
bool isReadAsItStands(std::string_view path) {
  return std::ranges::none_of(
      path, [](unsigned char c) { return c < 0x20 || c == 0x7F || c == '%' || c == '\\'; });
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

// The end of it, as one line.
std::string shortened(std::string output) {
  while (!output.empty() && output.back() == '\n') output.pop_back();
  if (output.size() > kShownOutput) output = "..." + output.substr(output.size() - kShownOutput);
  std::replace(output.begin(), output.end(), '\n', ' ');
  return output;
}

Result<void> requireProgram(const std::string& program, Message missing) {
  if (colmap::findProgram(program)) return {};
  return Error::missing(std::move(missing));
}

}  // namespace

Result<Place> Place::of(const fs::path& project, const std::string& host) {
  std::error_code failed;
  const fs::path here = fs::canonical(project, failed);
  if (failed)
    return Error::unusable(
        message("This folder cannot be opened (%1); check its name and permissions.",
                failed.message()),
        project.string());
  if (host.empty()) {
    if (!isReadAsItStands(here.string()))
      return Error::unusable(
          message("The path of this project contains a character that has a special meaning for "
                  "Slurm (%, a backslash or a control character); rename the folder."),
          here.string());
    if (Result<void> there = requireProgram(
            "sbatch", message("The program %1 is not on this computer's PATH; run this command "
                              "on a login node of the cluster, or name one with --host "
                              "USER@LOGIN:/FOLDER.",
                              "sbatch"));
        !there)
      return there.error();
    return Place(here, {}, {});
  }
  const std::size_t colon = host.find(':');
  const std::string login = host.substr(0, colon),
                    folder = colon == std::string::npos ? "" : host.substr(colon + 1);
  if (!isPlain(login, "@._-") || !isPlain(folder, "/._-+=@,") || folder.front() != '/')
    return Error::unusable(
        message("Not a folder on a cluster; write USER@LOGIN:/FOLDER, with the folder's full path "
                "and without spaces."),
        host);
  for (const char* program : {"ssh", "rsync"})
    if (Result<void> there = requireProgram(
            program,
            message(
                "The program %1 is not on this computer's PATH, but --host needs it; install it.",
                program));
        !there)
      return there.error();
  return Place(here, login, folder);
}

std::string Place::name() const {
  return isRemote() ? host_ + ":" + folder_ : project_.string();
}

Result<std::string> Place::runHere(const std::string& program,
                                   const std::vector<std::string>& arguments,
                                   const std::string& named, const std::stop_token& stop) const {
  const Result<ScratchFolder> scratch = ScratchFolder::make("ostraka-cluster");
  if (!scratch) return scratch.error();
  const fs::path log = scratch->path() / "output.txt";
  const fs::path path = colmap::findProgram(program).value_or(program);
  const Result<void> done = colmap::runProgram(path, arguments, log, stop);
  Result<std::string> output = readFile(log, kMostOutput);
  if (done) return output;
  if (done.error().code == ErrorCode::Missing)
    return Error::missing(
        message("The program %1 cannot be started there; ask the cluster's administrators "
                "how Slurm is reached.",
                named),
        name());
  if (done.error().code != ErrorCode::Failed) return done.error();
  return Error::failed(
      message("%1 failed (%2). Nothing is lost; once the cause is removed, run the same "
              "command again.",
              named, shortened(output ? *output : std::string())),
      name());
}

Result<std::string> Place::run(const std::vector<std::string>& words,
                               const std::stop_token& stop) const {
  if (!isRemote()) {
    std::vector<std::string> arguments{"-c", "cd \"$1\" && shift && exec \"$@\"", "sh",
                                       project_.string()};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return runHere("sh", arguments, words.front(), stop);
  }
  std::string command = "cd " + quoted(folder_) + " && exec";
  for (const std::string& word : words) command += " " + quoted(word);
  return runHere("ssh", {"-o", kNeverAsk, "-o", kSoon, host_, command}, words.front(), stop);
}

Result<void> Place::copy(std::vector<std::string> arguments, const std::stop_token& stop) const {
  const std::vector<std::string> always{"--recursive",
                                        "--times",
                                        "--checksum",
                                        std::string("--include=") + kLockFile + "/",  // a folder
                                        std::string("--exclude=") + kLockFile,
                                        "--protect-args",
                                        "--rsh",
                                        std::string("ssh -o ") + kNeverAsk + " -o " + kSoon};
  arguments.insert(arguments.begin(), always.begin(), always.end());
  const Result<std::string> done = runHere("rsync", arguments, "rsync", stop);
  return done ? Result<void>() : done.error();
}

Result<void> Place::prepare(const std::string& owner, const std::stop_token& stop) const {
  for (const char* folder : {"batches", "results", "cluster/state", "cluster/log"})
    if (const Result<void> made = makeFolder(project_ / folder); !made) return made;
  if (!isRemote()) return {};
  const Result<std::string> made = runHere(
      "ssh", {"-o", kNeverAsk, "-o", kSoon, host_, "mkdir -p " + quoted(folder_)}, "mkdir", stop);
  if (!made) return made.error();
  const Result<std::string> told = run({"sh", "-c", kClaim, "sh", owner}, stop);
  if (!told) return told.error();
  if (told->find("owner: " + owner) != std::string::npos) return {};
  for (const char* folder : {"cluster", "cluster/state", "cluster/log"})
    if (told->find("link: " + std::string(folder) + ".") != std::string::npos)
      return Error::unusable(
          message("A link or a file has taken the place of a folder, or a link that of a file; "
                  "replace it with the folder or the file itself."),
          host_ + ":" + (fs::path(folder_) / folder).string());
  return Error::unusable(
      message("This folder on the cluster belongs to another project, to another copy of this one, "
              "or to this one before it was moved; nothing was sent. Name another folder with "
              "--host. If nothing else uses this one, delete 'cluster/owner' in it."),
      name());
}

Result<void> Place::send(const std::vector<std::string>& paths, const std::stop_token& stop) const {
  if (!isRemote()) return {};
  std::vector<std::string> arguments{"--delete", "--relative"};
  const std::size_t options = arguments.size();
  std::error_code failed;
  for (const std::string& path : paths)
    if (fs::exists(project_ / path, failed))
      arguments.push_back(project_.string() + "/./" + path);  // relative from there on
  if (arguments.size() == options) return {};
  arguments.push_back(host_ + ":" + folder_ + "/");
  return copy(std::move(arguments), stop);
}

Result<void> Place::fetch(const std::string& path, const std::string& to, int most_mb,
                          const std::vector<std::string>& but, const std::stop_token& stop) const {
  if (!isRemote()) return {};
  const fs::path here = project_ / to;
  if (const Result<void> own = checkNoLinkInProject(here); !own)
    return Error{ErrorCode::CannotWrite, own.error().what, own.error().where};
  if (const Result<void> made = makeFolder(here); !made) return made;
  std::vector<std::string> arguments{"--delete", "--no-links"};
  if (most_mb > 0) arguments.push_back("--max-size=" + std::to_string(most_mb) + "m");
  for (const std::string& name : but) arguments.push_back("--exclude=/" + name);
  arguments.push_back(host_ + ":" + (fs::path(folder_) / path).string() + "/");
  arguments.push_back(here.string() + "/");
  return copy(std::move(arguments), stop);
}

}  // namespace ostraka::cluster
