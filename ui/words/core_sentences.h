#pragma once
#include <QCoreApplication>
#include <span>
#include <vector>

namespace ostraka::ui {

using Sentences = std::span<const char* const>;

/// What core says to a person, as patterns in English, for Qt Linguist; one list a folder of core.
/// A place (%1 to %9) stands for a value, which may be a sentence or a phrase of these lists
/// itself. Tests see to it that they stand in core word for word.
class CoreSentences {
  Q_DECLARE_TR_FUNCTIONS(ostraka::Error)

 public:
  static std::vector<Sentences> all();

 private:
  static Sentences ofBase();
  static Sentences ofCapture();
  static Sentences ofCatalogue();
  static Sentences ofDrawing();
  static Sentences ofExchange();
  static Sentences ofMask();
  static Sentences ofModel();
  static Sentences ofPairing();
  static Sentences ofPipeline();
  static Sentences ofRegistration();
  static Sentences ofRig();
  static Sentences ofScan();
  static Sentences ofStereo();
  static Sentences ofVirtualrig();
};

}  // namespace ostraka::ui
