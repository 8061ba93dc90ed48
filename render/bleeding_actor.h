// SPDX-License-Identifier: GPL-3.0-or-later
// Blood at the open ends of torn vessels: one translucent sphere at each, whose radius grows with
// the cube root of the blood lost there. Not to scale: a hundred grams would hide all vessels.
// Around it a fainter one, in the drug's colour, where drug has leaked.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "core/scene/frame.h"

class vtkActor;
class vtkRenderer;

namespace hepatica {

// Radius of the sphere for a blood loss in grams; 0 where nothing was lost.
double radius_of_pool_mm(double lost_g);

// Radius of the cloud of drug around a pool: a shell whose volume is that of the drug, to scale up
// to 8 mm thick, so that it never hides the vessels; the pool's own radius where there is none.
double radius_of_cloud_mm(double pool_mm, double drug_g);

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

  private:
    vtkRenderer& renderer_;
    std::vector<vtkSmartPointer<vtkActor>> pools_, clouds_;
};

}  // namespace hepatica
