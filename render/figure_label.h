// SPDX-License-Identifier: GPL-3.0-or-later
// A number with its unit beside a point of the patient. It is drawn over everything else, on a dark
// ground that sets it off from vessels and from bright pictures, and kept within the picture and
// off the tool.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <span>
#include <string>

#include "core/base/vector.h"
#include "render/clear_place.h"
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

    // An empty text shows nothing. Returns true if the picture changed.
    bool show(const std::string& text, const Vec3& at_mm);
    // Call before each picture, because the camera may have moved. The label is beside the point,
    // `below_points` screen points below it and as many further to its right; where one of
    // `keep_clear` lies there, on another side of the point or further away, as near as it is free.
    // It stays where it was as long as that is free, and comes nearer again only where there is
    // ample room, so that it does not jump to and fro. Beside a point behind the eye there is none.
    void place(double pixel_ratio, double below_points = 0.0,
               std::span<const ThickStretch> keep_clear = {});
    // The label's rectangle in the picture in pixels; none where it is not shown.
    std::optional<PictureBox> box() const;

  private:
    vtkRenderer& renderer_;
    Colour colour_;
    vtkSmartPointer<vtkTextActor> text_;
    std::string shown_;
    Vec3 at_mm_ = Vec3::Zero();
    int side_ = 0;     // of the point, on which it is; see corner_beside()
    int further_ = 0;  // from the point than where all is free; see further_points
};

}  // namespace hepatica
