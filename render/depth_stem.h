// SPDX-License-Identifier: GPL-3.0-or-later
// How far a tool has to go: a line from its tip to the nearest mark that is not reached yet, or,
// where there is none, to the nearest place of the vessels' surface, with the distance in
// millimetres. Seen from anywhere, it says what the depth of a picture does not.
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
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

    // From the next update on; English at first.
    void set_words(PictureWords words) { words_ = std::move(words); }
    // `positions_mm`: x, y, z of each vertex of the vessels. Costs one pass over them while a tool
    // is there and no mark waits for it, and nothing without a tool. Returns true if the picture is
    // another now.
    // `forward`: into the picture, of length 1; the words say whether a mark lies deeper or nearer.
    bool update(const std::optional<ToolView>& tool, const std::vector<float>& positions_mm,
                const std::vector<MarkView>& marks, const Vec3& forward);
    // Its number keeps clear of a mark that lies straight behind the tool.
    void place(double pixel_ratio) {
        constexpr double beside_mark_points = 18.0;
        label_.place(pixel_ratio, beside_mark_points);
    }

  private:
    vtkRenderer& renderer_;
    PictureWords words_;
    vtkSmartPointer<vtkLineSource> ends_;
    vtkSmartPointer<vtkActor> line_;
    Vec3 tip_mm_ = Vec3::Zero(), end_mm_ = Vec3::Zero();  // as shown
    std::string text_;                                    // as shown
    FigureLabel label_;
};

}  // namespace hepatica
