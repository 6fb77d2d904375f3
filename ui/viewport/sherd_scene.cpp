#include "ui/viewport/sherd_scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCutter.h>
#include <vtkFloatArray.h>
#include <vtkLineSource.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace ostraka::ui {
namespace {

constexpr Rgb kClay = {178, 132, 100};    // scans without colours
constexpr Rgb kUnseen = {128, 128, 140};  // filled in: no camera saw it

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<Eigen::Vector3f>& points) {
  auto out = vtkSmartPointer<vtkPoints>::New();
  out->SetDataTypeToFloat();
  out->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    out->SetPoint(static_cast<vtkIdType>(i), points[i].x(), points[i].y(), points[i].z());
  return out;
}

vtkSmartPointer<vtkFloatArray> normalsOf(const std::vector<Eigen::Vector3f>& normals) {
  auto out = vtkSmartPointer<vtkFloatArray>::New();
  out->SetNumberOfComponents(3);
  out->SetNumberOfTuples(static_cast<vtkIdType>(normals.size()));
  for (std::size_t i = 0; i < normals.size(); ++i)
    out->SetTuple3(static_cast<vtkIdType>(i), normals[i].x(), normals[i].y(), normals[i].z());
  return out;
}

vtkSmartPointer<vtkUnsignedCharArray> coloursOf(const std::vector<Rgb>& colours) {
  auto out = vtkSmartPointer<vtkUnsignedCharArray>::New();
  out->SetNumberOfComponents(3);
  out->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
  for (std::size_t i = 0; i < colours.size(); ++i)
    out->SetTypedTuple(static_cast<vtkIdType>(i), colours[i].data());
  return out;
}

vtkSmartPointer<vtkCellArray> vertsOf(std::size_t count) {
  auto out = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t i = 0; i < count; ++i) {
    const vtkIdType id = static_cast<vtkIdType>(i);
    out->InsertNextCell(1, &id);
  }
  return out;
}

constexpr double kSlice_mm = 2;  // some points of each scan along the whole profile

double part(std::uint8_t value) {
  return value / 255.0;
}

/// Something drawn: its data, how, and where.
struct Drawn {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  Drawn() {
    mapper->SetInputData(data);
    mapper->SetScalarModeToUsePointData();
    actor->SetMapper(mapper);
  }
  // An empty mapper remembers where its points were: the view would make room for them.
  void empty() {
    data->Initialize();
    actor->SetUseBounds(false);
  }
  void filled() {
    data->Modified();
    actor->SetUseBounds(true);
  }
};

}  // namespace

struct SherdScene::Actors {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderer> above;  ///< drawn over all else: a line through the sherd is to be seen
  Drawn front, back, rim, model;
  vtkNew<vtkLineSource> line;
  vtkNew<vtkPolyDataMapper> line_mapper, cut_mapper;
  vtkNew<vtkActor> line_actor, cut_actor;
  vtkNew<vtkPlane> plane, behind;  ///< the cut, and where the slice of the scans ends
  vtkNew<vtkCutter> cutter;
  Look look;
  PointCloud front_cloud, back_cloud;
  std::vector<std::uint8_t> front_rim, back_rim;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  vtkNew<vtkCamera> uncut;  ///< the view before the section
  bool section = false, apart = false;
  bool gaps_shown = false;  ///< the rim shows its gaps: no other colours beside them
  double ratio = 1;

  void fill(Drawn& drawn, const PointCloud& cloud, const std::vector<std::uint8_t>& rim_marks,
            const Rgb& rim_colour) {
    drawn.empty();
    if (cloud.empty()) return;
    drawn.data->SetPoints(pointsOf(cloud.points));
    drawn.data->SetVerts(vertsOf(cloud.size()));
    if (cloud.hasNormals()) drawn.data->GetPointData()->SetNormals(normalsOf(cloud.normals));
    std::vector<Rgb> colours(cloud.size(), kClay);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (i < cloud.colors.size()) colours[i] = cloud.colors[i];
      if (i < rim_marks.size() && rim_marks[i] != 0) colours[i] = gaps_shown ? kUnseen : rim_colour;
    }
    drawn.data->GetPointData()->SetScalars(coloursOf(colours));
    drawn.filled();
  }
  void colour() {
    fill(front, front_cloud, front_rim, look.front_rim);
    fill(back, back_cloud, back_rim, look.back_rim);
  }
  void place() {
    vtkNew<vtkMatrix4x4> matrix;
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) matrix->SetElement(r, c, pose.matrix()(r, c));
    if (apart) {
      double bounds[6];
      front.data->GetBounds(bounds);
      const double size = std::max({bounds[1] - bounds[0], bounds[3] - bounds[2], 10.0});
      matrix->SetElement(2, 3, matrix->GetElement(2, 3) - 0.45 * size);
    }
    back.actor->SetUserMatrix(matrix);
  }
  // The scans are open: what lies far behind the cut would hide their profile.
  void slice() {
    double origin[3], normal[3];
    plane->GetOrigin(origin);
    plane->GetNormal(normal);
    for (int k = 0; k < 3; ++k) origin[k] += kSlice_mm * normal[k];
    behind->SetOrigin(origin);
    behind->SetNormal(-normal[0], -normal[1], -normal[2]);
  }
  void clip() {
    for (vtkPolyDataMapper* mapper : {front.mapper.GetPointer(), back.mapper.GetPointer(),
                                      rim.mapper.GetPointer(), model.mapper.GetPointer()}) {
      mapper->RemoveAllClippingPlanes();
      if (section) mapper->AddClippingPlane(plane);
      if (section && mapper != model.mapper.GetPointer()) mapper->AddClippingPlane(behind);
    }
    cut_actor->SetVisibility(section && model.data->GetNumberOfPoints() > 0);
  }
};

