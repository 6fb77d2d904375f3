#include "store/wal_content.h"

#include <endian.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "store/page_checksums.h"

namespace ostraka::store {
namespace {

constexpr std::size_t kFrameBytes = kFrameHeaderBytes + kPageBytes;
constexpr std::size_t kSizeAt = 4, kFrameSaltsAt = 8, kHeaderSaltsAt = 16, kSaltBytes = 8;
// A file that was written to do harm is not tried bit by bit, which takes 10 ms a page.
constexpr int kMostFramesTried = 100;

struct WalSums {
  std::uint32_t s0 = 0, s1 = 0;
  bool operator==(const WalSums&) const = default;
};
WalSums walSumsAt(const unsigned char* at) {
  return {bigEndian(at), bigEndian(at + 4)};
}

struct Frame {
  std::array<unsigned char, kFrameBytes> bytes{};
  unsigned char* page() { return bytes.data() + kFrameHeaderBytes; }
  std::uint32_t number() const { return bigEndian(bytes.data()); }
  bool endsTransaction() const { return bigEndian(bytes.data() + kSizeAt) != 0; }
  WalSums sums() const { return walSumsAt(bytes.data() + kFrameChecksumAt); }
  bool isWhole() const { return isWholePage(bytes.data() + kFrameHeaderBytes, number()); }
  int wrongSaltBytes(const std::array<unsigned char, kSaltBytes>& salts) const {
    int wrong = 0;
    for (std::size_t i = 0; i < kSaltBytes; ++i)
      wrong += bytes[kFrameSaltsAt + i] == salts[i] ? 0 : 1;
    return wrong;
  }
  void flip(std::size_t bit) { bytes[bit / 8] ^= static_cast<unsigned char>(1 << bit % 8); }
};

class WalReader {
 public:
  WalReader(const ReadAt& read, std::int64_t bytes)
      : read_(read),
        frames_((bytes - static_cast<std::int64_t>(kWalHeaderBytes)) /
                static_cast<std::int64_t>(kFrameBytes)) {}

  WalContent content() {
    WalContent content;
    if (frames_ < 1 || !readHeader()) return content;
    std::size_t saved = 0;
    bool some_bad = !in_step_, unwritten = false;
    for (std::int64_t i = 0; i < frames_ && readFrame(i); ++i) {
      const int wrong_salts = frame_.wrongSaltBytes(salts_);
      const bool ours = wrong_salts == 0;
      const bool follows =
          ours && frame_.isWhole() && (!in_step_ || after(frame_) == frame_.sums());
      const bool mended = ours && in_step_ && !follows && turnBack(i);
      // A whole frame that follows on nothing is the rest of a transaction that was given up.
      if (ours && in_step_ && !follows && !mended && frame_.isWhole()) break;
      // Of an older WAL both salts are others.
      const bool known = ours || (wrong_salts == 1 && frame_.isWhole());
      unwritten = unwritten || !known;
      content.frames.push_back({known ? frame_.number() : 0, pageOffsetOf(i)});
      some_bad = some_bad || !follows;
      in_step_ = follows || mended;
      if (!in_step_) continue;
      sums_ = mended ? after(frame_) : frame_.sums();
      if (!frame_.endsTransaction()) continue;
      // A power cut may keep the end of the transaction that was being written, and not all before
      // it. What another follows had been saved.
      if (std::exchange(unwritten, false)) continue;
      saved = content.frames.size();
      content.damaged = some_bad;
    }
    content.frames.resize(saved);
    return content;
  }

 private:
  static std::int64_t offsetOf(std::int64_t frame) {
    return static_cast<std::int64_t>(kWalHeaderBytes) +
           frame * static_cast<std::int64_t>(kFrameBytes);
  }
  static std::int64_t pageOffsetOf(std::int64_t frame) {
    return offsetOf(frame) + static_cast<std::int64_t>(kFrameHeaderBytes);
  }
  bool readFrame(std::int64_t number) {
    return read_(frame_.bytes.data(), kFrameBytes, offsetOf(number));
  }

