#pragma once
#include <gtest/gtest.h>
#include <stdlib.h>

#include <nlohmann/json.hpp>

#include "files/json.h"
#include "program.h"

namespace ostraka::test {

/// Two sherds, photographed and scanned by the virtual rig, once for all tests.
class BatchForFaults : public testing::Test {
 protected:
  static const std::filesystem::path& root() {
    static const Made made;
    return made.root;
  }
  static std::filesystem::path errors() { return root() / "errors"; }
  static std::vector<std::string> denseTo(const std::filesystem::path& cloud) {
    return {"dense",   root() / "batch", "--cameras", root() / "cameras.json",
            "--masks", root() / "masks", "--output",  cloud};
  }

 private:
  struct Made {
    Made() {
      std::string pattern =
          (std::filesystem::temp_directory_path() / "ostraka_faults_XXXXXX").string();
      root = ::mkdtemp(pattern.data());
      simulate("batch", {});
      simulate("scans", {"--scans-only"});
      layOutForDense();
    }
    ~Made() {
      std::error_code ignored;
      std::filesystem::remove_all(root, ignored);
    }
    void simulate(const std::string& name, const std::vector<std::string>& more) const {
      std::vector<std::string> words{"rig",    "simulate", "--output",  root / name, "--sherds",
                                     "2",      "--width",  "480",       "--stops",   "6",
                                     "--seed", "7",        "--threads", "2"};
      words.insert(words.end(), more.begin(), more.end());
      const Ended ended = runProgram(words, root / "errors");
      EXPECT_EQ(ended.status, 0) << ended.errors;
    }
    // The cameras and masks of one side, where dense looks for them.
    void layOutForDense() const {
      const std::filesystem::path truth = root / "batch" / "truth";
      const nlohmann::json cameras = *readJson(truth / "cameras.json");
      nlohmann::json fronts = nlohmann::json::array();
      std::filesystem::create_directories(root / "masks" / "front");
      for (const nlohmann::json& image : cameras["images"]) {
        if (image["side"] != "front") continue;
        fronts.push_back(image);
        const std::filesystem::path file = image["file"].get<std::string>();
        std::filesystem::copy(truth / "masks" / ("front_" + file.stem().string() + ".png"),
                              root / "masks" / "front" / (file.stem().string() + ".png"));
      }
      EXPECT_TRUE(writeJson(root / "cameras.json", {{"unit", "mm"}, {"images", fronts}}));
    }
    std::filesystem::path root;
  };
};

}  // namespace ostraka::test
