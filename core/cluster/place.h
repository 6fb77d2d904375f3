#pragma once
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.h"

namespace ostraka::cluster {

/// Where the cluster's programs run and its jobs find batches/, results/ and cluster/: the
/// project's own folder, which the cluster sees, or a folder on another computer, reached by ssh as
/// the person has it set up. No password is asked for or kept.
class Place {
 public:
  /// host: empty, or user@login:/folder. Errors: UnusableInput for a host or folder with characters
  /// that have a special meaning for a shell or Slurm; Missing (sbatch; ssh and rsync).
  static Result<Place> of(const std::filesystem::path& project, const std::string& host);

  bool isRemote() const { return !host_.empty(); }
  /// user@login:/folder, or the project's folder.
  std::string name() const;

  /// Runs a program in the folder; returns both of its outputs. Errors: Missing (not on that
  /// computer's PATH), Failed with its output, Cancelled.
  Result<std::string> run(const std::vector<std::string>& words, const std::stop_token& stop) const;

  /// Creates the folders that jobs need if they are missing. A folder on another computer belongs
  /// to the first owner who prepares it (FOLDER/cluster/owner): what send() puts there replaces
  /// what lies there. Errors: those of run; UnusableInput for a folder that is another's, or a
  /// project, and for a link in the place of one that jobs write to.
  Result<void> prepare(const std::string& owner, const std::stop_token& stop) const;
  /// Copies files and folders of the project, such as "batches/B0031", to the other computer; files
  /// with the same checksum are skipped, and files no longer in such a folder are removed there.
  /// Does nothing in the project's own folder, or for what does not exist. Errors: Failed,
  /// Cancelled.
  Result<void> send(const std::vector<std::string>& paths, const std::stop_token& stop) const;
  /// The other way, into the folder `to` of the project: regular files only, no larger than most_mb
  /// (0: any size), and none of those names at the top. Error: CannotWrite for a link on the way
  /// to `to`, of which rsync would delete what the cluster has not.
  Result<void> fetch(const std::string& path, const std::string& to, int most_mb,
                     const std::vector<std::string>& but, const std::stop_token& stop) const;

 private:
  Place(std::filesystem::path project, std::string host, std::string folder)
      : project_(std::move(project)), host_(std::move(host)), folder_(std::move(folder)) {}
  Result<std::string> runHere(const std::string& program, const std::vector<std::string>& arguments,
                              const std::string& named, const std::stop_token& stop) const;
  Result<void> copy(std::vector<std::string> arguments, const std::stop_token& stop) const;
  std::filesystem::path project_;
  std::string host_, folder_;
};

}  // namespace ostraka::cluster