SherdScene::SherdScene() : actors_(std::make_unique<Actors>()) {
  Actors& a = *actors_;
  a.renderer->GetActiveCamera()->ParallelProjectionOn();  // so that the scale bar is true
  for (Drawn* drawn : {&a.front, &a.back, &a.rim, &a.model}) {
    drawn->actor->GetProperty()->SetInterpolationToGouraud();
    drawn->actor->GetProperty()->SetAmbient(0.35);
    drawn->actor->GetProperty()->SetDiffuse(0.75);
    a.renderer->AddActor(drawn->actor);
  }
  a.rim.actor->GetProperty()->LightingOff();
  a.line_mapper->SetInputConnection(a.line->GetOutputPort());
  a.line_actor->SetMapper(a.line_mapper);
  a.line_actor->SetVisibility(0);
  a.line_actor->PickableOff();
  a.line_actor->GetProperty()->SetVertexVisibility(true);
  a.above->SetLayer(1);
  a.above->SetActiveCamera(a.renderer->GetActiveCamera());
  a.above->InteractiveOff();
  a.above->AddActor(a.line_actor);
  a.cutter->SetInputData(a.model.data);
  a.cutter->SetCutFunction(a.plane);
  a.cut_mapper->SetInputConnection(a.cutter->GetOutputPort());
  a.cut_mapper->ScalarVisibilityOff();
  a.cut_actor->SetMapper(a.cut_mapper);
  a.cut_actor->SetVisibility(0);
  a.cut_actor->PickableOff();
  a.renderer->AddActor(a.cut_actor);
}

SherdScene::~SherdScene() = default;

vtkRenderer* SherdScene::renderer() {
  return actors_->renderer;
}

vtkRenderer* SherdScene::above() {
  return actors_->above;
}

vtkCamera* SherdScene::camera() {
  return actors_->renderer->GetActiveCamera();
}

void SherdScene::setLook(const Look& look) {
  Actors& a = *actors_;
  a.look = look;
  a.renderer->SetBackground(part(look.background[0]), part(look.background[1]),
                            part(look.background[2]));
  for (vtkActor* actor : {a.line_actor.GetPointer(), a.cut_actor.GetPointer()})
    actor->GetProperty()->SetColor(part(look.text[0]), part(look.text[1]), part(look.text[2]));
  a.line_actor->GetProperty()->SetVertexColor(part(look.text[0]), part(look.text[1]),
                                              part(look.text[2]));
  a.colour();
}

void SherdScene::setPixelRatio(double ratio) {
  actors_->ratio = ratio;
}

void SherdScene::clear() {
  Actors& a = *actors_;
  a.front_cloud = a.back_cloud = {};
  for (Drawn* drawn : {&a.front, &a.back, &a.rim, &a.model}) drawn->empty();
  a.line_actor->SetVisibility(0);
  a.clip();
}

void SherdScene::setFront(const PointCloud& cloud, const std::vector<std::uint8_t>& rim) {
  Actors& a = *actors_;
  a.front_cloud = cloud;
  a.front_rim = rim;
  a.fill(a.front, cloud, rim, a.look.front_rim);
  a.place();
}

void SherdScene::setBack(const PointCloud& cloud, const std::vector<std::uint8_t>& rim) {
  Actors& a = *actors_;
  a.back_cloud = cloud;
  a.back_rim = rim;
  a.fill(a.back, cloud, rim, a.look.back_rim);
}

void SherdScene::setPose(const Eigen::Isometry3d& front_from_back) {
  actors_->pose = front_from_back;
  actors_->place();
}

void SherdScene::setRim(const std::vector<Eigen::Vector3f>& points,
                        const std::vector<Rgb>& colours) {
  Actors& a = *actors_;
  a.rim.empty();
  if (a.gaps_shown == points.empty()) {
    a.gaps_shown = !points.empty();
    a.colour();
  }
  if (points.empty()) return;
  a.rim.data->SetPoints(pointsOf(points));
  a.rim.data->SetVerts(vertsOf(points.size()));
  a.rim.data->GetPointData()->SetScalars(coloursOf(colours));
  a.rim.filled();
}

