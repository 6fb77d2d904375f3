#include "ui/viewport/shading.h"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <QColor>
#include <string>

#include "ui/look/distance_scale.h"
#include "ui/look/state_colours.h"

namespace ostraka::ui {
namespace {

constexpr QRgb kEdge = 0xff141312;

// Directions towards the lights, seen by the viewer: x right, y up, z to him. cutDepth: the line of
// sight meets the cut nearer to the viewer than a fragment that lies so far behind it.
constexpr const char* kCommon = R"(
float lightOn(vec3 n) {
  float key = max(dot(n, normalize(vec3(-0.50, 0.60, 0.62))), 0.0);
  float fill = max(dot(n, normalize(vec3(0.75, -0.20, 0.60))), 0.0);
  float rim = (1.0 - n.z) * (1.0 - n.z) * (0.5 + 0.5 * n.y);
  return 0.24 + 0.68 * key + 0.26 * fill + 0.14 * rim;
}
#ifdef CUT
float cutDepth(float behind_mm) {
  return gl_FragCoord.z - (cutFacing < -0.05 ? depthPerMm * behind_mm / -cutFacing : 0.0);
}
#endif
)";

constexpr const char* kSurfelVertexNames = R"(//VTK::Normal::Dec
in float radius;
out float radiusVSOutput;
out float widthVSOutput;
)";
constexpr const char* kSurfelVertex = R"(//VTK::PositionVC::Impl
  widthVSOutput = max(2.0 * radius * growth * pxPerMm, 2.0 * pixelRatio);
  radiusVSOutput = 0.5 * widthVSOutput / pxPerMm;
  gl_PointSize = widthVSOutput;
)";
constexpr const char* kSurfelNames = R"(
in float radiusVSOutput;
in float widthVSOutput;
)";
// A surfel is a disc in its plane, but in depth hollow like a bowl: of all that overlap the nearest
// owns a pixel, and dense clouds show no pepper of what lies just below. Of two or three pixels it
// is a square that faces the viewer. Near the cut all face him, and their borders lie below all
// middles, so that only the outline of the whole band is seen. Flat ones lie on the shaded ones.
constexpr const char* kSurfelNormal = R"(
  vec3 n = normalVCVSOutput;
  float certain = length(n);
  n = certain > 0.5 ? n / certain : vec3(0.0, 0.0, 1.0);
  bool inside = n.z < 0.0;
  if (inside) n = -n;
  vec2 d = vec2(2.0 * gl_PointCoord.x - 1.0, 1.0 - 2.0 * gl_PointCoord.y);
  float rise = 0.0;
  if (widthVSOutput > 4.0 * pixelRatio) rise = -dot(n.xy, d) / max(n.z, 0.4);
  bool inBand = false;
#ifdef CUT
  inBand = clipDistancesVSOutput[0] < bandMm;
  if (inBand) rise = 0.0;
#endif
  float away = dot(d, d) + rise * rise;
  if (away > 1.0 && widthVSOutput > 3.0 * pixelRatio) discard;
  float lift = 1.5 * (1.0 - lit) + rise - 0.5 * away;
  gl_FragDepth = gl_FragCoord.z - depthPerMm * radiusVSOutput * lift;
#ifdef CUT
  bool border = away > 0.45 && widthVSOutput > 5.0 * pixelRatio;
  if (inBand)
    gl_FragDepth = cutDepth(clipDistancesVSOutput[0]) - depthPerMm * bandMm * (border ? 1.0 : 2.0);
#endif
)";
constexpr const char* kSurfelColour = R"(
  vec3 shown = mix(vertexColorVSOutput.rgb, vertexColorVSOutput.rgb * lightOn(n), lit);
#ifdef CUT
  if (inside) shown = capColour;
  if (inBand) shown = border ? edgeColour : bandColour;
#else
  if (inside) shown = mix(matteColour, shown, 0.45);
#endif
  gl_FragData[0] = vec4(shown, 1.0);
)";

constexpr const char* kSurfaceVertexNames = R"(//VTK::Normal::Dec
in float unseen;
out float unseenVSOutput;
)";
constexpr const char* kSurfaceVertex = R"(//VTK::PositionVC::Impl
  unseenVSOutput = unseen;
)";
constexpr const char* kSurfaceNames = R"(//VTK::Normal::Dec
in float unseenVSOutput;
)";
// Where a closed surface is cut, one sees its inside, and nowhere else: that is the cap. It lies as
// deep as the inside, so that an outer face that is nearer hides it. The names of the texture and
// of the place on it are VTK's.
constexpr const char* kSurfaceColour = R"(
#ifdef TEXTURED
  vec3 own = texture(actortexture, tcoordVCVSOutput).rgb;
#else
  vec3 own = vertexColorVSOutput.rgb;
