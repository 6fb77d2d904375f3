#include "ui/viewport/drawn_shape.h"

#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QColor>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "base/median.h"
#include "cloud/level_of_detail.h"
#include "ui/look/state_colours.h"

namespace ostraka::ui {
namespace {

// A processor that draws alone turns so many 15 times a second and more.
constexpr std::size_t kCoarsePoints = 40000, kCoarseTriangles = 40000;
// Discs of 0.71 spacings close a square grid of points, scattered ones need more.
constexpr float kRadiusPerSpacing = 0.95f;
// The band of a section is as thick as a line of points needs to be to look like one.
constexpr float kBandPerSpacing = 1.5f;

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float) && sizeof(Color) == 3);
static_assert(sizeof(Eigen::Vector2f) == 2 * sizeof(float));

vtkSmartPointer<vtkFloatArray> floats(const float* values, std::size_t count, int components) {
  auto out = vtkSmartPointer<vtkFloatArray>::New();
  out->SetNumberOfComponents(components);
  out->SetNumberOfTuples(static_cast<vtkIdType>(count));
  if (count > 0)
    std::memcpy(out->GetPointer(0), values,
                count * static_cast<std::size_t>(components) * sizeof(float));
  return out;
}

vtkSmartPointer<vtkFloatArray> vectors(const std::vector<Eigen::Vector3f>& values) {
  return floats(values.empty() ? nullptr : values[0].data(), values.size(), 3);
}

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<Eigen::Vector3f>& points) {
  auto out = vtkSmartPointer<vtkPoints>::New();
  out->SetData(vectors(points));
  return out;
}

vtkSmartPointer<vtkUnsignedCharArray> coloursOf(const std::vector<Color>& colours) {
  auto out = vtkSmartPointer<vtkUnsignedCharArray>::New();
  out->SetNumberOfComponents(3);
  out->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
  if (!colours.empty()) std::memcpy(out->GetPointer(0), colours.data(), 3 * colours.size());
  return out;
}

vtkSmartPointer<vtkCellArray> onePoint(const std::vector<int>& indices) {
  auto out = vtkSmartPointer<vtkCellArray>::New();
  const std::vector<vtkIdType> ids(indices.begin(), indices.end());
  out->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  return out;
}

vtkSmartPointer<vtkCellArray> faces(const std::vector<std::array<int, 3>>& triangles) {
  auto out = vtkSmartPointer<vtkCellArray>::New();
  out->AllocateExact(static_cast<vtkIdType>(triangles.size()),
                     static_cast<vtkIdType>(3 * triangles.size()));
  for (const std::array<int, 3>& t : triangles) {
    const vtkIdType ids[3] = {t[0], t[1], t[2]};
    out->InsertNextCell(3, ids);
  }
  return out;
}

void addAttribute(vtkPolyData& data, const char* name, const std::vector<float>& values) {
  const vtkSmartPointer<vtkFloatArray> array = floats(values.data(), values.size(), 1);
  array->SetName(name);
  data.GetPointData()->AddArray(array);
}

}  // namespace

DrawnShape::DrawnShape(vtkRenderer& renderer, Shape shape) : renderer_(renderer), shape_(shape) {
  const char* attribute = shape == Shape::Surfels ? kRadius : kUnseen;
  for (Level* level : {&whole_, &coarse_}) {
    level->mapper->SetInputData(level->data);
    level->mapper->SetScalarModeToUsePointData();
    level->mapper->MapDataArrayToVertexAttribute(attribute, attribute,
                                                 vtkDataObject::FIELD_ASSOCIATION_POINTS);
    level->actor->SetMapper(level->mapper);
    setShader(*level->actor, shape);
    setSurfels(*level->actor, 1);
    setBand(*level->actor, 0, StateColours::inkOnMatte());
    renderer.AddActor(level->actor);
  }
  setLight(Light::Shaded);
  coarse_.actor->PickableOff();
  texture_->SetInputData(picture_);
  texture_->InterpolateOn();
  texture_->MipmapOn();
  texture_->SetWrap(vtkTexture::ClampToEdge);
  clear();
}

// An empty mapper remembers where its points were: the view would make room for them.
void DrawnShape::clear() {
  for (Level* level : {&whole_, &coarse_}) level->data->Initialize();
  picture_->Initialize();
  has_coarse_ = false;
  choose();
}

