#pragma once
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "cluster/collect.h"
#include "cluster/submit.h"
#include "cluster/tasks.h"
#include "files/files.h"
#include "tests/core/catalogue/result_folder.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::cluster {

namespace fs = std::filesystem;

/// Batches that wait in the queue, and a stand-in for Ostraka on the nodes: it leaves the results
/// of three sherds, unless a file of the folder "fault" says otherwise.
class ClusterProject : public catalogue::SmallProject {
 protected:
  ClusterProject() {
    // Not that of whoever runs the tests.
    ::setenv("XDG_CONFIG_HOME", (folder_.path() / "config").c_str(), 1);
    fs::create_directories(fault());
    fs::create_directories(bin());
    program("ostraka-here", "out=$4\nb=${2#batches/}\nf='" + fault().string() +
                                "'\nmkdir -p \"$out\"\necho \"$b\" >> \"$f/runs\"\n"
                                "if [ -f \"$f/$b\" ]; then . \"$f/$b\"; fi\n"
                                "cp -r '" +
                                (folder_.path() / "prepared").string() +
                                "/'\"$b\"/. \"$out\"\nexit 3\n");
    submitting.ask.program = "'" + (bin() / "ostraka-here").string() + "'";
    submitting.ask.cores = 1;
  }
  fs::path bin() const { return folder_.path() / "bin"; }
  fs::path fault() const { return folder_.path() / "fault"; }
  void program(const std::string& name, const std::string& text) const {
    std::ofstream(bin() / name) << "#!/bin/sh\n" << text;
    fs::permissions(bin() / name, fs::perms::owner_all);
  }
  void put(const fs::path& file, const std::string& text) const { std::ofstream(file) << text; }
  std::string textOf(const fs::path& file) const {
    const Result<std::string> text = readFile(file);
    return text ? *text : std::string();
  }

  /// B0001, B0002, ...: four small photographs a side, and what a computation would leave of it.
  store::BatchRow queuedBatch() {
    const store::BatchRow row = newBatch({bag4});
    const std::string number = catalogue::Batches(catalogue()).get(row)->number;
    const int shade = static_cast<int>(row.value % 200);
    for (const char* side : {"front", "back"}) photograph(number, side, shade);
    const fs::path prepared = preparedFor(number);
    const catalogue::ResultFolder results(prepared, 3);
    catalogue::ResultFolder::noteInputs(prepared, project_->batchFolder(number));
    for (const char* stage : {"scans_front", "scans_back"}) {
      nlohmann::ordered_json files;
      for (const fs::directory_entry& file : fs::directory_iterator(prepared / "work" / stage))
        files[file.path().filename().string()] = sha256(textOf(file.path()));
      put(prepared / "work" / stage / "stage.json",
          nlohmann::ordered_json({{"files", files}}).dump());
    }
    EXPECT_TRUE(catalogue::Batches(catalogue()).setState(row, records::BatchState::Queued, anna));
    return row;
  }
  fs::path preparedFor(const std::string& number) const {
    return folder_.path() / "prepared" / number;
  }
  /// Anew with another shade; the next computation reads these.
  void photograph(const std::string& number, const std::string& side, int shade) const {
    const fs::path folder = project_->batchFolder(number) / side;
    fs::create_directories(folder);
    for (int stop = 0; stop < 4; ++stop)
      cv::imwrite((folder / ("cam0_pos0" + std::to_string(stop) + ".png")).string(),
                  cv::Mat(12, 16, CV_8UC3, cv::Scalar(shade, 40 * stop, side[0])));
    if (fs::exists(preparedFor(number)))
      catalogue::ResultFolder::noteInputs(preparedFor(number), project_->batchFolder(number));
  }
  records::BatchState stateOf(store::BatchRow row) {
    return catalogue::Batches(catalogue()).get(row)->state;
  }
  std::size_t sherdsOf(store::BatchRow row) {
    return catalogue::valueIn(sherds::Sherds(catalogue()).rows(row)).size();
  }

  Result<Submitted> submitAll() { return submit(*project_, submitting, quiet, {}); }
  std::vector<TaskStatus> states() {
    return catalogue::valueIn(status(project_->folder(), submitting.access, {}));
  }
  TaskStatus stateOfBatch(const std::string& batch) {
    for (const TaskStatus& one : states())
      if (one.task.batch == batch) return one;
    ADD_FAILURE() << batch;
    return {};
  }

  SubmitOptions submitting;
  QuietProgress quiet;
};

}  // namespace ostraka::cluster
