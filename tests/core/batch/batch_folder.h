#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "base/progress.h"

namespace ostraka::batch {

/// A folder that is gone after the test.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("ostraka-" + name + "-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  void image(const std::string& name, int width = 16, int height = 12) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    cv::imwrite((path_ / name).string(), cv::Mat(height, width, CV_8UC3, cv::Scalar(10, 20, 30)));
  }
  std::string read(const std::string& name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path path_;
};

/// Keeps the warnings.
class Listener final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel level, std::string_view text) override {
    (level == NoteLevel::Warning ? warnings : infos).emplace_back(text);
  }
  std::vector<std::string> warnings, infos;
};

}  // namespace ostraka::batch
