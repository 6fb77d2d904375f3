#include "cluster/queue_text.h"

#include <algorithm>
#include <random>

#include "base/text.h"

namespace ostraka::cluster {
namespace {

constexpr std::string_view kJobPrefix = "ostraka-";
constexpr std::size_t kJobDigits = 12;
constexpr std::size_t kLongestReason = 60;

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> wordsIn(std::string_view line) {
  std::vector<std::string_view> words;
  for (const std::string_view word : split(line, ' '))
    if (!word.empty()) words.push_back(word);
  return words;
}

// All of it, not negative.
std::optional<int> number(std::string_view text) {
  const auto value = wholeText<int>(text);
  return value && *value >= 0 ? value : std::nullopt;
}

bool isWord(std::string_view text) {
  return text.size() <= kLongestReason &&
         std::ranges::all_of(text, [](unsigned char c) { return c > 0x20 && c < 0x7F; });
}

// A state that is not known here is one of a job that Slurm still holds.
QueueState stateOf(std::string_view word) {
  static const std::map<std::string_view, QueueState> kStates = {
      {"PENDING", QueueState::Waiting},      {"CONFIGURING", QueueState::Waiting},
      {"REQUEUED", QueueState::Waiting},     {"REQUEUE_FED", QueueState::Waiting},
      {"REQUEUE_HOLD", QueueState::Waiting}, {"RESV_DEL_HOLD", QueueState::Waiting},
      {"SPECIAL_EXIT", QueueState::Waiting}, {"COMPLETED", QueueState::Ended},
      {"FAILED", QueueState::Ended},         {"TIMEOUT", QueueState::TimeLimit},
      {"DEADLINE", QueueState::TimeLimit},   {"OUT_OF_MEMORY", QueueState::NoMemory},
      {"NODE_FAIL", QueueState::NodeFailed}, {"BOOT_FAIL", QueueState::NodeFailed},
      {"CANCELLED", QueueState::Cancelled},  {"PREEMPTED", QueueState::Cancelled},
      {"REVOKED", QueueState::Cancelled}};
  const auto found = kStates.find(word);
  return found == kStates.end() ? QueueState::Running : found->second;
}

}  // namespace

bool isJobName(std::string_view text) {
  if (!text.starts_with(kJobPrefix) || text.size() != kJobPrefix.size() + kJobDigits) return false;
  text.remove_prefix(kJobPrefix.size());
  return text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string newJobName() {
  std::random_device device;
  std::string name(kJobPrefix);
  for (std::size_t i = 0; i < kJobDigits; ++i) name += "0123456789abcdef"[device() & 15];
  return name;
}

std::vector<std::string> queueQuestion(const std::vector<std::string>& jobs) {
  return {"squeue",
          "--noheader",
          "--array",
          "--states=all",
          "--name=" + joined(jobs, ","),
          "--format=%j|%K|%T|%r"};
}

void readQueue(std::string_view text, Queue& queue) {
  for (const std::string_view line : split(text, '\n')) {
    const std::vector<std::string_view> fields = split(line, '|');
    if (fields.size() != 4 || !isJobName(fields[0]) || !isWord(fields[2])) continue;
    const std::optional<int> task = number(fields[1]);
    if (!task) continue;
    const std::string reason(isWord(fields[3]) && fields[3] != "None" ? fields[3] : "");
    queue[{std::string(fields[0]), *task}] = {stateOf(fields[2]), reason};
  }
}

std::vector<std::string> accountingQuestion(const std::vector<std::string>& jobs) {
  return {"sacct",
          "--noheader",
          "--parsable2",
          "--allocations",
          "--starttime=now-60days",
          "--name=" + joined(jobs, ","),
          "--format=JobName,JobID,State"};
}

void readAccounting(std::string_view text, Queue& queue) {
  for (const std::string_view line : split(text, '\n')) {
    const std::vector<std::string_view> fields = split(line, '|');
    if (fields.size() != 3 || !isJobName(fields[0])) continue;
    const std::size_t under = fields[1].find('_');  // 123_4
    if (under == std::string_view::npos) continue;
    const std::optional<int> task = number(fields[1].substr(under + 1));
    const std::vector<std::string_view> state = wordsIn(fields[2]);  // "CANCELLED by 1000"
    if (!task || state.empty()) continue;
    queue.try_emplace({std::string(fields[0]), *task}, QueueTask{stateOf(state[0]), {}});
  }
}

std::optional<double> readFreeSpace_mb(std::string_view text) {
  // Device, 1024-blocks, used, available, share, place; the last such line.
  std::optional<double> free_mb;
  for (const std::string_view line : split(text, '\n')) {
    const std::vector<std::string_view> words = wordsIn(line);
    if (words.size() < 6 || !words[4].ends_with('%')) continue;
    const auto blocks = wholeText<double>(words[3]);
    if (blocks && *blocks >= 0) free_mb = *blocks * 1024 / 1e6;
  }
  return free_mb;
}

std::optional<std::string> readJobId(std::string_view text) {
  std::optional<std::string> id;
  for (const std::string_view line : split(text, '\n')) {
    const std::string_view first = split(line, ';')[0];  // 123;cluster
    if (number(first)) id = std::string(first);
  }
  return id;
}

std::optional<StateNote> readStateNote(std::string_view text) {
  const std::vector<std::string_view> words = wordsIn(split(text, '\n')[0]);
  if (words.size() < 2 || !isJobName(words[0])) return std::nullopt;
  StateNote note;
  note.job = words[0];
  if (words.size() == 2 && words[1] == "began") return note;
  if (words.size() != 6 || words[1] != "ended") return std::nullopt;
  const std::optional<int> status = number(words[2]);
  if (!status) return std::nullopt;
  note.ended = true;
  note.exit_status = *status;
  note.time_up = words[3] == "time";
  note.room = words[4] == "yes";
  note.whole = words[5] == "yes";
  return note;
}

}  // namespace ostraka::cluster
