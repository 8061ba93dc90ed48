// SPDX-License-Identifier: GPL-3.0-or-later
// Volume rendering of a CT around the vessels by ray casting, composited with shading or as a
// maximum intensity projection; vessels and CT hide each other correctly. Without a graphics card
// VTK's fixed-point ray caster draws it, coarsely while anything moves.
#pragma once

#include <memory>

#include "core/image/volume.h"
#include "render/view_look.h"
#include "render/volume_look.h"

class vtkPlane;
class vtkRenderer;

namespace hepatica {

// How much a picture may cost: few rays while anything moves, more at rest, one a pixel for
// pictures that are kept. A graphics card always uses the finest sampling.
enum class VolumeDetail { coarse, fine, best };

// Use it only from the thread whose OpenGL context is the renderer's; the renderer must outlive it.
class VolumeActor {
  public:
    explicit VolumeActor(vtkRenderer& renderer);
    ~VolumeActor();
    VolumeActor(const VolumeActor&) = delete;
    VolumeActor& operator=(const VolumeActor&) = delete;

    // Voxels in Hounsfield units, shared, not copied; null removes the volume. Takes effect with
    // prepare().
    void show(std::shared_ptr<const Volume> voxels);
    bool empty() const { return voxels_ == nullptr; }
    bool set_look(const VolumeLook& look);  // true if a volume is shown
    void set_room(const ViewLook& room);
    // Draws only the part on the plane's positive side; null draws all. The plane must outlive its
    // use.
    void set_clip(vtkPlane* plane);
    void set_detail(VolumeDetail detail);  // `best` by default

    // Call before each picture with the context current: builds a volume that was newly shown, and
    // frees the memory of one that is not shown any more. `by_card`: use the graphics card.
    void prepare(bool by_card);

  private:
    struct Drawn;
    void build(bool by_card);
    void follow_look();
    void follow_clip();
    void follow_detail();

    vtkRenderer& renderer_;
    std::shared_ptr<const Volume> voxels_;
    std::unique_ptr<Drawn> drawn_;  // null while no volume is drawn
    VolumeLook look_;
    ViewLook room_ = dark_look;
    vtkPlane* clip_ = nullptr;
    VolumeDetail detail_ = VolumeDetail::best;
};

}  // namespace hepatica
