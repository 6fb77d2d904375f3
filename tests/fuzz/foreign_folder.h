#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ostraka::fuzz {

/// The catalogue of a new project, made once: making one takes longer than what is fuzzed.
std::string emptyCatalogue();

/// A folder from a stranger as one text: each file begins with a line '=== PATH', its content
/// follows. '=== PATH -> TARGET' is a symbolic link. A line of a manifest that begins with '@  '
/// stands for the true hash of the file that it names; where a manifest is missing, the true one is
/// written, so that a change of any content reaches the readers behind the hashes. The content
/// '@project' stands for the catalogue of a new project.
struct ForeignFile {
  std::string path, link, content;
};
std::vector<ForeignFile> foreignFiles(std::string_view text);

/// A folder in memory with a foreign folder in it, a file that nobody may touch, and room beside
/// them; gone with the object. Aborts when anything came to be outside of `target`.
class Sandbox {
 public:
  explicit Sandbox(const std::vector<ForeignFile>& files);
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;
  std::filesystem::path foreign() const { return folder_ / "foreign"; }
  std::filesystem::path target() const { return folder_ / "target"; }
  /// Nothing but the target is new, and nothing of the file that nobody may touch is in it.
  void mustBeContained() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace ostraka::fuzz
