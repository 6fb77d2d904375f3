#include "ui/viewport/sherd_scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCutter.h>
#include <vtkLineSource.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QColor>
#include <algorithm>
#include <cmath>

#include "ui/look/distance_scale.h"
#include "ui/look/state_colours.h"
#include "ui/viewport/drawn_shape.h"

namespace ostraka::ui {
namespace {

constexpr Color kClay = {186, 150, 120};  // what has no colours of its own

Color rgb(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

void paint(vtkActor& actor, const QColor& colour) {
  const double part[3] = {colour.redF(), colour.greenF(), colour.blueF()};
  actor.GetProperty()->SetColor(part[0], part[1], part[2]);
  actor.GetProperty()->SetVertexColor(part[0], part[1], part[2]);
}

}  // namespace

struct SherdScene::Actors {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderer> above;  ///< drawn over all else: a line through the sherd is to be seen
  DrawnShape front{*renderer, Shape::Surfels}, back{*renderer, Shape::Surfels};
  DrawnShape model{*renderer, Shape::Surface};
  vtkNew<vtkLineSource> line;
  vtkNew<vtkPolyDataMapper> line_mapper, outline_mapper;
  vtkNew<vtkActor> line_actor, outline_actor;
  vtkNew<vtkPlane> plane;
  vtkNew<vtkCutter> cutter;
  ShownScan front_scan, back_scan;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  vtkNew<vtkCamera> uncut;  ///< the view before the section
  bool section = false, apart = false;
  std::vector<float> front_mm, back_mm;  ///< distances; empty: none are shown
  DistanceScale scale{1};
  double ratio = 1;

  DrawnShape* shapes[3] = {&front, &back, &model};

  bool distancesShown() const { return !front_mm.empty() || !back_mm.empty(); }
  std::vector<Color> coloursOf(const ShownScan& scan, State side) const {
    const PointCloud& cloud = scan.cloud;
    const std::vector<float>& distance_mm = side == State::Front ? front_mm : back_mm;
    const Color marked = rgb(StateColours::onMatte().of(side));
    std::vector<Color> colours(cloud.size(), kClay);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (i < cloud.colors.size()) colours[i] = cloud.colors[i];
      if (!distancesShown() && i < scan.fracture.size() && scan.fracture[i] != 0)
        colours[i] = marked;
      const int point = i < scan.strip_point.size() ? scan.strip_point[i] : -1;
      if (point >= 0 && static_cast<std::size_t>(point) < distance_mm.size())
        colours[i] = rgb(scale.of(distance_mm[static_cast<std::size_t>(point)]));
    }
    return colours;
  }
  void colourSides() {
    for (DrawnShape* side : {&front, &back})
      side->setLight(distancesShown() ? Light::Flat : Light::Shaded);
    front.setColours(coloursOf(front_scan, State::Front));
    back.setColours(coloursOf(back_scan, State::Back));
  }
  void place() {
    vtkNew<vtkMatrix4x4> matrix;
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) matrix->SetElement(r, c, pose.matrix()(r, c));
    if (apart) {
      double bounds[6];
      front.data()->GetBounds(bounds);
      const double size = std::max({bounds[1] - bounds[0], bounds[3] - bounds[2], 10.0});
      matrix->SetElement(2, 3, matrix->GetElement(2, 3) - 0.45 * size);
    }
    back.setMatrix(matrix);
  }
  void cut() {
    for (DrawnShape* shape : shapes) shape->setCut(section ? plane.GetPointer() : nullptr);
    front.setBandColour(StateColours::onMatte().of(State::Front));
    back.setBandColour(StateColours::onMatte().of(State::Back));
    outline();
  }
  void outline() { outline_actor->SetVisibility(section && !model.empty()); }
};