void DrawnShape::setPoints(const std::vector<Eigen::Vector3f>& points,
                           const std::vector<Eigen::Vector3f>& normals,
                           const std::vector<Color>& colours) {
  clear();
  if (points.empty()) return;
  std::vector<float> spacing = localSpacing(points);
  spacing_mm_ = medianOf(std::vector<float>(spacing));
  for (float& s : spacing) s *= kRadiusPerSpacing;
  whole_.data->SetPoints(pointsOf(points));
  whole_.data->GetPointData()->SetNormals(
      vectors(normals.size() == points.size()
                  ? normals
                  : std::vector<Eigen::Vector3f>(points.size(), Eigen::Vector3f::Zero())));
  addAttribute(*whole_.data, kRadius, spacing);
  setColours(colours);
  std::vector<int> all(points.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<int> some = sampledIndices(points.size(), kCoarsePoints);
  coarse_.data->ShallowCopy(whole_.data);
  whole_.data->SetVerts(onePoint(all));
  coarse_.data->SetVerts(onePoint(some));
  filled(all.size(), some.size());
}

void DrawnShape::setMesh(const TriangleMesh& mesh, const std::vector<Color>& colours,
                         const ShownTexture& texture) {
  clear();
  if (mesh.vertices.empty()) return;
  std::vector<float> unseen(mesh.vertices.size(), 0.0f);
  if (mesh.seen.size() == unseen.size())
    std::transform(mesh.seen.begin(), mesh.seen.end(), unseen.begin(),
                   [](std::uint8_t seen) { return seen == 0 ? 1.0f : 0.0f; });
  whole_.data->SetPoints(pointsOf(mesh.vertices));
  if (mesh.normals.size() == mesh.vertices.size())
    whole_.data->GetPointData()->SetNormals(vectors(mesh.normals));
  addAttribute(*whole_.data, kUnseen, unseen);
  setColours(colours);
  const std::vector<std::array<int, 3>> fewer = coarseTriangles(mesh, kCoarseTriangles);
  coarse_.data->ShallowCopy(whole_.data);
  if (texture.uv.size() == mesh.vertices.size() && !texture.picture.isNull()) setTexture(texture);
  whole_.data->SetPolys(faces(mesh.triangles));
  coarse_.data->SetPolys(faces(fewer));
  filled(mesh.triangles.size(), fewer.size());
}

// VTK counts rows from the texture's foot, so the first row at its foot leaves places as they are.
void DrawnShape::setTexture(const ShownTexture& texture) {
  const QImage rgb = texture.picture.convertToFormat(QImage::Format_RGB888);
  picture_->SetDimensions(rgb.width(), rgb.height(), 1);
  picture_->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < rgb.height(); ++y)
    std::memcpy(picture_->GetScalarPointer(0, y, 0), rgb.constScanLine(y),
                3 * static_cast<std::size_t>(rgb.width()));
  whole_.data->GetPointData()->SetTCoords(floats(texture.uv[0].data(), texture.uv.size(), 2));
  whole_.actor->SetTexture(texture_);
  setShader(*whole_.actor, shape_);
}

// On the graphics card it can only go while the context is there.
void DrawnShape::dropTexture() {
  texture_->ReleaseGraphicsResources(renderer_.GetRenderWindow());
  whole_.actor->SetTexture(nullptr);
  setShader(*whole_.actor, shape_);
}

void DrawnShape::setColours(const std::vector<Color>& colours) {
  const vtkSmartPointer<vtkUnsignedCharArray> array = coloursOf(colours);
  for (Level* level : {&whole_, &coarse_}) level->data->GetPointData()->SetScalars(array);
}

void DrawnShape::setLight(Light light) {
  for (Level* level : {&whole_, &coarse_}) ui::setLight(*level->actor, light);
}

void DrawnShape::filled(std::size_t parts, std::size_t coarse_parts) {
  has_coarse_ = coarse_parts < parts;
  const double share = static_cast<double>(coarse_parts) / static_cast<double>(parts);
  setSurfels(*coarse_.actor, static_cast<float>(1 / std::sqrt(share)));
  choose();
}

void DrawnShape::choose() {
  const bool coarse = moving_ && has_coarse_;
  whole_.actor->SetVisibility(visible_ && !coarse && !empty());
  coarse_.actor->SetVisibility(visible_ && coarse && !empty());
}

void DrawnShape::setVisible(bool visible) {
  visible_ = visible;
  choose();
}

void DrawnShape::setMatrix(vtkMatrix4x4* matrix) {
  for (Level* level : {&whole_, &coarse_}) level->actor->SetUserMatrix(matrix);
}

void DrawnShape::setCut(vtkPlane* plane) {
  for (Level* level : {&whole_, &coarse_}) {
    level->mapper->RemoveAllClippingPlanes();
    if (plane != nullptr) level->mapper->AddClippingPlane(plane);
    setShader(*level->actor, shape_);
  }
}

void DrawnShape::setBandColour(const QColor& colour) {
  for (Level* level : {&whole_, &coarse_})
    setBand(*level->actor, kBandPerSpacing * spacing_mm_, colour);
}

void DrawnShape::setMoving(bool moving) {
  moving_ = moving;
  choose();
}

void DrawnShape::setFrame(const FrameFacts& frame) {
  if (picture_->GetNumberOfPoints() == 0 && whole_.actor->GetTexture() != nullptr) dropTexture();
  for (Level* level : {&whole_, &coarse_}) ui::setFrame(*level->actor, frame);
}

}  // namespace ostraka::ui
