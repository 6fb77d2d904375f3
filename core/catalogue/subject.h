#pragma once
#include "catalogue/catalogue.h"

namespace ostraka::catalogue {

/// What the objects that read and write one subject of a catalogue have in common. Make one where
/// it is needed, as in `Places(catalogue).sites()`: it is a reference to the catalogue and no more.
/// What changes something is one transaction, is saved when the call returns, and leaves rows in
/// the history that say who did it.
class Subject {
 public:
  explicit Subject(const Catalogue& catalogue)
      : catalogue_(catalogue), database_(&catalogue.database()) {}

 protected:
  std::int64_t now() const { return catalogue_.now(); }

  const Catalogue& catalogue_;
  store::Database* database_;
};

}  // namespace ostraka::catalogue
