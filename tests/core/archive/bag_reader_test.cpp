#include "archive/bag_reader.h"

#include <gtest/gtest.h>

#include <fstream>

#include "files/files.h"
#include "tests/core/archive/written_bag.h"
#include "tests/core/exchange/mended_bag.h"

namespace ostraka::archive {
namespace {

namespace fs = std::filesystem;

using BagReaderOf = WrittenBag;

TEST_F(BagReaderOf, ABagNoticesAChangedAMissingAndAnUnlistedFile) {
  write();
  std::ofstream(target / "data" / "sherds.csv") << "a,c\r\n";
  EXPECT_NE(why().find("sherds.csv: This file has changed"), std::string::npos) << why();
  fs::remove(target / "data" / "sherds.csv");
  EXPECT_NE(why().find("missing"), std::string::npos) << why();
  std::ofstream(target / "data" / "sherds.csv") << "a,b\r\n";
  EXPECT_EQ(why(), "accepted");
  std::ofstream(target / "data" / "more.txt") << "x";
  EXPECT_NE(why().find("more.txt: This file is not in the manifest"), std::string::npos) << why();
  fs::remove(target / "data" / "more.txt");
  std::ofstream(target / "bag-info.txt") << "x";
  EXPECT_NE(why().find("bag-info.txt: This file has changed"), std::string::npos) << why();
}

TEST_F(BagReaderOf, ABagRefusesManifestsThatPointOutside) {
  write();
  exchange::MendedBag bag(target);
  bag.list("../../secret", "x");
  bag.mend();
  EXPECT_NE(why().find("outside the folder"), std::string::npos) << why();
  bag.payload.pop_back();
  bag.tag("../secret");
  bag.mend();
  EXPECT_NE(why().find("outside the folder (../secret)"), std::string::npos) << why();
  fs::remove_all(target / "bagit.txt");
  EXPECT_NE(why().find("Not an Ostraka export"), std::string::npos) << why();
}

TEST_F(BagReaderOf, ABagRefusesLinesThatAreNoneOrComeTwice) {
  write();
  exchange::MendedBag bag(target);
  bag.payload.push_back(bag.payload.front());
  bag.mend();
  EXPECT_NE(why().find("names the file " + bag.payload.front().first + " twice"), std::string::npos)
      << why();
  for (const char* hash : {"abc", "", "G0", "not a hash of sixty-four letters"}) {
    bag.payload.back() = {"data/x", hash};
    bag.mend();
    EXPECT_NE(why().find("a line that cannot be read"), std::string::npos) << why();
  }
}

// Programs of others mark binary files with a star and end lines as on Windows.
TEST_F(BagReaderOf, ABagReadsTheManifestsOfOtherPrograms) {
  write();
  exchange::MendedBag bag(target);
  for (auto& [name, hash] : bag.payload) name = "*" + name + "\r";
  bag.mend();
  EXPECT_EQ(why(), "accepted");
}

TEST_F(BagReaderOf, ABagRefusesLinksAndNamesThatAreOneElsewhere) {
  write();
  exchange::MendedBag bag(target);
  bag.put("data/SHERDS.csv", "x");
  bag.mend();
  EXPECT_NE(why().find("SHERDS.csv"), std::string::npos) << why();
  bag.drop("data/SHERDS.csv");
  bag.mend();
  EXPECT_EQ(why(), "accepted");
  fs::rename(target / "data/sherds.csv", folder.path() / "elsewhere.csv");
  fs::create_symlink(folder.path() / "elsewhere.csv", target / "data/sherds.csv");
  EXPECT_NE(why().find("sherds.csv: This is a link"), std::string::npos) << why();
}

// Whoever writes the folder may change it between the check and the reading.
TEST_F(BagReaderOf, ABagHoldsWhatIsReadLaterAgainstItsManifest) {
  write();
  const Result<BagReader> bag = BagReader::open(target, quiet, {});
  ASSERT_TRUE(bag) << bag.error().sentence();
  EXPECT_EQ(bag->find("data/sherds.CSV"), nullptr);
  const BagFile* file = bag->find("data/sherds.csv");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(file->bytes, 5);
  EXPECT_EQ(*bag->read(*file, 5), "a,b\r\n");
  EXPECT_FALSE(bag->read(*file, 4));
  const fs::path place = folder.path() / "copies";
  fs::create_directories(place);
  const OpenFolder to = std::move(*OpenFolder::open(place));
  const ContainedPath first = *ContainedPath::parse("1.csv"),
                      second = *ContainedPath::parse("2.csv");
  ASSERT_TRUE(bag->copy(*file, to, first, {}));
  EXPECT_EQ(*readFile(place / "1.csv"), "a,b\r\n");
  EXPECT_FALSE(bag->copy(*file, to, first, {})) << "a file is there";
  std::ofstream(target / "data/sherds.csv") << "a,c\r\n";
  for (const Error& error : {bag->read(*file, 5).error(), bag->copy(*file, to, second, {}).error()})
    EXPECT_NE(error.sentence().english().find("has changed since the export"), std::string::npos)
        << error.sentence();
  EXPECT_FALSE(fs::exists(place / "2.csv"));
}

TEST_F(BagReaderOf, ABagStopsOnRequest) {
  write();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(BagReader::open(target, quiet, stop.get_token()).error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::archive
