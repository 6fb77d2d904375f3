#pragma once
#include "rendering/backdrop.h"
#include "rendering/sheet.h"
#include "rendering/table.h"
#include "vessels/gloss.h"

namespace ostraka::rendering {

/// Sheet and table as light falls on them and comes back from them.
class SheetGround final : public Ground {
 public:
  SheetGround(const SheetSurface& sheet, const TableSurface& table)
      : sheet_(sheet), table_(table) {}
  Eigen::Vector3f meanAlbedo(const Eigen::Vector2f& p) const override {
    return sheet_.holds(p) ? sheet_.meanAlbedo(p) : table_.meanAlbedo();
  }

 private:
  const SheetSurface& sheet_;
  const TableSurface& table_;
};

/// A printed sheet on a table, floor and wall beyond.
class SheetBackdrop final : public Backdrop {
 public:
  SheetBackdrop(const Scene& scene, const Lighting& lighting, const LightField& light,
                const AmbientField& ambient, const SheetSurface& sheet, const TableSurface& table);
  Eigen::Vector3f light(const Ray& ray, std::uint64_t hash) const override;
  bool even(const Ray& ray) const override;

 private:
  /// Where a ray meets the sheet as it is bent; absent beside it.
  bool onSheet(const Ray& ray, Eigen::Vector3f& p) const;
  /// Light of a place on the ground, with shadows and what it mirrors.
  Eigen::Vector3f lit(const Eigen::Vector3f& p, const Eigen::Vector3f& normal, const Ray& ray,
                      const Eigen::Vector3f& albedo, const vessels::Gloss& gloss,
                      std::uint64_t hash) const;
  Eigen::Vector3f beyond(const Ray& ray) const;

  const Scene& scene_;
  const Lighting& lighting_;
  const LightField& light_;
  const AmbientField& ambient_;
  const SheetSurface& sheet_;
  const TableSurface& table_;
  bool hard_ = false;
};

}  // namespace ostraka::rendering
