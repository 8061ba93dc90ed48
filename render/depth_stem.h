// SPDX-License-Identifier: GPL-3.0-or-later
// Shows how far a tool has to go: a line from its tip, or from the middle between its jaws, to the
// nearest mark that the lesson's present step asks for, else to the nearest that is not reached
// yet, else to the nearest vertex of the vessels' surface, labelled with the distance in
// millimetres. It conveys the depth that a perspective picture does not show.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/frame.h"
#include "render/figure_label.h"
#include "render/mark_actors.h"
#include "render/picture_words.h"

class vtkActor;
class vtkLineSource;
class vtkRenderer;

namespace hepatica {

// Draws into one renderer, which must outlive it; not thread-safe.
class DepthStem {
  public:
    explicit DepthStem(vtkRenderer& renderer);
    ~DepthStem();
    DepthStem(const DepthStem&) = delete;
    DepthStem& operator=(const DepthStem&) = delete;

    // Takes effect with the next update(); English by default.
    void set_words(PictureWords words) { words_ = std::move(words); }
    void set_colour(const Colour& colour);  // of the line; palette::tool by default
    // `positions_mm`: x, y, z of each vertex of the vessels' surface. Costs one pass over them
    // while a tool is present and no mark is waiting, and nothing without a tool. Only tools that
    // touch nothing have a line, and jaws where a mark is waiting: what they touch on their way may
    // be another vessel. Jaws that close with the mark between them have none; others say that they
    // closed beside it. `forward`: unit vector into the picture, by which the label says whether
    // the line's end lies deeper or nearer. Returns true if the picture changed.
    bool update(const std::optional<ToolView>& tool, const std::vector<float>& positions_mm,
                const std::vector<MarkView>& marks, const Vec3& forward);
    // Places the number, and says anew whether the mark lies deeper, since the view may have been
    // turned; call before each picture. The number keeps clear of a mark straight behind the tool
    // and of the tool's outlines and figure in the picture. `pixel_ratio`: size of one screen point
    // in device pixels.
    void place(double pixel_ratio, const Vec3& forward, std::span<const ThickStretch> of_tool = {});
    std::optional<PictureBox> label_box() const { return label_.box(); }

  private:
    std::string words_of(const Vec3& forward) const;

    vtkRenderer& renderer_;
    PictureWords words_;
    vtkSmartPointer<vtkLineSource> ends_;
    vtkSmartPointer<vtkActor> line_;
    // As shown:
    Vec3 from_mm_ = Vec3::Zero(), end_mm_ = Vec3::Zero();
    std::optional<std::string> mark_;  // number of the mark at the end; none: no mark is there
    double away_mm_ = 0.0;
    bool between_jaws_ = false;   // the mark is
    bool closed_beside_ = false;  // the jaws closed with the mark beside them
    std::string text_;
    FigureLabel label_;
};

}  // namespace hepatica