#endif
  float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 8.0 * pixelRatio);
  if (unseenVSOutput > 0.5) own = stripe < 4.5 * pixelRatio ? unseenColour : 0.35 * own;
  vec3 shown = own * lightOn(normalVCVSOutput);
#ifdef CUT
  if (!gl_FrontFacing) shown = capColour;
#else
  if (!gl_FrontFacing) shown = mix(matteColour, shown, 0.45);
#endif
  gl_FragData[0] = vec4(shown, 1.0);
)";

void setColour(vtkUniforms& uniforms, const char* name, const QColor& colour) {
  const float values[3] = {colour.redF(), colour.greenF(), colour.blueF()};
  uniforms.SetUniform3f(name, values);
}

vtkUniforms& vertexUniforms(vtkActor& actor) {
  return *actor.GetShaderProperty()->GetVertexCustomUniforms();
}

vtkUniforms& pixelUniforms(vtkActor& actor) {
  return *actor.GetShaderProperty()->GetFragmentCustomUniforms();
}

}  // namespace

// Cold, as no clay is, and paler than the blue of a front.
QColor capColour() {
  const QColor cold = StateColours::onMatte().of(State::Selected);
  return QColor::fromRgb(mixed(cold, StateColours::inkOnMatte(), 0.5).rgb());
}

QColor edgeColour() {
  return QColor::fromRgb(kEdge);
}

void setShader(vtkActor& actor, Shape shape) {
  vtkShaderProperty& shaders = *actor.GetShaderProperty();
  shaders.ClearAllShaderReplacements();
  const auto vertex = [&](const char* at, const std::string& code) {
    shaders.AddVertexShaderReplacement(at, true, code, false);
  };
  const auto pixel = [&](const char* at, const std::string& code) {
    shaders.AddFragmentShaderReplacement(at, true, code, false);
  };
  const bool cut = actor.GetMapper()->GetNumberOfClippingPlanes() > 0;
  const bool textured = actor.GetTexture() != nullptr;
  const std::string common =
      std::string(cut ? "#define CUT\n" : "") + (textured ? "#define TEXTURED\n" : "") + kCommon;
  const bool surfels = shape == Shape::Surfels;
  vertex("//VTK::Normal::Dec", surfels ? kSurfelVertexNames : kSurfaceVertexNames);
  vertex("//VTK::PositionVC::Impl", surfels ? kSurfelVertex : kSurfaceVertex);
  if (surfels) {
    pixel("//VTK::Normal::Dec", std::string("in vec3 normalVCVSOutput;") + kSurfelNames + common);
    pixel("//VTK::Normal::Impl", kSurfelNormal);
    pixel("//VTK::Light::Impl", kSurfelColour);
  } else {
    pixel("//VTK::Normal::Dec", kSurfaceNames + common);
    pixel("//VTK::Light::Impl", kSurfaceColour);
    pixel("//VTK::TCoord::Impl", "");  // VTK would multiply what is shown with the texture
  }
  vtkUniforms& uniforms = pixelUniforms(actor);
  setColour(uniforms, "capColour", capColour());
  setColour(uniforms, "edgeColour", edgeColour());
  setColour(uniforms, "matteColour", StateColours::matte());
  setColour(uniforms, "unseenColour", DistanceScale::notSeen());
  setFrame(actor, {});
}

void setFrame(vtkActor& actor, const FrameFacts& frame) {
  vtkUniforms& vertex = vertexUniforms(actor);
  vertex.SetUniformf("pxPerMm", frame.px_per_mm);
  vertex.SetUniformf("pixelRatio", frame.pixel_ratio);
  vtkUniforms& pixel = pixelUniforms(actor);
  pixel.SetUniformf("depthPerMm", frame.depth_per_mm);
  pixel.SetUniformf("pixelRatio", frame.pixel_ratio);
  pixel.SetUniformf("cutFacing", frame.cut_facing);
}

void setSurfels(vtkActor& actor, float growth) {
  vertexUniforms(actor).SetUniformf("growth", growth);
}

void setLight(vtkActor& actor, Light light) {
  pixelUniforms(actor).SetUniformf("lit", light == Light::Shaded ? 1.0f : 0.0f);
}

void setBand(vtkActor& actor, float width_mm, const QColor& colour) {
  pixelUniforms(actor).SetUniformf("bandMm", width_mm);
  setColour(pixelUniforms(actor), "bandColour", colour);
}

void setDots(vtkActor& actor, float size_px) {
  vtkShaderProperty& shaders = *actor.GetShaderProperty();
  if (shaders.GetNumberOfShaderReplacements() == 0)
    shaders.AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
                                       "//VTK::PositionVC::Impl\n  gl_PointSize = dotSize;\n",
                                       false);
  vertexUniforms(actor).SetUniformf("dotSize", size_px);
}

}  // namespace ostraka::ui
