#include "files/checksum.h"

#include <openssl/evp.h>

#include <array>

#include "base/text.h"
#include "files/files.h"

namespace ostraka {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;

constexpr std::array<std::uint32_t, 256> crcTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xEDB88320U ^ (c >> 1) : c >> 1;
    table[n] = c;
  }
  return table;
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = crcTable();
  std::uint32_t crc = ~std::uint32_t{0};
  for (const char byte : bytes)
    crc = kTable[(crc ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (crc >> 8);
  return ~crc;
}

Sha256::Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
  EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
}

void Sha256::add(std::string_view bytes) {
  EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size());
}

std::string Sha256::hexadecimal() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  EVP_DigestFinal_ex(context_.get(), digest.data(), &size);
  return ostraka::hexadecimal(std::span(digest).first(size));
}

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.hexadecimal();
}

Result<Checksum> checksumOf(OpenFile& file, const std::stop_token& stop,
                            const std::function<Result<void>(std::string_view)>& use) {
  Checksum sum;
  Sha256 hash;
  std::string piece(kPiece, '\0');
  while (true) {
    if (stop.stop_requested()) return Error::cancelled();
    const Result<std::size_t> size = file.read(piece);
    if (!size) return size.error();
    const std::string_view bytes = std::string_view(piece).substr(0, *size);
    hash.add(bytes);
    sum.bytes += static_cast<std::int64_t>(*size);
    if (use)
      if (const Result<void> used = use(bytes); !used) return used.error();
    if (*size < piece.size()) break;
  }
  sum.sha256 = hash.hexadecimal();
  return sum;
}

}  // namespace ostraka
