// SPDX-License-Identifier: GPL-3.0-or-later
// Blood at the open ends of torn vessels: a translucent pool at each, the larger the more has been
// lost there. Not to scale: a hundred grams would hide all vessels.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "core/scene/frame.h"

class vtkActor;
class vtkRenderer;

namespace hepatica {

// 0 where nothing was lost.
double radius_of_pool_mm(double lost_g);

// Draws into one renderer, which must outlive it; not thread-safe.
class BleedingActor {
  public:
    explicit BleedingActor(vtkRenderer& renderer) : renderer_(renderer) {}
    ~BleedingActor();
    BleedingActor(const BleedingActor&) = delete;
    BleedingActor& operator=(const BleedingActor&) = delete;

    // Costs nothing where nothing bleeds. Returns true if the picture is another now: a pool that
    // grew by less than can be seen is drawn as it was.
    bool update(const std::optional<TearView>& tear);

  private:
    vtkRenderer& renderer_;
    std::vector<vtkSmartPointer<vtkActor>> pools_;
};

}  // namespace hepatica
