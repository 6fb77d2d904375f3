#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "base/result.h"
#include "files/open_folder.h"

struct evp_md_ctx_st;

namespace ostraka {

/// SHA-256 of bytes that arrive in pieces.
class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  std::string hexadecimal();  ///< in lower case; call once, at the end

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

/// CRC-32 of ISO 3309, as PNG and ZIP files have it.
std::uint32_t crc32(std::string_view bytes);

struct Checksum {
  std::string sha256;
  std::int64_t bytes = 0;
};
/// Reads a file to its end in pieces of 1 MiB and hands each to `use`. Errors: those of the disk
/// and of `use`, Cancelled within a piece.
Result<Checksum> checksumOf(OpenFile& file, const std::stop_token& stop,
                            const std::function<Result<void>(std::string_view)>& use = {});

}  // namespace ostraka
