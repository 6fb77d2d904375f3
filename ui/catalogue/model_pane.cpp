#include "ui/catalogue/model_pane.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>

#include "cloud/ply.h"
#include "model/model.h"
#include "texture/texture.h"
#include "ui/jobs/when_done.h"
#include "ui/look/look.h"
#include "ui/viewport/sherd_view.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/thumbnails.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

constexpr int kHeight = 240;
constexpr int kPicture = 480;
// A processor that draws alone turns so many triangles in 0.1 s; models have several times as many.
constexpr std::size_t kTriangles = 80000;
constexpr double kDeviation_mm = 0.03;  // less than a pixel of the view

struct ForView {
  TriangleMesh mesh;
  ShownTexture texture;
};
using ForViewPtr = std::shared_ptr<const ForView>;

// With its photographs where the model has them and they can be read, else in its own colours.
Result<ForViewPtr> readForView(const std::string& file) {
  if (Result<std::optional<texture::TexturedMesh>> textured = texture::openedBeside(file);
      textured && *textured) {
    texture::TexturedMesh& model = **textured;
    model.mesh.colors = texture::vertexColours(model);
    const cv::Mat3b& page = model.texture.picture;
    const QImage picture(page.data, page.cols, page.rows, static_cast<qsizetype>(page.step),
                         QImage::Format_BGR888);
    return std::make_shared<const ForView>(
        ForView{std::move(model.mesh),
                {picture.convertToFormat(QImage::Format_RGB888), std::move(model.uv)}});
  }
  Result<PlyContents> model = readPly(file);
  if (!model) return model.error();
  if (model->mesh.triangles.size() > kTriangles)
    if (Result<TriangleMesh> fewer = model::decimated(model->mesh, kDeviation_mm))
      return std::make_shared<const ForView>(ForView{std::move(*fewer), {}});
  return std::make_shared<const ForView>(ForView{std::move(model->mesh), {}});
}

}  // namespace

ModelPane::ModelPane(QWidget* parent) : QWidget(parent) {
  setObjectName("model");
  label_ = new QLabel(this);
  label_->setAlignment(Qt::AlignCenter);
  label_->setMinimumSize(1, 1);
  label_->setPalette(mattePalette());  // as the model stands on
  label_->setAutoFillBackground(true);
  label_->setAccessibleName(tr("Picture of the sherd"));
  pages_ = new QStackedWidget(this);
  pages_->addWidget(label_);
  acts_ = new QWidget(this);
  const auto button = [this](const char* name, const char* picture, const QString& text) {
    auto* made = new QToolButton(acts_);
    made->setObjectName(name);
    made->setIcon(icon(picture));
    made->setText(text);
    made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    made->setAutoRaise(true);
    return made;
  };
  section_ = button("modelSection", "section", tr("Section"));
  section_->setCheckable(true);
  section_->setToolTip(tr("Cut the model open; Shift and the wheel move the plane"));
  QToolButton* reset = button("modelReset", "again", tr("From above"));
  connect(section_, &QToolButton::toggled, this, [this](bool on) { view()->setSection(on); });
  connect(reset, &QToolButton::clicked, this, [this] { view()->resetView(); });
  large_ = button("modelLarge", "picture", tr("Large view"));
  large_->setCheckable(true);
  large_->setToolTip(tr("The model alone, as large as the page; again or Esc: beside the table"));
  connect(large_, &QToolButton::toggled, this, &ModelPane::largeChanged);
  filled(bareLayout<QHBoxLayout>(acts_), {section_, reset, large_, Part::room()});
  auto* column = bareLayout<QVBoxLayout>(this);
  column->setSpacing(0);
  filled(column, {{pages_, 1}, acts_});
  setMinimumHeight(kHeight / 2);
  clear();
}

QSize ModelPane::sizeHint() const {
  return {kHeight, kHeight};
}

SherdView* ModelPane::view() {
  if (view_ == nullptr) {
    view_ = named<SherdView>("modelView", this);
    connect(view_, &SherdView::sectionChanged, section_, &QToolButton::setChecked);
    pages_->addWidget(view_);
  }
  return view_;
}

