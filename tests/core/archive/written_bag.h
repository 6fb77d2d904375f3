#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "archive/bagit.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::archive {

/// A folder with two files, sealed as a bag, as far as it is one.
class WrittenBag : public ::testing::Test {
 protected:
  WrittenBag() : target(folder.path() / "out bag") {
    std::ofstream(folder.path() / "photo.jpg") << "JPEG";
  }
  void write() {
    Result<BagWriter> bag = BagWriter::begin(target);
    ASSERT_TRUE(bag) << bag.error().sentence();
    ASSERT_TRUE(bag->add("sherds.csv", "a,b\r\n"));
    ASSERT_TRUE(bag->addFile("photographs/É 1.jpg", folder.path() / "photo.jpg", {}));
    ASSERT_TRUE(bag->finish({{"External-Description", "two\nlines"}}));
  }
  Result<std::vector<BagFile>> check() { return checkBag(target, quiet, {}); }
  std::string why() {
    const auto checked = check();
    return checked ? "accepted" : checked.error().sentence().english();
  }
  TemporaryFolder folder;
  std::filesystem::path target;
  QuietProgress quiet;
};

}  // namespace ostraka::archive
