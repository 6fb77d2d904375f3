#pragma once
#include <stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "cluster_project.h"

namespace ostraka::cluster {

/// sbatch, squeue, sacct, df and ssh that do what files of the folder "fault" tell them.
class FakeCluster : public ClusterProject {
 protected:
  FakeCluster() {
    const std::string f = "f='" + fault().string() + "'\n";
    program("sbatch", f + "[ ! -f $f/refusal ] || { cat $f/refusal >&2; exit 1; }\n"
                          "for last; do :; done\n"
                          "job=$(sed -n 's/^#SBATCH --job-name=//p' \"$last\")\n"
                          "tasks=$(sed -n 's/^#SBATCH --array=1-//p' \"$last\")\n"
                          "for i in $(seq $tasks); do\n"
                          "  echo \"$job|$i|PENDING|Resources\" >> $f/queue\n"
                          "done\n"
                          "echo \"$PWD/$last\" >> $f/submitted\n"
                          "echo 'welcome to the cluster'; echo 4711\n"
                          "[ ! -f $f/broken ]\n");
    program("squeue", f + "[ ! -f $f/down ] || { echo 'cannot contact slurmctld' >&2; exit 1; }\n"
                          "cat $f/queue 2> /dev/null || true\n");
    program("sacct", f + "cat $f/accounts\n");
    program("df",
            f + "echo 'Filesystem 1024-blocks Used Available Capacity Mounted on'\n"
                "echo \"disk 999999999 1 $(cat $f/free 2> /dev/null || echo 999999999) 1% /\"\n");
    program("ssh", f + "[ ! -f $f/down ] || { echo 'connection refused' >&2; exit 255; }\n"
                       "while [ \"$1\" = -o ] || [ \"$1\" = -l ]; do shift 2; done\n"
                       "echo \"$1\" >> $f/logins\nshift\nexec sh -c \"$*\"\n");
    const char* path = ::getenv("PATH");
    before_ = path == nullptr ? "" : path;
    ::setenv("PATH", (bin().string() + ":" + before_).c_str(), 1);
  }
  ~FakeCluster() override { ::setenv("PATH", before_.c_str(), 1); }

  int submissions() const { return linesOf("submitted"); }
  int runs() const { return linesOf("runs"); }
  /// As a node does: every task that waits, in `folder`.
  void runTasks(const fs::path& folder, const std::string& state_after = "COMPLETED") const {
    std::ifstream queue(fault() / "queue");
    std::string after;
    for (std::string line; std::getline(queue, line);) {
      const std::string job = line.substr(0, line.find('|')),
                        task = line.substr(job.size() + 1,
                                           line.find('|', job.size() + 1) - job.size() - 1);
      if (line.find("|PENDING|") != std::string::npos) {
        const std::string command = "cd '" + folder.string() + "' && SLURM_ARRAY_TASK_ID=" + task +
                                    " bash cluster/" + job + ".sbatch >> cluster/log/" + job + "." +
                                    task + ".txt 2>&1";
        [[maybe_unused]] const int status = std::system(command.c_str());
        line = job + "|" + task + "|" + state_after + "|None";
      }
      after += line + "\n";
    }
    queue.close();
    put(fault() / "queue", after);
  }
  void runTasks() const { runTasks(project_->folder()); }

 private:
  int linesOf(const char* file) const {
    const std::string lines = textOf(fault() / file);
    return static_cast<int>(std::count(lines.begin(), lines.end(), '\n'));
  }
  std::string before_;
};

}  // namespace ostraka::cluster
