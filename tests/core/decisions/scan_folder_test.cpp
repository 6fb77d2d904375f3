#include "decisions/scan_folder.h"

#include <gmock/gmock.h>

#include <cmath>

#include "cloud/ply.h"
#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A flat disc of 20 mm radius, far from the origin of its file, seen from above.
PointCloud disc(double factor = 1) {
  PointCloud cloud;
  for (int x = -20; x <= 20; ++x)
    for (int y = -20; y <= 20; ++y) {
      if (x * x + y * y > 400) continue;
      cloud.points.emplace_back(Eigen::Vector3f(100 + x, 50 + y, 5 + 0.1f * std::sin(x + 2.f * y)) *
                                static_cast<float>(factor));
      cloud.normals.emplace_back(0, 0, 1);
    }
  return cloud;
}

class ScanFolders : public testing::Test {
 protected:
  void write(const std::string& name, const PointCloud& cloud) {
    ASSERT_TRUE(writePly(folder / name, cloud, "scanner").has_value());
  }
  ScanFolder read(const std::string& side) {
    Result<ScanFolder> found = readScanFolder(folder / side, 1);
    EXPECT_TRUE(found.has_value()) << (found ? "" : found.error().sentence());
    return found ? std::move(*found) : ScanFolder{};
  }

  TemporaryFolder temporary_;
  fs::path folder = temporary_.path();
};

TEST_F(ScanFolders, GiveAWholeScanAsItIs) {
  write("front/a.ply", disc());
  const ScanFolder side = read("front");
  ASSERT_EQ(side.scans.size(), 1u);
  EXPECT_EQ(side.scans[0].cloud.size(), disc().size());
  EXPECT_TRUE(side.warnings.empty());
}

// In results both would be "s?": nobody could say which sherd is which.
TEST_F(ScanFolders, AreRefusedWhereANameIsNoText) {
  for (const char* name : {"s\xFF.ply", "s\xC3\xA9\xFE\xE2\x82.ply"}) {
    write(std::string("front/") + name, disc());
    const Result<ScanFolder> refused = readScanFolder(folder / "front", 1);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().where, (folder / "front").string());
    const bool first = name[1] == '\xFF';
    EXPECT_THAT(
        refused.error().what.english(),
        HasSubstr(first ? "file s\\xFF.ply is not" : "file s\u00E9\\xFE\\xE2\\x82.ply is not"));
    fs::remove(folder / "front" / name);
  }
  write("front/s\u00E9.ply", disc());
  EXPECT_EQ(read("front").scans.at(0).id, "s\u00E9");
}

// Ten metres away, or where the scanner puts what it did not see: one point would turn the scan.
TEST_F(ScanFolders, LeaveOutPointsThatAreNoMeasurementAndSaySo) {
  PointCloud flying = disc(), unseen = disc();
  flying.points.emplace_back(10000, 5000, 3333);
  flying.normals.emplace_back(0, 0, 1);
  for (int i = 0; i < 30; ++i) {
    unseen.points.emplace_back(0, 0, 0);
    unseen.normals.emplace_back(0, 0, 1);
  }
  write("front/flying.ply", flying);
  write("front/unseen.ply", unseen);
  const ScanFolder side = read("front");
  ASSERT_EQ(side.scans.size(), 2u);
  for (const scan::Scan& scan : side.scans) {
    EXPECT_EQ(scan.cloud.size(), disc().size()) << scan.id;
    EXPECT_EQ(scan.cloud.normals.size(), scan.cloud.size());
    EXPECT_GT(scan.up.z(), 0.999) << scan.id;  // 0.1 mm of waves over 40 mm
  }
  ASSERT_EQ(side.warnings.size(), 2u);
  EXPECT_THAT(side.warnings[0], HasSubstr("flying.ply: 1 point far from all others"));
  EXPECT_THAT(side.warnings[1], HasSubstr("unseen.ply: 30 points"));
}

