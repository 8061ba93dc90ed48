// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/potentials/body_surfaces.h"

#include <optional>

#include "core/base/error.h"
#include "core/deform/body/torn_body.h"
#include "core/deform/potentials/obstacle_contact.h"
#include "core/deform/potentials/self_contact.h"
#include "core/deform/potentials/tool_contact.h"

namespace hepatica {

SurfacesKept BodySurfaces::kept_overlaps() const {
    SurfacesKept kept;
    if (self_) kept.self = self_->pairs().kept_overlaps();
    if (obstacles_) kept.obstacles = obstacles_->pairs().kept_overlaps();
    return kept;
}

void BodySurfaces::set_overlaps(const SurfacesKept& kept) const {
    const auto take = [](const std::optional<OverlapsKept>& some, auto* contact) {
        return !some || (contact && contact->pairs().set_overlaps(*some));
    };
    const SurfacesKept before = kept_overlaps();
    if (take(kept.self, self_) && take(kept.obstacles, obstacles_)) return;
    take(before.self, self_);
    throw InputError("has surfaces that touch otherwise", "the checkpoint of a body",
                     "Make the stepper of the body that it was taken of");
}

void BodySurfaces::let_go(std::span<const Vec3> positions_mm) const {
    if (self_) self_->pairs().let_go(positions_mm);
    if (obstacles_) obstacles_->let_go(positions_mm);
    if (tool_) tool_->grow_thin_pads(positions_mm);
}

void BodySurfaces::find_overlaps(std::span<const Vec3> positions_mm) const {
    if (self_) self_->pairs().find_overlaps(positions_mm);
    if (obstacles_) obstacles_->find_overlaps(positions_mm);
}

SurfacesBeforeTear BodySurfaces::before_tear(std::span<const Vec3> positions_mm) const {
    SurfacesBeforeTear before;
    if (self_) before.self = std::make_shared<BeforeTear>(self_->pairs().before_tear(positions_mm));
    if (obstacles_)
        before.obstacles = std::make_shared<BeforeTear>(obstacles_->before_tear(positions_mm));
    if (tool_) before.tool = tool_->before_tear(positions_mm);
    before.nodes = static_cast<int>(positions_mm.size());
    return before;
}

void BodySurfaces::follow_split(const SurfacesBeforeTear& before, std::span<const int> parents,
                                std::span<const Vec3> positions_mm) const {
    if (before.self) self_->pairs().follow_split(*before.self, parents, positions_mm);
    if (before.obstacles) obstacles_->follow_split(*before.obstacles, parents, positions_mm);
    if (tool_) tool_->follow_split(before.tool, nodes_before(parents, before.nodes), positions_mm);
}

}  // namespace hepatica
