#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "files/files.h"
#include "pipeline/process_batch.h"
#include "virtualrig/simulate.h"

namespace ostraka::pipeline {

namespace fs = std::filesystem;

/// A batch of two sherds, 800 pixels wide at six stops, made once for all its cases.
class ProcessBatch : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (fs::temp_directory_path() / "ostraka_process_XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    virtualrig::SimulateOptions options;
    options.seed = 7;
    options.sherds = 2;
    options.width = 800;
    options.stops = 6;
    options.output = folder_ / "batch";
    options.threads = 0;
    QuietProgress quiet;
    const Result<void> made = virtualrig::simulateBatch(options, quiet, {});
    ASSERT_TRUE(made.has_value()) << made.error().sentence();
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static Result<ProcessSummary> process(const fs::path& output, int threads, Progress& progress,
                                        std::stop_token stop = {}) {
    ProcessOptions options;
    options.batch = folder_ / "batch";
    options.output = output;
    options.threads = threads;
    return processBatch(options, progress, stop);
  }

  // What a person keeps, by name: sherds and pairs.json. The reports hold seconds.
  static std::map<std::string, std::string> results(const fs::path& output) {
    std::map<std::string, std::string> hashes;
    hashes["pairs.json"] = sha256(*readFile(output / "pairs.json"));
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(output / "sherds"))
      if (entry.is_regular_file())
        hashes[fs::relative(entry.path(), output).generic_string()] =
            sha256(*readFile(entry.path()));
    return hashes;
  }

  // A result of its own to change, without computing it anew.
  static void copyOfWhole(const char* name) {
    QuietProgress quiet;
    if (!fs::exists(folder_ / "out" / "report.json")) {
      ASSERT_TRUE(process(folder_ / "out", 0, quiet).has_value());
    }
    fs::copy(folder_ / "out", folder_ / name, fs::copy_options::recursive);
  }

  inline static fs::path folder_;
};

}  // namespace ostraka::pipeline
