// SPDX-License-Identifier: GPL-3.0-or-later
// What of the patient stands in the way of vessels and tools: tumours, which nothing enters, as
// solid as they are, and the liver's wall, which only holds what is in it, as faint as an organ.
#pragma once

#include <vtkSmartPointer.h>

#include <memory>

#include "core/deform/body/obstacles.h"
#include "render/ghost_actor.h"

class vtkRenderer;
class vtkPolyDataMapper;

namespace hepatica {

// Draws into one renderer, which must outlive it; not thread-safe.
class ObstacleActors {
  public:
    explicit ObstacleActors(vtkRenderer& renderer);
    ~ObstacleActors();
    ObstacleActors(const ObstacleActors&) = delete;
    ObstacleActors& operator=(const ObstacleActors&) = delete;

    // Null: none. Returns true if the picture is another now; costs nothing for the same ones.
    bool update(const std::shared_ptr<const Obstacles>& obstacles);
    // Where the liver is drawn as an organ, its wall need not be seen twice.
    void set_wall_visible(bool visible) { wall_.set_visible(visible); }
    // Draws only what is on the plane's positive side; null: all.
    void set_clip(vtkPlane* plane);
    bool has_solids() const { return has_solids_; }

  private:
    vtkRenderer& renderer_;
    std::shared_ptr<const Obstacles> shown_;
    GhostActor wall_{liver_ghost};
    vtkSmartPointer<vtkPolyDataMapper> mapper_;
    vtkSmartPointer<vtkActor> solids_;
    bool has_solids_ = false;
};

}  // namespace hepatica
