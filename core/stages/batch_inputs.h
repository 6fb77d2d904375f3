#pragma once
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::stages {

/// All that is read from a batch, and the network for its masks, by their contents when a run
/// began. A run reads the files again and again for hours, so what it makes of them is what the
/// hashes say only while they stay the same.
class BatchInputs {
 public:
  /// network: a laboratory's own; empty: none.
  BatchInputs(const batch::Batch& batch, int threads, const std::filesystem::path& network = {});

  /// Names (relative to the batch) and SHA-256; of the batch alone.
  const nlohmann::ordered_json& hashes() const { return hashes_; }
  const std::string& networkHash() const { return network_hash_; }  ///< SHA-256; empty: none
  /// Error: UnusableInput, of the file that is not what it was. Only what was written to since is
  /// read again.
  Result<void> checkUnchanged() const;

 private:
  /// What a file system notes of a file; another value does not yet mean other contents.
  struct State {
    std::uint64_t device = 0, inode = 0;
    std::int64_t bytes = -1, changed_ns = 0, written_ns = 0;
    bool operator==(const State&) const = default;
  };
  struct Input {
    std::filesystem::path file;
    State state;  ///< before it was read
    std::string hash;
  };
  static State stateOf(const std::filesystem::path& file);
  static std::string hashOf(const std::filesystem::path& file);

  std::vector<Input> inputs_;
  std::string network_hash_;
  nlohmann::ordered_json hashes_ = nlohmann::ordered_json::object();
};

}  // namespace ostraka::stages
