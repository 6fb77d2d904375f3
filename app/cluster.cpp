#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "cluster/collect.h"
#include "cluster/submit.h"
#include "command.h"
#include "options.h"
#include "shown.h"
#include "upkeep/project.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using cluster::TaskState;
using cluster::TaskStatus;
using upkeep::Project;

struct ClusterOptions {
  fs::path project;
  double memory_gb = 0;
  std::string host;
  cluster::SubmitOptions submit;
};

const char* wordOf(TaskState state) {
  switch (state) {
    case TaskState::Waiting:
      return "waiting";
    case TaskState::Running:
      return "running";
    case TaskState::Done:
      return "done";
    case TaskState::Failed:
      return "failed";
    case TaskState::Collected:
      return "collected";
  }
  return "";
}

const char* wordOf(cluster::Cause cause) {
  switch (cause) {
    case cluster::Cause::None:
      return "";
    case cluster::Cause::Memory:
      return "memory";
    case cluster::Cause::Time:
      return "time";
    case cluster::Cause::Node:
      return "node";
    case cluster::Cause::Disk:
      return "disk";
    case cluster::Cause::Program:
      return "program";
    case cluster::Cause::Lost:
      return "lost";
  }
  return "";
}

nlohmann::ordered_json jsonOf(const std::vector<TaskStatus>& all) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const TaskStatus& one : all)
    list.push_back({{"batch", one.task.batch},
                    {"state", wordOf(one.state)},
                    {"cause", wordOf(one.cause)},
                    {"job", one.task.job},
                    {"task", one.task.number},
                    {"words", one.words.english()}});
  return list;
}

void printLines(const std::vector<TaskStatus>& all) {
  for (const TaskStatus& one : all)
    show(stdout, "%-8s %-9s %s\n", one.task.batch.c_str(), wordOf(one.state),
         one.words.english().c_str());
}

void printWarnings(const std::vector<Message>& warnings) {
  for (const Message& warning : warnings) show(stderr, "ostraka: %s\n", warning.english().c_str());
}

int count(const std::vector<TaskStatus>& all, TaskState state) {
  int found = 0;
  for (const TaskStatus& one : all) found += one.state == state ? 1 : 0;
  return found;
}

cluster::Access accessOf(const ClusterOptions& options, Session& session) {
  return {options.host, [&session](const std::string& host) {
            session.finishProgress();
            show(stderr, "Contacting %s.\n", host.c_str());
          }};
}

int runSubmit(const ClusterOptions& options, Session& session) {
  Result<Project> project = Project::open(options.project, {}, {session.stop, &session.progress});
  if (!project) return fail(session, project.error());
  cluster::SubmitOptions how = options.submit;
  how.access = accessOf(options, session);
  how.ask.memory_mb = static_cast<int>(options.memory_gb * 1000);
  session.progress.begin("submit", 1.0);
  const auto done = cluster::submit(*project, how, session.progress, session.stop);
  if (!done) return fail(session, done.error(), WhenStopped::GoesOn);
  session.finishProgress();
  printWarnings(done->warnings);
  std::string words = "Submitted batches: " + std::to_string(done->batches.size()) +
                      "; on the cluster before: " + std::to_string(done->already) + ".";
  if (!done->batches.empty())
    words += formatted(" Requested for each: %.1f GB of memory, %d minutes. Slurm array: ",
                       done->memory_mb / 1000.0, done->minutes) +
             joined(done->arrays, ", ") + ".";
  return finish(session, done->warnings.empty() ? Whole : NotWhole,
                {{"batches", done->batches},
                 {"arrays", done->arrays},
                 {"already", done->already},
                 {"memory_mb", done->memory_mb},
                 {"minutes", done->minutes},
                 {"warnings", done->warnings}},
                words);
}