// A mesh has a vertex for each face with a normal of its own; a search for neighbours among
// thousands of points at one place would take the square of their number.
TEST_F(ScanFolders, CountRepeatedPointsOnce) {
  PointCloud repeated = disc();
  for (int times = 0; times < 3; ++times) {
    const PointCloud again = disc();
    repeated.points.insert(repeated.points.end(), again.points.begin(), again.points.end());
    repeated.normals.insert(repeated.normals.end(), again.normals.begin(), again.normals.end());
  }
  write("front/a.ply", repeated);
  const ScanFolder side = read("front");
  ASSERT_EQ(side.scans.size(), 1u);
  EXPECT_EQ(side.scans[0].cloud.points, disc().points);
  EXPECT_EQ(side.scans[0].cloud.normals, disc().normals);
  EXPECT_TRUE(side.warnings.empty());
}

// As MeshLab writes the vertices that no face uses.
TEST_F(ScanFolders, LeaveOutPointsWhoseNormalsHaveNoDirectionAndSaySo) {
  PointCloud some = disc(), none = disc();
  for (std::size_t i = 0; i < 7; ++i) some.normals[i].setZero();
  for (Eigen::Vector3f& normal : none.normals) normal.setZero();
  write("front/some.ply", some);
  write("front/none.ply", none);
  const ScanFolder side = read("front");
  ASSERT_EQ(side.scans.size(), 1u);
  EXPECT_EQ(side.scans[0].cloud.size(), disc().size() - 7);
  EXPECT_EQ(side.unusable, 1);
  EXPECT_THAT(side.warnings,
              testing::Contains(HasSubstr("some.ply: 7 points whose normals have no direction")));
  EXPECT_THAT(side.warnings, testing::Contains(HasSubstr("The scan has no normals")));
}

TEST_F(ScanFolders, DoNotLookAtHiddenFiles) {
  write("batch/front/a.ply", disc());
  ASSERT_TRUE(writeFileAtomically(folder / "batch/front/._a.ply", "Mac OS X").has_value());
  ASSERT_TRUE(writeFileAtomically(folder / "photos/front/._a.ply", "Mac OS X").has_value());
  const ScanFolder side = read("batch/front");
  EXPECT_EQ(side.scans.size(), 1u);
  EXPECT_EQ(side.unusable, 0);
  EXPECT_TRUE(holdsScans(folder / "batch"));
  EXPECT_FALSE(holdsScans(folder / "photos"));
}

TEST_F(ScanFolders, InAMapsCoordinatesAreNamedInsteadOfRounded) {
  PointCloud surveyed = disc();
  for (Eigen::Vector3f& p : surveyed.points) p += Eigen::Vector3f(300e3f, 400e3f, 0);
  write("front/a.ply", surveyed);
  write("front/b.ply", disc());
  const ScanFolder side = read("front");
  EXPECT_EQ(side.scans.size(), 1u);
  EXPECT_EQ(side.unusable, 1);
  ASSERT_EQ(side.warnings.size(), 1u);
  EXPECT_THAT(side.warnings[0], HasSubstr("a.ply"));
  EXPECT_THAT(side.warnings[0], HasSubstr("times its length away from the origin"));
}

TEST_F(ScanFolders, InAnotherUnitAreNamedWithIt) {
  struct Case {
    double front, back;
    const char* words;
  };
  for (const Case& c :
       {Case{0.1, 0.1, "4.0 mm; their unit seems to be centimetres"},
        Case{0.001, 0.001, "0.040 mm; their unit seems to be metres"},
        Case{1000, 1000, "40000 mm; their unit seems to be micro"},
        Case{0.015, 0.015, "no sherds are of that size"}, Case{1, 0.1, "centimetres"},
        Case{4, 1, "The median length of the fronts is 160 mm, of the backs 40.0 mm"}}) {
    write("front/a.ply", disc(c.front));
    write("back/a.ply", disc(c.back));
    const Result<void> unit = checkUnit(read("front"), read("back"), "export them in mm");
    ASSERT_FALSE(unit.has_value()) << c.words;
    EXPECT_EQ(unit.error().code, ErrorCode::UnusableInput);
    EXPECT_THAT(unit.error().sentence(), HasSubstr(c.words));
    EXPECT_THAT(unit.error().sentence(), HasSubstr(": export them in mm."));
  }
  write("front/a.ply", disc(2));
  write("back/a.ply", disc());
  EXPECT_TRUE(checkUnit(read("front"), read("back"), "").has_value()) << "sherds differ in size";
}

}  // namespace
}  // namespace ostraka::decisions
