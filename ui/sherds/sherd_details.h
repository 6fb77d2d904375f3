#pragma once
#include <QHash>
#include <QPointer>
#include <QScrollArea>
#include <filesystem>

#include "catalogue/catalogue.h"
#include "colour/munsell_proposals.h"
#include "records/sherd.h"
#include "ui/frame/term_words.h"
#include "ui/sherds/unsaved_values.h"

class QAction;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTreeWidget;
class QVBoxLayout;

namespace ostraka::ui {

class JobHandle;
class JobRunner;
class MunsellLine;

/// One sherd: number, fields with their vocabularies, custom fields, measures with where
/// they come from, history, files. It shows and asks; who saves is told by signals.
class SherdDetails final : public QScrollArea {
  Q_OBJECT

 public:
  explicit SherdDetails(QWidget* parent = nullptr);

  /// Which terms a field offers, and custom fields. Call after either changed.
  void setVocabularies(const catalogue::Catalogue& catalogue);
  void showSherd(const catalogue::Catalogue& catalogue, const std::filesystem::path& project,
                 store::SherdRow sherd, JobRunner& jobs);
  void clear();
  store::SherdRow sherd() const { return sherd_; }
  /// The cursor into the first field that is empty, or into this one.
  void edit(const std::string& field = {});
  /// What was typed stays at its sherd until it is saved, whatever is shown meanwhile: it was
  /// refused, the disk was full, or the catalogue busy.
  void keepUnsaved(const QString& field, const QString& value);
  void forgetUnsaved(const QString& field);   ///< it is being saved
  void forgetUnsaved() { unsaved_.clear(); }  ///< of all sherds: another project
  const UnsavedValues& unsaved() const { return unsaved_; }
  /// Saves nothing before a person says so: confirmed().
  void ask(const QString& field, const QString& value, const QString& question, const QString& act);
  /// At the foot, which moves no field, with a mark in a field that is typed: what was wrong; with
  /// the picture of the sherd in the way.
  void showRefusal(const std::string& field, const QString& sentence, const QString& other,
                   const QString& picture);

 signals:
  /// field "place": site, trench and context, a line each.
  void edited(const QString& field, const QString& value);
  void numberWanted();
  void numberingWanted();  ///< its settings: no number can be proposed
  void confirmed(const QString& field, const QString& value);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildLayout();
  QWidget* buildNumberActs();
  void buildRefusal();
  void addPlace();
  void addProposal(const std::string& field);
  void offerProposals(const colour::MunsellProposals& proposals,
                      const records::SherdRecord& sherd);
  void readProposals(const std::filesystem::path& project, const records::SherdRecord& sherd,
                     JobRunner& jobs);
  void setCustomFields(const std::vector<std::string>& fields);
  QWidget* editorFor(const std::string& field, records::FieldKind kind);
  void setText(const std::string& field, const QString& text);
  void put(const QString& field, const QString& text);
  bool isTyping(const QString& field) const;  ///< a person, who has not left it yet
  void keepTyped();
  void showUnsaved();
  void placeRefusal(const std::string& field, const QString& sentence, const QString& other,
                    const QString& picture);
  void fitRefusal();
  void hideRefusal();
  void showNumberActs(const catalogue::Catalogue& catalogue, const records::SherdRecord& sherd);
  void addTables(QVBoxLayout& column);
  void showTables(const catalogue::Catalogue& catalogue, const std::filesystem::path& project,
                  const records::SherdRecord& sherd);
  void clearTables();
  void showMeasures(const catalogue::Catalogue& catalogue, const records::SherdRecord& sherd);
  void showHistory(const catalogue::Catalogue& catalogue);
  void showFiles(const catalogue::Catalogue& catalogue, const std::filesystem::path& project);

  store::SherdRow sherd_;
  QLabel* number_ = nullptr;
  QStackedWidget* number_acts_ = nullptr;  ///< one is there at most; its place always
  QPushButton* give_number_ = nullptr;
  QLabel* why_no_number_ = nullptr;
  QFormLayout* form_ = nullptr;
  QComboBox* place_ = nullptr;
  QHash<QString, QWidget*> editors_;
  QHash<QString, MunsellLine*> proposals_;  ///< below their fields
  QPointer<JobHandle> reading_;             ///< what is proposed for the sherd
  std::vector<std::string> custom_fields_;  ///< that have a row
  TermWords words_;
  QHash<QString, QString> shown_;  ///< what the catalogue says
  QHash<QString, QString> put_;    ///< into the lines; what is other is typed
  UnsavedValues unsaved_;
  QWidget* refusal_ = nullptr;
  QPointer<QAction> refused_;  ///< the mark in the field that it is about
  QScrollArea* told_ = nullptr;  ///< as much of it as half the room holds
  QLabel* refusal_text_ = nullptr;
  QLabel* refusal_picture_ = nullptr;
  QPushButton* confirm_ = nullptr;
  QString asked_field_;  ///< that confirm_ saves
  QTreeWidget* measures_ = nullptr;
  QTreeWidget* history_ = nullptr;
  QTreeWidget* files_ = nullptr;
};

}  // namespace ostraka::ui