SherdScene::SherdScene() : actors_(std::make_unique<Actors>()) {
  Actors& a = *actors_;
  a.renderer->GetActiveCamera()->ParallelProjectionOn();  // so that the scale bar is true
  const QColor matte = StateColours::matte();
  a.renderer->SetBackground(matte.redF(), matte.greenF(), matte.blueF());
  a.line_mapper->SetInputConnection(a.line->GetOutputPort());
  a.line_actor->SetMapper(a.line_mapper);
  a.line_actor->SetVisibility(0);
  a.line_actor->PickableOff();
  a.line_actor->GetProperty()->SetVertexVisibility(true);
  paint(*a.line_actor, StateColours::inkOnMatte());
  a.above->SetLayer(1);
  a.above->SetActiveCamera(a.renderer->GetActiveCamera());
  a.above->InteractiveOff();
  a.above->AddActor(a.line_actor);
  a.cutter->SetInputData(a.model.data());
  a.cutter->SetCutFunction(a.plane);
  a.outline_mapper->SetInputConnection(a.cutter->GetOutputPort());
  a.outline_mapper->ScalarVisibilityOff();
  a.outline_actor->SetMapper(a.outline_mapper);
  a.outline_actor->SetVisibility(0);
  a.outline_actor->PickableOff();
  a.outline_actor->GetProperty()->LightingOff();
  paint(*a.outline_actor, edgeColour());
  a.renderer->AddActor(a.outline_actor);
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

void SherdScene::setPixelRatio(double ratio) {
  actors_->ratio = ratio;
}

void SherdScene::clear() {
  Actors& a = *actors_;
  a.front_scan = a.back_scan = {};
  a.front_mm.clear();
  a.back_mm.clear();
  for (DrawnShape* shape : a.shapes) shape->clear();
  a.line_actor->SetVisibility(0);
  a.outline();
}

void SherdScene::setSides(const ShownScan& front, const ShownScan& back) {
  Actors& a = *actors_;
  a.front_scan = front;
  a.back_scan = back;
  a.front.setPoints(front.cloud.points, front.cloud.normals, a.coloursOf(front, State::Front));
  a.back.setPoints(back.cloud.points, back.cloud.normals, a.coloursOf(back, State::Back));
  a.place();
}

void SherdScene::setPose(const Eigen::Isometry3d& front_from_back) {
  actors_->pose = front_from_back;
  actors_->place();
}

void SherdScene::setDistances(const std::vector<float>& front_mm, const std::vector<float>& back_mm,
                              const DistanceScale& scale) {
  Actors& a = *actors_;
  const bool shown = a.distancesShown();
  a.front_mm = front_mm;
  a.back_mm = back_mm;
  a.scale = scale;
  if (shown || a.distancesShown()) a.colourSides();
}

void SherdScene::setModel(const TriangleMesh& mesh, const ShownTexture& texture) {
  clear();
  std::vector<Color> colours = mesh.colors;
  colours.resize(mesh.vertices.size(), kClay);
  actors_->model.setMesh(mesh, colours, texture);
  actors_->outline();
}

void SherdScene::setMeasure(const Eigen::Vector3d& from, const Eigen::Vector3d& to, bool shown) {
  Actors& a = *actors_;
  a.line->SetPoint1(from.x(), from.y(), from.z());
  a.line->SetPoint2(to.x(), to.y(), to.z());
  a.line_actor->SetVisibility(shown);
}

void SherdScene::setApart(bool apart) {
  actors_->apart = apart;
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
    // The plate lies level, so that the profile does, unless one looks along it anyway.
    const double level[3] = {0, 0, 1};
    const double distance = camera()->GetDistance();
    camera()->SetPosition(centre[0] + distance * right[0], centre[1] + distance * right[1],
                          centre[2] + distance * right[2]);
    camera()->SetViewUp(std::abs(right[2]) < 0.9 ? level : up);
  }
  a.section = on;
  a.cut();
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
}

void SherdScene::setMoving(bool moving) {
  for (DrawnShape* shape : actors_->shapes) shape->setMoving(moving);
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
  a.renderer->ResetCameraClippingRange();
  double range[2], right[3], up[3], away[3], normal[3];
  camera()->GetClippingRange(range);
  viewAxes(right, up, away);
  a.plane->GetNormal(normal);
  const double height = std::max(1, a.renderer->GetSize()[1]);
  FrameFacts frame;
  frame.px_per_mm = static_cast<float>(height / (2 * camera()->GetParallelScale()));
  frame.depth_per_mm = static_cast<float>(1 / (range[1] - range[0]));
  frame.pixel_ratio = static_cast<float>(a.ratio);
  frame.cut_facing = static_cast<float>(-vtkMath::Dot(normal, away));
  for (DrawnShape* shape : a.shapes) shape->setFrame(frame);
  for (vtkActor* actor : {a.line_actor.GetPointer(), a.outline_actor.GetPointer()})
    actor->GetProperty()->SetLineWidth(static_cast<float>(2.5 * a.ratio));
  setDots(*a.line_actor, static_cast<float>(7 * a.ratio));
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

ViewPose SherdScene::viewPose() const {
  Eigen::Vector3d right, up, away;
  viewAxes(right.data(), up.data(), away.data());
  ViewPose pose;
  pose.view_from_front.row(0) = right;
  pose.view_from_front.row(1) = up;
  pose.view_from_front.row(2) = -away;
  pose.half_height_mm = actors_->renderer->GetActiveCamera()->GetParallelScale();
  return pose;
}

void SherdScene::setViewPose(const ViewPose& pose) {
  const Eigen::Vector3d up = pose.view_from_front.row(1), to_viewer = pose.view_from_front.row(2);
  Eigen::Vector3d middle;
  camera()->GetFocalPoint(middle.data());
  const Eigen::Vector3d from = middle + camera()->GetDistance() * to_viewer;
  camera()->SetPosition(from.x(), from.y(), from.z());
  camera()->SetViewUp(up.x(), up.y(), up.z());
  camera()->SetParallelScale(pose.half_height_mm);
}

}  // namespace ostraka::ui
