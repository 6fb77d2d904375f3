#include "files/checksum.h"

#include <openssl/evp.h>

#include <array>

namespace ostraka {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;

}  // namespace

struct Sha256::Context {
  EVP_MD_CTX* openssl = EVP_MD_CTX_new();
  ~Context() { EVP_MD_CTX_free(openssl); }
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  EVP_DigestInit_ex(context_->openssl, EVP_sha256(), nullptr);
}
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  EVP_DigestUpdate(context_->openssl, bytes.data(), bytes.size());
}

std::string Sha256::hexadecimal() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  EVP_DigestFinal_ex(context_->openssl, digest.data(), &size);
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    text += "0123456789abcdef"[digest[i] >> 4];
    text += "0123456789abcdef"[digest[i] & 15];
  }
  return text;
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
