// SPDX-License-Identifier: GPL-3.0-or-later
// Blood at the open ends of torn vessels: one translucent sphere at each, of a tenth of the volume
// lost there, as the legend says; all of it would hide the vessels. What of it is drug is a fainter
// shell in the drug's colour, at the same scale.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "core/scene/frame.h"

class vtkActor;
class vtkPlane;
class vtkRenderer;

namespace hepatica {

// Share of the lost volume that is drawn; the legend's words state it (legend_rows.cpp).
inline constexpr double drawn_share_of_blood = 0.1;

// Radius of the sphere for a blood loss in grams; 0 where nothing was lost.
double radius_of_pool_mm(double lost_g);

// Draws into one renderer, which must outlive it; not thread-safe.
class BleedingActor {
  public:
    explicit BleedingActor(vtkRenderer& renderer) : renderer_(renderer) {}
    ~BleedingActor();
    BleedingActor(const BleedingActor&) = delete;
    BleedingActor& operator=(const BleedingActor&) = delete;

    // Costs nothing where nothing bleeds. Returns true if the picture changed; a sphere that grew
    // or moved by less than 0.1 mm is not redrawn.
    bool update(const std::optional<TearView>& tear);
    // From the next frame on; shown by default.
    void set_visible(bool visible) { visible_ = visible; }
    // Draws only what lies on the plane's positive side; null draws all. The plane must outlive its
    // use.
    void set_clip(vtkPlane* plane);

  private:
    vtkRenderer& renderer_;
    std::vector<vtkSmartPointer<vtkActor>> pools_, clouds_;
    vtkPlane* clip_ = nullptr;
    bool visible_ = true;
};

}  // namespace hepatica
