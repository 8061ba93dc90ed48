// SPDX-License-Identifier: GPL-3.0-or-later
// Places that a lesson speaks of, as translucent balls of one size on the screen, through which the
// vessel is seen, each with its number, which is seen even where vessels or blood hide the place.
// One that is done with is green and ticked. Another place, such as a branch that is too short to
// be found, has a ball of the colour of words, nearer to the eye.
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "core/base/vector.h"
#include "render/palette.h"

class vtkActor;
class vtkBillboardTextActor3D;
class vtkRenderer;

namespace hepatica {

struct MarkView {
    Vec3 place_mm = Vec3::Zero();
    std::string number;  // beside it; may be empty
    bool reached = false;
    bool of_lesson = true;
    bool operator==(const MarkView&) const = default;
};

class MarkActors {
  public:
    // The renderer must outlive it.
    explicit MarkActors(vtkRenderer& renderer) : renderer_(renderer) {}

    // Returns true if the picture is another now.
    bool update(std::vector<MarkView> marks);
    const std::vector<MarkView>& shown() const { return shown_; }
    // Size of one screen point at the focal plane, and how many pixels it has; nothing that is
    // drawn reaches nearer to the eye than `reach_mm` before the focal point.
    void set_scale(double mm_per_point, double pixel_ratio, double reach_mm);
    // Of the numbers, and of what is no place of a lesson.
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
    Colour text_colour_{1.0, 1.0, 1.0};
};

}  // namespace hepatica
