// SPDX-License-Identifier: GPL-3.0-or-later
// The obstacles to vessels and tools: tumours, which nothing can enter, drawn opaque, and the
// liver's wall, which keeps everything inside, drawn as translucent as the organ.
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

    // Null shows none. Returns true if the picture changed; costs nothing for the same pointer.
    bool update(const std::shared_ptr<const Obstacles>& obstacles);
    // Hides the wall where the liver is already drawn as an organ.
    void set_wall_visible(bool visible) { wall_.set_visible(visible); }
    // Draws only the part on the plane's positive side; null draws all.
    void set_clip(vtkPlane* plane);
    bool has_solids() const { return has_solids_; }
    // The connected parts of a surface that lies at no solid everywhere: what was painted since
    // the obstacles were made. A part within 4.5 mm of their vertices counts as one of them, since
    // both surfaces are smoothed, each in its own way.
    TriangleMesh parts_beside_solids(const TriangleMesh& surface) const;

  private:
    vtkRenderer& renderer_;
    std::shared_ptr<const Obstacles> shown_;
    GhostActor wall_{liver_ghost};
    vtkSmartPointer<vtkPolyDataMapper> mapper_;
    vtkSmartPointer<vtkActor> solids_;
    bool has_solids_ = false;
};

}  // namespace hepatica
