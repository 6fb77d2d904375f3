#include "base/program_parts.h"

#include <gtest/gtest.h>

#include <fstream>

namespace ostraka {
namespace {

// This test is the running program.
TEST(ProgramPart, LiesBesideTheProgramOrWhereItIsInstalled) {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string name = "part-of-a-test";
  const std::filesystem::path installed = folder.parent_path() / "libexec/ostraka";
  EXPECT_EQ(programPart(name), folder / name);
  std::filesystem::create_directories(installed);
  std::ofstream(installed / name) << "x";
  EXPECT_EQ(programPart(name), installed / name);
  std::ofstream(folder / name) << "x";
  EXPECT_EQ(programPart(name), folder / name);
  std::filesystem::remove(folder / name);
  std::filesystem::remove(installed / name);
  std::error_code holds_others;
  std::filesystem::remove(installed, holds_others);
  std::filesystem::remove(installed.parent_path(), holds_others);
}

}  // namespace
}  // namespace ostraka
