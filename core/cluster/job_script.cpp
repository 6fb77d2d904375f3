#include "cluster/job_script.h"

#include <algorithm>
#include <string_view>

#include "base/text.h"

namespace ostraka::cluster {
namespace {

bool isName(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
           c == '-' || c == '.' || c == ',';
  });
}

// The note is as long at the end as at the beginning and is written over it in place, so that it
// needs no room on a disk that is full. A job that Slurm ends writes none: Slurm says why.
// The program is signalled with all that it started, and waited for until it has ended by itself.
constexpr const char* kWork = R"(set -u -m
batch=${batches[$((SLURM_ARRAY_TASK_ID - 1))]}
state=cluster/state/$batch
report=results/$batch/report.json
why=none
child=
# What a link leads to may belong to others.
for folder in cluster cluster/state cluster/log; do
  [ ! -L "$folder" ] || { echo "$folder is a link; replace it with a folder." >&2; exit 73; }
done
note() { printf '%-199.199s\n' "$job $*"; }
rm -f "$state.new"
note began > "$state.new" && mv -f -T "$state.new" "$state" || exit 74
trap 'why=time; [ -z "$child" ] || kill -TERM -- -"$child"' USR1
trap 'why=killed; [ -z "$child" ] || kill -TERM -- -"$child"' TERM
rig=()
[ ! -f "batches/$batch/rig.json" ] || rig=(--rig "batches/$batch/rig.json")
{
  trap : TERM
  ostraka_here process "batches/$batch" --output "results/$batch" --quiet \
    --threads "${SLURM_CPUS_PER_TASK:-0}" --texture $texture ${rig[@]+"${rig[@]}"}
} &
child=$!
wait "$child"
status=$?
while kill -0 "$child" 2> /dev/null; do
  wait "$child"
  status=$?
done
[ "$why" != killed ] || exit 143
# 1 and 3: sherds are missing, or a person must decide; the results are whole. An older report is
# that of an earlier run.
whole=no
room=yes
case $status in
  0 | 1 | 3) [ ! -s "$report" ] || [ "$state" -nt "$report" ] || whole=yes ;;
esac
if [ $whole = no ]; then
  rm -f "results/$batch.room"
  head -c 8388608 /dev/zero > "results/$batch.room" 2> /dev/null || room=no
  rm -f "results/$batch.room"
fi
note ended "$status" $why $room $whole 1<> "$state"
[ $whole = no ] || exit 0
exit $((status > 0 ? status : 1))
)";

}  // namespace

Result<void> Ask::check() const {
  if (!isName(partition) || !isName(account))
    return Error::unusable(
        message("The name of a partition or an account consists of letters, digits, '-', '_' and "
                "'.'; look it up with 'sinfo' or ask the cluster's administrators."),
        isName(partition) ? account : partition);
  const bool one_line = std::none_of(program.begin(), program.end(),
                                     [](unsigned char c) { return c < 0x20 || c == 0x7F; });
  if (program.empty() || !one_line)
    return Error::unusable(
        message("The command that starts Ostraka on the cluster must be one line."), program);
  if (cores < 1 || memory_mb < 0 || minutes < 0)
    return Error::unusable(
        message("A job needs at least one core, and its memory and time must not be negative."));
  if (memory_mb > kMostMemory_mb || minutes > kMostMinutes)
    return Error::unusable(message("A job can request at most %1 MB of memory and %2 minutes.",
                                   kMostMemory_mb, kMostMinutes));
  return {};
}

std::string jobScript(const std::string& job, const std::vector<std::string>& batches,
                      const Ask& ask) {
  std::string script =
      "#!/bin/bash\n"
      "#SBATCH --job-name=" +
      job + "\n#SBATCH --array=1-" + std::to_string(batches.size()) +
      "\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=" + std::to_string(ask.cores) +
      "\n#SBATCH --mem=" + std::to_string(ask.memory_mb) +
      "M\n#SBATCH --time=" + std::to_string(ask.minutes) + "\n";
  if (!ask.partition.empty()) script += "#SBATCH --partition=" + ask.partition + "\n";
  if (!ask.account.empty()) script += "#SBATCH --account=" + ask.account + "\n";
  // A minute before the end `process` is stopped, so that it leaves a word.
  script +=
      "#SBATCH --requeue\n#SBATCH --signal=B:USR1@60\n#SBATCH --open-mode=append\n"
      "#SBATCH --output=cluster/log/%x.%a.txt\n"
      "# Made by 'ostraka cluster submit'. One batch a task; the same task run again goes on from "
      "the\n# last whole stage.\n"
      "job=" +
      job + "\ntexture=" + (ask.albedo ? "albedo" : "photo") + "\nbatches=(" +
      joined(batches, " ") + ")\nostraka_here() { " + ask.program + " \"$@\"; }\n";
  return script + kWork;
}

std::string logOf(const std::string& job, int task) {
  return "cluster/log/" + job + "." + std::to_string(task) + ".txt";
}

std::string scriptOf(const std::string& job) {
  return "cluster/" + job + ".sbatch";
}

}  // namespace ostraka::cluster
