#pragma once
#include <set>
#include <string>
#include <vector>

#include "archive/bag_reader.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "metadata/batch_records.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::metadata {

/// The contexts that an export of these sherds tells of: theirs, and where these are all sherds of
/// the project, those in which none was found, too. Throws Refused.
std::set<store::ContextRow> contextsOf(const catalogue::Catalogue& catalogue,
                                       const std::vector<records::SherdRecord>& sherds);

struct MetadataFile {
  std::string path, text;
};
/// What README.txt tells of an export.
struct Content {
  const std::vector<archive::BagFile>& files;     ///< so far
  const std::vector<std::string>& without_model;  ///< names of sherds
};
/// What travels beside the records: metadata/project.json (Dublin Core), metadata/places.json,
/// metadata/batches.json, metadata/vocabularies.json, context.jsonld and README.txt.
Result<std::vector<MetadataFile>> metadataOf(const catalogue::Catalogue& catalogue,
                                             const std::vector<records::SherdRecord>& sherds,
                                             const records::ProjectRecord& project,
                                             const std::string& program, const Content& exported);

/// Persons, sites, trenches, contexts, bags and batches with their photographs, scans and decisions
/// of metadata/, with their ids, and terms of vocabularies, into a catalogue that does not have
/// them yet; what is there stays as it is.
Result<ReadBatches> readMetadata(catalogue::Catalogue& catalogue, const archive::BagReader& bag,
                                 const records::Provenance& provenance);

}  // namespace ostraka::metadata
