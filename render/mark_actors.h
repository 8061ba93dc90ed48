// SPDX-License-Identifier: GPL-3.0-or-later
// Places that a lesson refers to: translucent spheres of constant size on the screen, through which
// the vessel is visible, each with its number. The number, or a sphere that has none, is visible
// even where vessels or blood hide the place. A place that is done is green and ticked. Other
// places, such as a branch that is too short to be found, have a sphere in the text's colour, moved
// towards the eye.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "core/base/vector.h"
#include "render/palette.h"
#include "render/projection.h"

class vtkActor;
class vtkBillboardTextActor3D;
class vtkRenderer;

namespace hepatica {

struct MarkView {
    Vec3 place_mm = Vec3::Zero();
    std::string number;  // shown beside it; may be empty
    bool reached = false;
    bool of_lesson = true;
    bool wanted = false;  // the present step of the lesson asks for it
    bool operator==(const MarkView&) const = default;
};

class MarkActors {
  public:
    // The renderer must outlive it.
    explicit MarkActors(vtkRenderer& renderer) : renderer_(renderer) {}

    // Returns true if the picture changed.
    bool update(std::vector<MarkView> marks);
    const std::vector<MarkView>& shown() const { return shown_; }
    // The nearest place of a lesson that is still to be reached and whose sphere, so many times as
    // large as it was drawn last, covers the pixel.
    std::optional<Vec3> place_at(const Projection& projection, const Pixel& pixel,
                                 double times) const;
    // Call before each picture. `mm_per_point`: size of one screen point at the focal plane;
    // `pixel_ratio`: pixels of a point; `reach_mm`: nothing drawn is nearer to the eye than this
    // distance in front of the focal point.
    void set_scale(double mm_per_point, double pixel_ratio, double reach_mm);
    // Colour of the numbers, and of the spheres that are not places of a lesson.
    void set_text_colour(const Colour& colour) { text_colour_ = colour; }

  private:
    struct Drawn {
        vtkSmartPointer<vtkActor> ball;
        vtkSmartPointer<vtkBillboardTextActor3D> number;
    };
    Drawn add_one();
    Vec3 before_all(const Vec3& place_mm, double reach_mm) const;
    int beside(const Vec3& at, const MarkView& mark, double pixel_ratio) const;

    vtkRenderer& renderer_;
    std::vector<MarkView> shown_;
    std::vector<Drawn> drawn_;
    double ball_mm_ = 0.0;  // radius of the spheres in the last picture
    Colour text_colour_{1.0, 1.0, 1.0};
};

}  // namespace hepatica
