// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps that might be bridged: dashed lines from vessel to vessel, each labelled with the confidence
// that both ends belong to one vessel; branches that may be vessels, likewise; and rings around one
// that was bridged. They are drawn at the vessels' rest positions.
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <utility>
#include <vector>

#include "core/base/vector.h"
#include "core/tree/extraction/gap_bridging.h"

#include "render/palette.h"
#include "render/picture_words.h"

class vtkActor;
class vtkBillboardTextActor3D;
class vtkRenderer;

namespace hepatica {

struct BridgeView {
    std::vector<Vec3> path_mm;
    std::string label;    // may be empty
    bool chosen = false;  // brighter and wider than the others
    // Above 0: a vessel of this radius was built there, so that rings are drawn around it.
    double around_mm = 0.0;
};

// One view per bridge, labelled with its confidence in percent; none is chosen.
std::vector<BridgeView> views_of(const std::vector<Bridge>& bridges);

// Draws into one renderer, which must outlive it; not thread-safe.
class BridgeActor {
  public:
    explicit BridgeActor(vtkRenderer& renderer);
    ~BridgeActor();
    BridgeActor(const BridgeActor&) = delete;
    BridgeActor& operator=(const BridgeActor&) = delete;

    // Colour of a chosen bridge.
    void set_text_colour(const Colour& colour);
    // Takes effect with the next set_bridges(); English by default.
    void set_words(PictureWords words) { words_ = std::move(words); }
    void set_bridges(std::vector<BridgeView> bridges);
    const std::vector<BridgeView>& bridges() const { return bridges_; }
    // Scales the letters and their offset.
    void set_pixel_ratio(double pixel_ratio);

  private:
    void remove_actors();

    vtkRenderer& renderer_;
    PictureWords words_;
    std::vector<BridgeView> bridges_;
    std::vector<vtkSmartPointer<vtkActor>> lines_;
    std::vector<vtkSmartPointer<vtkBillboardTextActor3D>> labels_;
    Colour text_colour_ = palette::text;
    double pixel_ratio_ = 1.0;
};

}  // namespace hepatica
