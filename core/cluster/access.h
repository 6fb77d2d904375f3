#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "cluster/place.h"
#include "cluster/tasks.h"

namespace ostraka::cluster {

/// How this person reaches the project's cluster.
struct Access {
  std::string host;  ///< as Place::of; empty: as named before on this computer, or the project's
                     ///< own folder
  std::function<void(const std::string& host)> contacting;  ///< called before a host is contacted
};

/// The place at which the project's batches are processed; a host becomes that of `tasks`. Whoever
/// a project comes from must not decide where photographs are sent: a host is what this person
/// named, which is remembered for the project in the folder of the person's settings, and what
/// tasks.json says is only held against it. Errors: those of Place::of; UnusableInput for batches
/// that are at another place, and for a memory that cannot be read; CannotWrite.
Result<Place> reach(const catalogue::Catalogue& catalogue, const std::filesystem::path& project,
                    const Access& access, Tasks& tasks);

/// For Place::prepare: differs between projects, between computers and between the copies of a
/// project on one computer, which may all be sent to one login node. A project that is moved is
/// another one, too, so that doubt never overwrites anything. Errors: as reach.
Result<std::string> ownerOf(const catalogue::Catalogue& catalogue,
                            const std::filesystem::path& project);

}  // namespace ostraka::cluster
