// SPDX-License-Identifier: GPL-3.0-or-later
// A number with its unit beside a point of the patient, in front of all and never beyond the
// picture's edge.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <string>

#include "core/base/vector.h"
#include "render/legend_rows.h"
#include "render/palette.h"

class vtkRenderer;
class vtkTextActor;

namespace hepatica {

// Draws into one renderer, which must outlive it; not thread-safe.
class FigureLabel {
  public:
    FigureLabel(vtkRenderer& renderer, const Colour& colour);
    ~FigureLabel();
    FigureLabel(const FigureLabel&) = delete;
    FigureLabel& operator=(const FigureLabel&) = delete;

    // An empty text shows nothing. Returns true if the picture is another now.
    bool show(const std::string& text, const Vec3& at_mm);
    // To be called before each picture: the camera may have moved. `below` points of the screen
    // below the point, and as many to its right.
    void place(double pixel_ratio, double below_points = 0.0);
    // Where it stands in the picture, in its pixels; none: it is not shown.
    std::optional<PictureBox> box() const;

  private:
    vtkRenderer& renderer_;
    Colour colour_;
    vtkSmartPointer<vtkTextActor> text_;
    std::string shown_;
    Vec3 at_mm_ = Vec3::Zero();
};

}  // namespace hepatica