bool ModelPane::showsModel() const {
  return view_ != nullptr && pages_->currentWidget() == view_;
}

bool ModelPane::isLarge() const {
  return large_->isChecked();
}

void ModelPane::setLarge(bool large) {
  large_->setChecked(large);
}

void ModelPane::hideActs() {
  has_acts_ = false;
}

void ModelPane::settle(const QString& why_no_model) {
  why_no_model_ = why_no_model;
  if (!why_no_model_.isEmpty()) setLarge(false);
  emit settled();
}

void ModelPane::clear() {
  delete reading_.data();
  jobs_ = nullptr;
  picture_file_.clear();
  model_file_.clear();
  picture_ = {};
  why_no_model_.clear();
  if (view_ != nullptr) view_->clear();
  pages_->setCurrentWidget(label_);
  acts_->setVisible(false);
  setLarge(false);
  showPicture();
}

void ModelPane::showSherd(JobRunner& jobs, const std::filesystem::path& project,
                          const records::SherdRecord& sherd) {
  const auto whole = [&](const std::string& path) {
    return path.empty() ? QString() : QString::fromStdString((project / path).string());
  };
  const QString picture = whole(sherd.preview_path), model = whole(sherd.model_path);
  has_batch_ = static_cast<bool>(sherd.batch);
  const QDateTime written = QFileInfo(model).lastModified();  // computed anew it has the same name
  if (jobs_ != nullptr && picture == picture_file_ && model == model_file_ && written == written_)
    return;
  delete reading_.data();
  jobs_ = &jobs;
  picture_file_ = picture;
  model_file_ = model;
  written_ = written;
  picture_ = {};
  why_no_model_.clear();
  pages_->setCurrentWidget(label_);
  acts_->setVisible(false);
  showPicture();
  if (isVisible()) fetch();
}

// First the picture, which is small, then the model.
void ModelPane::fetch() {
  if (jobs_ == nullptr || reading_ || showsModel()) return;
  if (picture_.isNull() && !picture_file_.isEmpty()) {
    const auto read = [file = picture_file_](Progress&, std::stop_token) -> Result<QImage> {
      return readScaled(file, {kPicture, kPicture});
    };
    reading_ = jobs_->start(makeJob(read), this);
    whenDone<QImage>(reading_, this, [this](const auto& image) {
      if (image && !image->isNull())
        picture_ = QPixmap::fromImage(*image);
      else
        picture_file_.clear();
      showPicture();
      fetch();
    });
    return;
  }
  if (model_file_.isEmpty())
    return settle(has_batch_
                      ? tr("No model yet: it comes when the batch of the sherd is processed.")
                      : tr("No model: the sherd belongs to no batch of photographs."));
  const auto read = [file = model_file_.toStdString()](Progress&, std::stop_token) {
    return readForView(file);
  };
  reading_ = jobs_->start(makeJob(read), this);
  whenDone<ForViewPtr>(reading_, this, [this](const auto& model) {
    if (!model) return settle(sentenceOf(model.error()));  // the picture stays
    if (!view()->hasOpenGl())
      return settle(tr("This screen has no OpenGL 3.2, so the model cannot be turned."));
    view()->showModel((*model)->mesh, (*model)->texture);
    pages_->setCurrentWidget(view_);
    acts_->setVisible(has_acts_);
    settle({});
  });
}

void ModelPane::showPicture() {
  const int size = std::max(1, std::min({label_->width(), label_->height(), kPicture}));
  const int sign = std::min(size, 3 * fontMetrics().height());  // that there is none: no picture
  label_->setPixmap(
      picture_.isNull()
          ? icon("sherd", mattePalette().color(QPalette::Text)).pixmap(sign, sign)
          : picture_.scaled(size, size, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

void ModelPane::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showPicture();
}

void ModelPane::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  fetch();
}

void ModelPane::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isLarge()) return setLarge(false);
  if (!showsModel() || !view_->turnByKey(event->key())) QWidget::keyPressEvent(event);
}

void ModelPane::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  if (view_ != nullptr) view_->setFocusRing(true);
}

void ModelPane::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  if (view_ != nullptr) view_->setFocusRing(false);
}

}  // namespace ostraka::ui
