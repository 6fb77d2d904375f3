#pragma once
class QColor;
class vtkActor;

namespace ostraka::ui {

enum class Shape {
  Surfels,  ///< points as discs that lie in the surface, each as wide as the cloud is sparse there
  Surface,  ///< triangles
};
enum class Light {
  Shaded,
  Flat,  ///< colours that mean a number are seen as they are in the legend
};

/// What the shaders must know of a frame. Projections are parallel, so it holds everywhere in it.
struct FrameFacts {
  float px_per_mm = 1;
  float depth_per_mm = 0;  ///< of the depth buffer's 0 to 1
  float pixel_ratio = 1;
  float cut_facing = 0;  ///< the cut's normal along the line to the viewer; negative: he looks in
};

/// Arrays of the points that the shaders read.
inline constexpr const char* kRadius = "radius";  ///< of surfels, mm
inline constexpr const char* kUnseen = "unseen";  ///< of surfaces: 1 where nobody saw them

QColor capColour();   ///< of what a section cuts through; set off from all that lies beyond
QColor edgeColour();  ///< its outline

/// Draws the actor with the light of all models: key from the upper left, fill from the right, rim
/// from behind, fixed to the viewer, so that no side is black. What lies inside is darker; while it
/// is cut (by the mapper's first clipping plane), the inside has the flat tone of a cap, and of
/// surfels those near the cut are drawn as a band with an outline. A surface with a texture has its
/// colours in place of the points'. To be called again when the plane or the texture comes or goes.
void setShader(vtkActor& actor, Shape shape);
void setFrame(vtkActor& actor, const FrameFacts& frame);
/// growth: how much wider surfels are than their radius, since others are left out.
void setSurfels(vtkActor& actor, float growth);
void setLight(vtkActor& actor, Light light);
/// Surfels up to this far behind the cut belong to the band.
void setBand(vtkActor& actor, float width_mm, const QColor& colour);
/// For lines with round ends: while shaders set the size of points, these must too.
void setDots(vtkActor& actor, float size_px);

}  // namespace ostraka::ui
