#pragma once
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "base/progress.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::batch {

/// A folder of a test, with photographs and other files in it.
class BatchFolder : public TemporaryFolder {
 public:
  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((path() / name).parent_path());
    std::ofstream(path() / name, std::ios::binary) << bytes;
  }
  void image(const std::string& name, int width = 16, int height = 12) const {
    std::filesystem::create_directories((path() / name).parent_path());
    cv::imwrite((path() / name).string(), cv::Mat(height, width, CV_8UC3, cv::Scalar(10, 20, 30)));
  }
  std::string read(const std::string& name) const {
    std::ifstream in(path() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

/// Keeps the warnings.
class Listener final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel level, const Message& text) override {
    (level == NoteLevel::Warning ? warnings : infos).emplace_back(text.english());
  }
  std::vector<std::string> warnings, infos;
};

}  // namespace ostraka::batch
