// SPDX-License-Identifier: GPL-3.0-or-later
// A tool as the capsules that it is made of, and the force on it as an arrow with its number, and
// that of its grip. The
// arrow's length goes with the logarithm of the force, in points of the screen, so that a touch and
// a push can both be seen.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/frame.h"

class vtkActor;
class vtkRenderer;

#include "render/figure_label.h"
#include "render/legend_rows.h"
#include "render/picture_words.h"

namespace hepatica {

// "12 mN", "0.4 mN"; empty below a twentieth of a millinewton, which counts as no force.
std::string force_text(double force_un);

// Draws into one renderer, which must outlive it; not thread-safe.
class ToolActor {
  public:
    explicit ToolActor(vtkRenderer& renderer);
    ~ToolActor();
    ToolActor(const ToolActor&) = delete;
    ToolActor& operator=(const ToolActor&) = delete;

    // From the next update on; English at first.
    void set_words(PictureWords words) { words_ = std::move(words); }
    // Returns true if the picture is another now.
    bool update(const std::optional<ToolView>& tool);
    // Size of one point of the screen at the focal plane, and its pixels.
    void set_scale(double mm_per_point, double pixel_ratio);
    // Where the number stands in the picture, in its pixels; none: it is not shown.
    std::optional<PictureBox> label_box() const { return label_.box(); }

  private:
    // A capsule where it is seen, and faintly where vessels hide it.
    struct Part {
        vtkSmartPointer<vtkActor> solid, ghost;
    };
    void add_part();
    void remove_part();
    void place_arrow();

    vtkRenderer& renderer_;
    PictureWords words_;
    std::optional<ToolView> shown_;
    std::vector<Part> parts_;
    vtkSmartPointer<vtkActor> arrow_;
    FigureLabel label_;  // beside the arrow's head
    double mm_per_point_ = 1.0;
};

}  // namespace hepatica
