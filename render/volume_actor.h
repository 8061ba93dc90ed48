// SPDX-License-Identifier: GPL-3.0-or-later
// A CT as a volume around the vessels: rays through its voxels, composed with light or searched for
// their maximum, hidden by what stands in front and hiding what lies behind. Without a graphics
// card VTK's fixed-point caster draws it, a coarse picture while anything moves.
#pragma once

#include <memory>

#include "core/image/volume.h"
#include "render/view_look.h"
#include "render/volume_look.h"

class vtkPlane;
class vtkRenderer;

namespace hepatica {

// How much is spent on a picture: a few rays while anything moves, more at rest, one a pixel for
// pictures that are kept. A graphics card always spends the most.
enum class VolumeDetail { coarse, fine, best };

// Belongs to the thread whose OpenGL context is the renderer's; the renderer must outlive it.
class VolumeActor {
  public:
    explicit VolumeActor(vtkRenderer& renderer);
    ~VolumeActor();
    VolumeActor(const VolumeActor&) = delete;
    VolumeActor& operator=(const VolumeActor&) = delete;

    // Voxels in Hounsfield units, which are kept, not copied; null: none.
    void show(std::shared_ptr<const Volume> voxels);
    bool empty() const { return voxels_ == nullptr; }
    bool set_look(const VolumeLook& look);  // true if the picture is another now
    void set_room(const ViewLook& room);
    // Draws only what is on the plane's positive side; null: all.
    void set_clip(vtkPlane* plane);
    void set_detail(VolumeDetail detail);  // `best` at first

    // Before each picture, with the context current: what was shown since the last one is built,
    // and what is not shown any more gives its memory back. `by_card`: by a graphics card.
    void prepare(bool by_card);

  private:
    struct Drawn;
    void build(bool by_card);
    void follow_look();
    void follow_clip();
    void follow_detail();

    vtkRenderer& renderer_;
    std::shared_ptr<const Volume> voxels_;
    std::unique_ptr<Drawn> drawn_;  // null while nothing is shown
    VolumeLook look_;
    ViewLook room_ = dark_look;
    vtkPlane* clip_ = nullptr;
    VolumeDetail detail_ = VolumeDetail::best;
};

}  // namespace hepatica
