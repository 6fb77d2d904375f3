#include "files/contained_path.h"

#include <algorithm>
#include <cassert>

#include "base/message.h"

namespace ostraka {
namespace {

constexpr std::size_t kMostBytes = 4096;
constexpr std::size_t kMostOfAPart = 255;  // what file systems take

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

}  // namespace

Result<ContainedPath> ContainedPath::parse(std::string_view text) {
  const auto refused = [&] {
    return Error::unusable(message(
        "'%1' is not a path inside its folder; it must be relative, with '/' and without '..'.",
        std::string(text.substr(0, kMostOfAPart))));
  };
  if (text.size() > kMostBytes || std::any_of(text.begin(), text.end(), isControl) ||
      text.find('\\') != std::string_view::npos || (text.size() > 1 && text[1] == ':'))
    return refused();
  ContainedPath path;
  path.text_ = text;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find('/', from), text.size());
    const std::string_view part = text.substr(from, to - from);
    if (part.empty() || part == "." || part == ".." || part.size() > kMostOfAPart) return refused();
    path.parts_.emplace_back(part);
    from = to + 1;
  }
  return path;
}

ContainedPath ContainedPath::below() const {
  assert(parts_.size() > 1);
  ContainedPath path;
  path.text_ = text_.substr(parts_.front().size() + 1);
  path.parts_.assign(parts_.begin() + 1, parts_.end());
  return path;
}

}  // namespace ostraka