  // False where it is no WAL of a catalogue. The salts of a damaged header stand in each frame.
  bool readHeader() {
    std::array<unsigned char, kWalHeaderBytes> header{};
    if (!read_(header.data(), header.size(), 0)) return false;
    constexpr std::uint32_t kWalMagic = 0x377F0682;  // and 1 where the sums are big-endian
    constexpr std::size_t kPageSizeAt = 8;
    const std::uint32_t magic = bigEndian(header.data());
    addToWalChecksum(header.data(), kWalHeaderChecksumAt, (magic & 1) != 0, sums_.s0, sums_.s1);
    in_step_ =
        (magic & ~1u) == kWalMagic && sums_ == walSumsAt(header.data() + kWalHeaderChecksumAt);
    big_endian_ = in_step_ && (magic & 1) != 0;
    if (in_step_) {
      std::copy_n(header.begin() + kHeaderSaltsAt, kSaltBytes, salts_.begin());
      return bigEndian(header.data() + kPageSizeAt) == kPageBytes;
    }
    for (std::int64_t i = 0; i < frames_ && readFrame(i); ++i) {
      if (!frame_.isWhole()) continue;
      std::copy_n(frame_.bytes.begin() + kFrameSaltsAt, kSaltBytes, salts_.begin());
      return true;
    }
    return false;
  }

  WalSums after(const Frame& frame) const { return after(frame, sums_); }
  WalSums after(const Frame& frame, WalSums sums) const {
    addToWalChecksum(frame.bytes.data(), kFrameSummedBytes, big_endian_, sums.s0, sums.s1);
    addToWalChecksum(frame.bytes.data() + kFrameHeaderBytes, kPageBytes, big_endian_, sums.s0,
                     sums.s1);
    return sums;
  }

  // What proves that this frame was saved: one bit is wrong in what its checksum covers, or, of a
  // whole page, the checksum itself, since the next frame goes on from the right one.
  bool turnBack(std::int64_t number) {
    for (std::size_t bit = 0; bit < 8 * kFrameSummedBytes; ++bit) {
      frame_.flip(bit);
      if (after(frame_) == frame_.sums() && frame_.isWhole()) return true;
      frame_.flip(bit);
    }
    if (frame_.isWhole()) {
      Frame next;
      return number + 1 < frames_ && read_(next.bytes.data(), kFrameBytes, offsetOf(number + 1)) &&
             next.wrongSaltBytes(salts_) == 0 && after(next, after(frame_)) == next.sums();
    }
    if (!frame_.endsTransaction() || ++tried_ > kMostFramesTried) return false;
    Frame turned = frame_;
    if (!turnBackOneBit(turned.page(), turned.number()) || after(turned) != turned.sums())
      return false;
    frame_ = turned;
    return true;
  }

  const ReadAt& read_;
  std::int64_t frames_;
  std::array<unsigned char, kSaltBytes> salts_{};
  bool big_endian_ = false;
  bool in_step_ = false;  ///< sums_ are those of all frames before frame_
  WalSums sums_;
  Frame frame_;
  int tried_ = 0;
};

}  // namespace

void addToWalChecksum(const unsigned char* bytes, std::size_t count, bool big_endian,
                      std::uint32_t& s0, std::uint32_t& s1) {
  for (std::size_t i = 0; i < count; i += 8) {
    std::array<std::uint32_t, 2> x{};
    std::memcpy(x.data(), bytes + i, 8);
    s0 += (big_endian ? be32toh(x[0]) : le32toh(x[0])) + s1;
    s1 += (big_endian ? be32toh(x[1]) : le32toh(x[1])) + s0;
  }
}

WalContent readWal(const ReadAt& read, std::int64_t bytes) {
  return WalReader(read, bytes).content();
}

}  // namespace ostraka::store
