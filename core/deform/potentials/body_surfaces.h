// SPDX-License-Identifier: GPL-3.0-or-later
// What the surfaces of a body keep from step to step: which of their pairs overlap and therefore do
// not touch (see Overlaps) and which have the pad of a split (see pair_pads.h), for contact of the
// body with itself and with obstacles alike, and the thin pads of a tool (see thin_pads.h). It is
// kept in checkpoints and handed on where the body tears.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/potentials/self_load.h"
#include "core/deform/potentials/tool.h"

namespace hepatica {

class SelfContact;
class ObstacleContact;
class ToolContact;
struct BeforeTear;

// What the surfaces of a body hand over to those of the body that it is torn into.
struct SurfacesBeforeTear {
    std::shared_ptr<const BeforeTear> self, obstacles;  // null: none
    std::vector<ThinPad> tool;                          // the pads of the triangles near it
    int nodes = 0;
};

// A view of the contacts of one body, which must outlive it; null where the body has none. All
// positions are in mm, one per node of the body. Not thread-safe.
class BodySurfaces {
  public:
    BodySurfaces(SelfContact* self, ObstacleContact* obstacles, ToolContact* tool)
        : self_(self), obstacles_(obstacles), tool_(tool) {}

    // What overlaps now. set_overlaps() takes what a checkpoint kept; it throws InputError and
    // changes nothing where that is of another body.
    SurfacesKept kept_overlaps() const;
    void set_overlaps(const SurfacesKept& kept) const;
    // let_go(): separated pairs may touch again, and thin pads grow. find_overlaps(): searches from
    // scratch.
    void let_go(std::span<const Vec3> positions_mm) const;
    void find_overlaps(std::span<const Vec3> positions_mm) const;

    // before_tear() is called on the surfaces of the body before, follow_split() on those of the
    // torn body: `parents` as in TornBody.
    SurfacesBeforeTear before_tear(std::span<const Vec3> positions_mm) const;
    void follow_split(const SurfacesBeforeTear& before, std::span<const int> parents,
                      std::span<const Vec3> positions_mm) const;

  private:
    SelfContact* self_;
    ObstacleContact* obstacles_;
    ToolContact* tool_;
};

}  // namespace hepatica