void SherdScene::setModel(const TriangleMesh& mesh) {
  Actors& a = *actors_;
  clear();
  a.model.data->SetPoints(pointsOf(mesh.vertices));
  vtkNew<vtkCellArray> faces;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const vtkIdType ids[3] = {t[0], t[1], t[2]};
    faces->InsertNextCell(3, ids);
  }
  a.model.data->SetPolys(faces);
  if (mesh.normals.size() == mesh.vertices.size())
    a.model.data->GetPointData()->SetNormals(normalsOf(mesh.normals));
  std::vector<Rgb> colours(mesh.vertices.size(), kClay);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (i < mesh.colors.size()) colours[i] = mesh.colors[i];
    if (i < mesh.seen.size() && mesh.seen[i] == 0) colours[i] = kUnseen;
  }
  a.model.data->GetPointData()->SetScalars(coloursOf(colours));
  a.model.filled();
  a.clip();
}

void SherdScene::setMeasure(const Eigen::Vector3d& from, const Eigen::Vector3d& to, bool shown) {
  Actors& a = *actors_;
  a.line->SetPoint1(from.x(), from.y(), from.z());
  a.line->SetPoint2(to.x(), to.y(), to.z());
  a.line_actor->SetVisibility(shown);
}

void SherdScene::setApart(bool apart) {
  actors_->apart = apart;
  actors_->rim.actor->SetVisibility(!apart);
  actors_->place();
}

void SherdScene::setSection(bool on) {
  Actors& a = *actors_;
  if (a.section && !on) camera()->DeepCopy(a.uncut);
  if (on && !a.section) {
    a.uncut->DeepCopy(camera());
    double right[3], up[3], away[3], centre[3];
    viewAxes(right, up, away);
    camera()->GetFocalPoint(centre);
    a.plane->SetOrigin(centre);
    a.plane->SetNormal(-right[0], -right[1], -right[2]);
    a.slice();
    // The plate lies level, so that the profile does, unless one looks along it anyway.
    const double level[3] = {0, 0, 1};
    const double distance = camera()->GetDistance();
    camera()->SetPosition(centre[0] + distance * right[0], centre[1] + distance * right[1],
                          centre[2] + distance * right[2]);
    camera()->SetViewUp(std::abs(right[2]) < 0.9 ? level : up);
  }
  a.section = on;
  a.clip();
}

bool SherdScene::hasSection() const {
  return actors_->section;
}

void SherdScene::moveSection(double mm) {
  double origin[3], normal[3];
  actors_->plane->GetOrigin(origin);
  actors_->plane->GetNormal(normal);
  for (int k = 0; k < 3; ++k) origin[k] -= mm * normal[k];
  actors_->plane->SetOrigin(origin);
  actors_->slice();
}

void SherdScene::resetView() {
  vtkCamera* view = camera();
  view->SetFocalPoint(0, 0, 0);
  view->SetPosition(0.35, -1, 1.2);
  view->SetViewUp(0, 0, 1);
  fitView();
}

void SherdScene::fitView() {
  actors_->renderer->ResetCamera();
  camera()->Zoom(1.2);  // VTK leaves room for a sphere; sherds are flat
}

void SherdScene::prepare() {
  Actors& a = *actors_;
  // Points as large as their spacing on the screen, so that faces look closed.
  const double height = std::max(1, a.renderer->GetSize()[1]);
  const double px_per_mm = height / (2 * camera()->GetParallelScale());
  const double size = std::clamp(0.55 * px_per_mm, 2.0 * a.ratio, 9.0 * a.ratio);
  a.front.actor->GetProperty()->SetPointSize(static_cast<float>(size));
  a.back.actor->GetProperty()->SetPointSize(static_cast<float>(size));
  a.rim.actor->GetProperty()->SetPointSize(static_cast<float>(size + a.ratio));
  for (vtkActor* actor : {a.line_actor.GetPointer(), a.cut_actor.GetPointer()})
    actor->GetProperty()->SetLineWidth(static_cast<float>(2.5 * a.ratio));
  a.line_actor->GetProperty()->SetPointSize(static_cast<float>(7 * a.ratio));
  a.renderer->ResetCameraClippingRange();
}

void SherdScene::viewAxes(double right[3], double up[3], double away[3]) const {
  vtkCamera* view = actors_->renderer->GetActiveCamera();
  view->GetDirectionOfProjection(away);
  view->GetViewUp(up);
  vtkMath::Cross(away, up, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, away, up);
  vtkMath::Normalize(up);
}

}  // namespace ostraka::ui
