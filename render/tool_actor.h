// SPDX-License-Identifier: GPL-3.0-or-later
// A tool, drawn as its capsules, with the force on it as an arrow and a label that gives the force
// and the grip's force. The arrow's length in screen points grows with the logarithm of the force,
// so that both a touch and a push are visible. A vessel that jaws hold is marked there by a bead,
// which vessels and jaws do not hide.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <span>
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

// "12.0 mN", "0.4 mN"; empty below 0.05 mN, which counts as no force.
std::string force_text(double force_un);

// Draws into one renderer, which must outlive it; not thread-safe.
class ToolActor {
  public:
    explicit ToolActor(vtkRenderer& renderer);
    ~ToolActor();
    ToolActor(const ToolActor&) = delete;
    ToolActor& operator=(const ToolActor&) = delete;

    // Takes effect with the next update(); English by default.
    void set_words(PictureWords words) { words_ = std::move(words); }
    void set_colour(const Colour& colour);  // palette::tool by default
    // None hides the tool. `positions_mm`: three for each vertex of the body; without, what jaws
    // hold is marked at the mean of their contacts. Returns true if the picture changed.
    bool update(const std::optional<ToolView>& tool, std::span<const float> positions_mm = {});
    // Call before each picture. `mm_per_point`: size of one screen point at the focal plane;
    // `pixel_ratio`: pixels of a point.
    void set_scale(double mm_per_point, double pixel_ratio);
    // Where its parts and its arrow are in the picture, so that no label need cover them.
    std::vector<ThickStretch> outlines() const;
    const std::optional<ToolView>& shown() const { return shown_; }
    // The label's rectangle in the picture in pixels; none where it is not shown.
    std::optional<PictureBox> label_box() const { return label_.box(); }

  private:
    // The visible part of a capsule, and a faint copy in a clear outline, which vessels do not
    // hide.
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
    Colour colour_ = palette::tool;
    vtkSmartPointer<vtkActor> arrow_;
    Vec3 arrow_from_mm_ = Vec3::Zero(), arrow_to_mm_ = Vec3::Zero();
    vtkSmartPointer<vtkActor> held_;
    FigureLabel label_;  // beside the arrow's head, or beside what is held
    double mm_per_point_ = 1.0;
};

}  // namespace hepatica