int runStatus(const ClusterOptions& options, Session& session) {
  const auto all = cluster::status(options.project, accessOf(options, session), session.stop);
  if (!all) return fail(session, all.error());
  const int failed = count(*all, TaskState::Failed);
  return finish(session, failed == 0 ? Whole : NotWhole,
                {{"waiting", count(*all, TaskState::Waiting)},
                 {"running", count(*all, TaskState::Running)},
                 {"done", count(*all, TaskState::Done)},
                 {"failed", failed},
                 {"collected", count(*all, TaskState::Collected)},
                 {"batches", jsonOf(*all)}},
                [&] {
                  printLines(*all);
                  show(stdout, "waiting %d, running %d, done %d, failed %d, collected %d\n",
                       count(*all, TaskState::Waiting), count(*all, TaskState::Running),
                       count(*all, TaskState::Done), failed, count(*all, TaskState::Collected));
                });
}

int runCollect(const ClusterOptions& options, Session& session) {
  Result<Project> project = Project::open(options.project, {}, {session.stop, &session.progress});
  if (!project) return fail(session, project.error());
  session.progress.begin("collect", 1.0);
  const auto done =
      cluster::collect(*project, accessOf(options, session), session.progress, session.stop);
  if (!done) return fail(session, done.error(), WhenStopped::GoesOn);
  session.finishProgress();
  printWarnings(done->warnings);
  const bool whole = done->warnings.empty() && count(done->left, TaskState::Failed) == 0;
  return finish(session,
                !whole          ? NotWhole
                : done->ask > 0 ? PersonMustDecide
                                : Whole,
                {{"batches", done->batches},
                 {"sherds", done->sherds},
                 {"open", done->ask},
                 {"left", jsonOf(done->left)},
                 {"warnings", done->warnings}},
                [&] {
                  printLines(done->left);
                  show(stdout,
                       "Entered batches: %zu, with %d sherds; to review: %d. Not entered: %zu.\n",
                       done->batches.size(), done->sherds, done->ask, done->left.size());
                });
}

}  // namespace

void addCluster(CLI::App& root, Command& chosen) {
  CLI::App* command = root.add_subcommand(
      "cluster", "Process the batches of a project on a cluster with Slurm, and enter the results");
  command->require_subcommand(1);
  command->footer(
      "Batches in the project's queue are submitted once, however often 'submit' runs; one that\n"
      "failed is submitted again and resumes after its last complete stage. Nothing runs in the\n"
      "background: 'status' asks Slurm, 'collect' enters complete results.");
  auto options = std::make_shared<ClusterOptions>();
  const auto add = [&](const char* name, const char* words,
                       int (*run)(const ClusterOptions&, Session&)) {
    CLI::App* one = command->add_subcommand(name, words);
    addProject(*one, options->project);
    one->add_option("--host", options->host,
                    "USER@LOGIN:/FOLDER to which rsync copies the batches, remembered for this "
                    "project on this computer; else the cluster must see the project's folder");
    workOf(*one, chosen, run, options);
    return one;
  };
  CLI::App* submit = add("submit", "Submit the waiting batches", runSubmit);
  submit->add_option("--cores", options->submit.ask.cores, "Processor cores for each batch")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  submit
      ->add_option("--memory", options->memory_gb,
                   "GB of memory for each batch; else by what 'process' states of it")
      ->check(CLI::Range(0.1, 10000.0));
  submit
      ->add_option("--minutes", options->submit.ask.minutes,
                   "Time limit for each batch; else by what 'process' states of it")
      ->check(CLI::Range(2, 100000));
  submit->add_option("--partition", options->submit.ask.partition, "Partition of the cluster");
  submit->add_option("--account", options->submit.ask.account, "Account that pays");
  submit
      ->add_option("--program", options->submit.ask.program,
                   "Words that start Ostraka on a node, as 'module load ostraka; ostraka'")
      ->capture_default_str();
  submit->add_option("--most", options->submit.most, "At most so many batches, oldest first")
      ->check(CLI::Range(1, 1000000));
  add("status", "Tell of each batch whether it waits, runs, is done or failed, and why", runStatus);
  add("collect", "Enter complete results in the catalogue, once", runCollect);
}

}  // namespace ostraka::app
