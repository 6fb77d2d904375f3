// Every file that a command reads, in the place of which stands something else: the command ends at
// once with status 2 and one sentence that names it.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cloud/ply.h"

namespace {

namespace fs = std::filesystem;

enum class Kind { Pipe, Device, Folder, Empty, Closed };

const std::pair<Kind, const char*> kKinds[] = {{Kind::Pipe, "a pipe"},
                                               {Kind::Device, "a device"},
                                               {Kind::Folder, "a folder"},
                                               {Kind::Empty, "an empty file"},
                                               {Kind::Closed, "a file without permissions"}};

// One file of one command: @ stands for the test's folder.
struct Input {
  const char* command;
  const char* file;
};

const Input kInputs[] = {
    {"draw @/bad.ply -o @/d.pdf", "bad.ply"},
    {"evaluate @/bad.ply --truth @/good.ply", "bad.ply"},
    {"evaluate @/good.ply --truth @/bad.ply", "bad.ply"},
    {"evaluate @/registered --truth @/truth", "registered/pairs.json"},
    {"evaluate @/truth_pairs --truth @/truth_bad", "truth_bad/truth.json"},
    {"rig predict @/bad.json", "bad.json"},
    {"rig calibrate @/boards -o @/rig.json", "boards/board.json"},
    {"register --front @/scans_bad --back @/scans -o @/out", "scans_bad/a.ply"},
    {"register --front @/scans --back @/scans_bad -o @/out", "scans_bad/a.ply"},
    {"process @/batch -o @/out", "batch/plate.json"},
    {"process @/batch_board -o @/out", "batch_board/board.json"},
    {"process @/batch_scale -o @/out", "batch_scale/scale.json"},
    {"process @/batch_photo -o @/out", "batch_photo/front/cam0_pos00.tif"},
    {"dense @/masked --cameras @/bad.json -o @/c.ply", "bad.json"},
    {"dense @/photos --cameras @/cameras.json -o @/c.ply", "photos/bad.tif"},
    {"dense @/masked --masks @/masks --cameras @/cameras.json -o @/c.ply", "masks/bad.png"},
    {"capture --rig @/bad.json --side front -o @/batch_new", "bad.json"},
    {"catalogue import @/project @/bad.csv", "bad.csv"},
};

// 64 x 48 pixels, black, uncompressed.
std::string greyTiff() {
  constexpr std::uint32_t kWidth = 64, kHeight = 48, kStart = 8 + 2 + 9 * 12 + 4;
  const std::array<std::uint32_t, 2> tags[] = {
      {256, kWidth},  {257, kHeight},         {258, 8}, {259, 1}, {262, 1}, {273, kStart}, {277, 1},
      {278, kHeight}, {279, kWidth * kHeight}};
  std::string bytes("II*\0\x08\0\0\0\x09\0", 10);
  for (const auto& [tag, value] : tags) {
    for (const std::uint32_t part : {tag | 4U << 16, 1U, value})  // a number of 4 bytes
      bytes.append(reinterpret_cast<const char*>(&part), sizeof part);
  }
  return bytes + std::string(4 + kWidth * kHeight, '\0');
}

struct Ending {
  int status = -1;
  std::string text;
  double seconds = 0;
};

class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    fs::copy_file(OSTRAKA_PROGRAM, folder_ / "ostraka");  // a build folder may be closed to nobody
    ostraka::TriangleMesh mesh;                           // a tetrahedron of 30 mm
    mesh.vertices = {{0, 0, 0}, {30, 0, 0}, {0, 30, 0}, {0, 0, 30}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    for (const char* name : {"good.ply", "scans/a.ply"})
      ASSERT_TRUE(ostraka::writePly(folder_ / name, mesh, "model").has_value());
    write("cameras.json", R"({"unit":"mm","images":[{"file":"bad.tif","width":64,"height":48,
        "K":[[100,0,32],[0,100,24],[0,0,1]],"dist":[],
        "R":[[1,0,0],[0,1,0],[0,0,1]],"t":[0,0,100]}]})");
    write("truth/truth.json", R"({"pairs":[]})");
    write("truth_pairs/pairs.json", R"({"pairs":[]})");
    write("masked/bad.tif", greyTiff());
    for (const char* batch : {"batch", "batch_board", "batch_scale"})
      for (const char* side : {"front", "back"})
        for (const char* name : {"cam0_pos00.tif", "cam0_pos01.tif", "cam0_pos02.tif"})
          write(std::string(batch) + "/" + side + "/" + name, greyTiff());
    fs::create_directories(folder_ / "batch_photo/back");
    ASSERT_EQ(run("catalogue new --code BAD -o @/project").status, 0);
    // Where the tests run as root, who may read everything, the program runs as nobody.
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      fs::permissions(entry.path(), fs::perms::all);
    fs::permissions(folder_, fs::perms::all);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  void put(Kind kind, const fs::path& file) const {
    fs::create_directories(file.parent_path());
    fs::permissions(file.parent_path(), fs::perms::all);
    if (kind == Kind::Pipe) {
      ASSERT_EQ(::mkfifo(file.c_str(), 0666), 0);
    }
    if (kind == Kind::Device) fs::create_symlink("/dev/zero", file);
    if (kind == Kind::Folder) fs::create_directories(file);
    if (kind == Kind::Empty || kind == Kind::Closed) std::ofstream(file).flush();
    if (kind == Kind::Closed) fs::permissions(file, fs::perms::none);
  }

  Ending run(std::string arguments, bool as_nobody = false) const {
    for (std::size_t at = arguments.find('@'); at != std::string::npos; at = arguments.find('@'))
      arguments.replace(at, 1, folder_.string());
    const std::string who =
        as_nobody && ::geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
    const std::string command =
        "timeout --kill-after=1 20 " + who +
        "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM HOME=" + folder_.string() + " " +
        (folder_ / "ostraka").string() + " " + arguments + " 2>&1 < /dev/null";
    Ending outcome;
    const auto begin = std::chrono::steady_clock::now();
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::array<char, 4096> buffer;
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
      outcome.text.append(buffer.data(), n);
    const int status = ::pclose(pipe);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return outcome;
  }

  fs::path folder_ = fs::path("/tmp") / ("ostraka_bad_" + std::to_string(::getpid()));
};

TEST_F(BadInput, OfEveryKindEndsEveryCommandAtOnceWithASentenceThatNamesIt) {
  for (const auto& [command, name] : kInputs)
    for (const auto& [kind, word] : kKinds) {
      const fs::path file = folder_ / name;
      put(kind, file);
      const Ending outcome = run(command, true);
      const std::string what = std::string(command) + " with " + word + ":\n" + outcome.text +
                               "status " + std::to_string(outcome.status);
      EXPECT_EQ(outcome.status, 2) << what;
      EXPECT_LT(outcome.seconds, 5) << what;
      EXPECT_NE(outcome.text.find(file.filename().string()), std::string::npos) << what;
      EXPECT_EQ(outcome.text.find("exception"), std::string::npos) << what;
      std::error_code ignored;
      fs::remove_all(file, ignored);
      fs::remove_all(folder_ / "out", ignored);
    }
}

TEST_F(BadInput, AWordOfItsKindTellsAPipeADeviceAndAFolderFromAFile) {
  for (const auto& [kind, word] : {kKinds[0], kKinds[1], kKinds[2]}) {
    put(kind, folder_ / "bad.ply");
    const Ending outcome = run("draw @/bad.ply -o @/d.pdf --quiet");
    EXPECT_EQ(outcome.text.find("\n"), outcome.text.size() - 1) << "one sentence: " << outcome.text;
    EXPECT_NE(outcome.text.find("This is " + std::string(word) + ", not a file"), std::string::npos)
        << outcome.text;
    fs::remove_all(folder_ / "bad.ply");
  }
}

TEST_F(BadInput, AFaceOfThirtyMillionCornersIsRefusedUnread) {
  constexpr std::uint32_t kCorners = 30'000'000;
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n" +
      std::string(36, '\0');
  bytes.append(reinterpret_cast<const char*>(&kCorners), sizeof kCorners);
  bytes.append(std::size_t{4} * kCorners, '\0');
  write("bad.ply", bytes);
  const Ending outcome = run("evaluate @/bad.ply --truth @/good.ply");
  EXPECT_EQ(outcome.status, 2) << outcome.text;
  EXPECT_LT(outcome.seconds, 5);
  EXPECT_NE(outcome.text.find("more than 1000 corners"), std::string::npos) << outcome.text;
}

// The folder that it named after its process was removed with all that others had put there.
TEST_F(BadInput, PredictLeavesAFolderOfItsOldNameAlone) {
  write("rig.json", R"({"format":"ostraka-rig/1","cameras":[{"camera":0,"width":640,"height":480,
      "K":[[800,0,320],[0,800,240],[0,0,1]],"dist":[0,0,0,0,0],
      "camera_from_turntable":[1,0,0,0, 0,1,0,0, 0,0,1,300, 0,0,0,1]}],
      "stops":[{"stop":0,"angle_deg":0}]})");
  const std::string tmp = (folder_ / "tmp").string();
  fs::create_directories(tmp);
  const std::string script = "cd " + tmp + " && mkdir ostraka-predict-$$ && touch " +
                             "ostraka-predict-$$/mine && TMPDIR=" + tmp + " exec " +
                             OSTRAKA_PROGRAM + " rig predict ../rig.json --sherds-per-size -5";
  EXPECT_NE(std::system(("sh -c '" + script + "' 2> /dev/null").c_str()), 0);
  int kept = 0;
  for (const auto& entry : fs::recursive_directory_iterator(tmp))
    kept += entry.path().filename() == "mine" ? 1 : 0;
  EXPECT_EQ(kept, 1);
  EXPECT_EQ(std::distance(fs::directory_iterator(tmp), fs::directory_iterator()), 1);
}

}  // namespace
