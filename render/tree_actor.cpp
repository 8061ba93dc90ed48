// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tree_actor.h"

#include <vtkActor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "render/drug_overlay.h"
#include "render/palette.h"

namespace hepatica {
namespace {

// Appends to the values of the surface's vertices those of the edges' middles, which are the means
// of both ends.
template <class T>
std::vector<T> with_middles(std::vector<T> values, std::size_t components,
                            const std::vector<std::array<int, 2>>& edges) {
    values.reserve(values.size() + components * edges.size());
    for (const auto& [a, b] : edges) {
        for (std::size_t c = 0; c < components; ++c) {
            const T at_a = values[components * static_cast<std::size_t>(a) + c];
            const T at_b = values[components * static_cast<std::size_t>(b) + c];
            values.push_back(static_cast<T>((at_a + at_b) / 2));
        }
    }
    return values;
}

}  // namespace

TreeActor::TreeActor() {
    show_one();
}

bool TreeActor::update(const Frame& frame) {
    const SurfaceGeometry::Change change = surface_.update(frame);
    const bool rebuilt = change == SurfaceGeometry::Change::topology;
    const bool touched_anew = take_touched(frame.tool);
    if (rebuilt) take_topology();
    origins_ = frame.tear ? frame.tear->origins : nullptr;
    const auto rims = frame.tear ? frame.tear->rims : nullptr;
    const bool torn_anew = rims != rims_;
    rims_ = rims;
    const auto loads = frame.tear && warnings_ ? frame.tear->loads : nullptr;
    const bool warned_anew = loads != loads_;
    loads_ = loads;
    const bool reached_anew = frame.drug.reached_before != reached_before_;
    reached_before_ = frame.drug.reached_before;
    const bool moved = change != SurfaceGeometry::Change::none;
    const bool stretched_anew = (moved || stretches_.empty()) && take_stretch(frame);
    if (rebuilt || stretched_anew || touched_anew || warned_anew || torn_anew || reached_anew)
        take_colours();
    if (moved) {
        plain_is_old_ = rounded_is_old_ = true;
        take_positions();
    }
    const bool new_drug =
        frame.drug.version != drug_version_ || frame.drug.arrival_s.get() != drug_source_;
    if (rebuilt || new_drug) take_arrival(frame.drug);
    const bool drug_moved = frame.drug.time_s != drug_time_s_;
    drug_time_s_ = frame.drug.time_s;
    for (vtkActor* actor : actors()) drug_overlay::set_time(*actor, frame.drug, least_drug_end_s_);
    show_one();
    return moved || stretched_anew || new_drug || drug_moved || touched_anew || warned_anew ||
           torn_anew || reached_anew;
}

void TreeActor::set_rounded(bool rounded) {
    is_rounded_ = rounded;
    take_positions();
    show_one();
}

void TreeActor::set_vertex_systems(std::vector<VascularSystem> systems) {
    systems_ = std::move(systems);
    take_colours();
}

void TreeActor::set_vertex_segments(std::vector<std::uint8_t> segments) {
    segments_ = std::move(segments);
    take_colours();
}

void TreeActor::set_highlight(std::vector<std::uint8_t> highlight, bool of_branch) {
    if (highlight == highlight_ && of_branch == highlights_branch_) return;
    highlight_ = std::move(highlight);
    highlights_branch_ = of_branch;
    take_colours();
}

void TreeActor::set_target(std::vector<std::uint8_t> target) {
    if (target == target_) return;
    target_ = std::move(target);
    take_colours();
}

void TreeActor::set_warnings(bool shown) {
    warnings_ = shown;
    if (shown || !loads_) return;
    loads_.reset();
    take_colours();
}

void TreeActor::set_stretch_shown(bool shown) {
    stretch_shown_ = shown;
    if (shown || stretches_.empty()) return;
    stretches_.clear();
    take_colours();
}

void TreeActor::set_rest_positions(const std::vector<Vec3>& rest_mm) {
    if (rest_mm == stretch_.rest_mm()) return;
    stretch_ = SurfaceStretch(rest_mm);
    stretches_.clear();
}

bool TreeActor::take_stretch(const Frame& frame) {
    const bool torn = frame.tear && frame.tear->origins;
    const std::size_t at_rest = stretch_.rest_mm().size();
    const bool moves = at_rest > 0 && (torn || frame.positions_mm.size() == 3 * at_rest);
    stretches_.clear();
    if (stretch_shown_ && moves && frame.surface) stretches_ = stretch_.of_vertices(frame);
    return !stretches_.empty();
}

void TreeActor::set_clip(vtkPlane* plane) {
    plain_.set_clip(plane);
    rounded_.set_clip(plane);
}

void TreeActor::set_halo(bool shown) {
    has_halo_ = shown;
    show_one();
}

void TreeActor::set_fade(double near_mm, double far_mm) {
    for (vtkActor* actor : actors()) drug_overlay::set_fade(*actor, near_mm, far_mm);
}

void TreeActor::set_bright(bool bright) {
    if (std::exchange(bright_, bright) != bright) take_colours();
}

void TreeActor::set_distance(const Colour& colour) {
    for (vtkActor* actor : actors()) drug_overlay::set_distance(*actor, colour);
}

void TreeActor::show_one() {
    const bool some = !surface_.triangles().empty();
    plain_.actor()->SetVisibility(some && !is_rounded_);
    rounded_.actor()->SetVisibility(some && is_rounded_);
    rounded_.halo().actor()->SetVisibility(some && is_rounded_ && has_halo_);
}

void TreeActor::take_topology() {
    rounding_.set_topology(surface_.triangles(), surface_.frame_vertices().size(),
                           surface_.creases());
    plain_.set_triangles(surface_.triangles(), surface_.frame_vertices().size());
    rounded_.set_triangles(rounding_.triangles(), rounding_.vertex_count());
}

void TreeActor::take_positions() {
    if (is_rounded_ && std::exchange(rounded_is_old_, false)) {
        rounding_.update(surface_);
        rounded_.set_positions(rounding_.positions_mm(), rounding_.normals());
    } else if (!is_rounded_ && std::exchange(plain_is_old_, false)) {
        plain_.set_positions(surface_.positions_mm(), surface_.normals());
    }
}

bool TreeActor::take_touched(const std::optional<ToolView>& tool) {
    std::vector<int> touched = tool ? tool->touched : std::vector<int>{};
    if (touched == touched_) return false;
    touched_ = std::move(touched);
    return true;
}

Colour TreeActor::own_colour_of(std::size_t vertex, std::size_t origin) const {
    if (reached_before_ && vertex < reached_before_->size() && (*reached_before_)[vertex] != 0)
        return palette::reached_before(bright_);
    const auto marked = [origin](const std::vector<std::uint8_t>& per_vertex) {
        return origin < per_vertex.size() && per_vertex[origin] != 0;
    };
    const bool lit = marked(highlight_);
    if (marked(target_))
        return lit ? palette::lit_drug_target(bright_) : palette::drug_target(bright_);
    if (lit)
        return highlights_branch_ ? palette::chosen_branch(bright_) : palette::highlight(bright_);
    if (vertex < stretches_.size()) return palette::stretch(stretches_[vertex], bright_);
    const int segment = origin < segments_.size() ? segments_[origin] : 0;
    if (segment > 0) return palette::liver_segment(segment);
    return palette::vessel_system(
        origin < systems_.size() ? systems_[origin] : VascularSystem::unknown, bright_);
}

Colour TreeActor::colour_of(int vertex, bool bare) const {
    if (std::ranges::binary_search(touched_, vertex)) return palette::touch;
    const auto shown = static_cast<std::size_t>(vertex);
    const bool split = origins_ && shown < origins_->size();
    const auto v = split ? static_cast<std::size_t>((*origins_)[shown]) : shown;
    const bool torn = split && (*rims_)[shown] != 0;
    const Colour colour =
        torn ? bare ? palette::torn_inside : palette::torn : own_colour_of(shown, v);
    if (loads_ && shown < loads_->size()) return palette::warning(colour, (*loads_)[shown]);
    return colour;
}

void TreeActor::take_colours() {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * surface_.frame_vertices().size());
    const std::vector<int>& vertices = surface_.frame_vertices();
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        for (const double channel : colour_of(vertices[v], surface_.bare(v)))
            rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0 * channel)));
        rgba.push_back(255);
    }
    plain_.set_colours(rgba);
    rounded_.set_colours(with_middles(std::move(rgba), 4, rounding_.edges()));
}

void TreeActor::take_arrival(const DrugView& drug) {
    drug_version_ = drug.version;
    drug_source_ = drug.arrival_s.get();
    std::vector<float> arrivals;
    arrivals.reserve(surface_.frame_vertices().size());
    for (const int vertex : surface_.frame_vertices()) {
        const auto v = static_cast<std::size_t>(vertex);
        const bool known = drug.arrival_s && v < drug.arrival_s->size();
        const float arrival = known ? (*drug.arrival_s)[v] : drug_overlay::never_s;
        arrivals.push_back(std::isfinite(arrival) ? arrival : drug_overlay::never_s);
    }
    plain_.set_arrival(arrivals);
    rounded_.set_arrival(with_middles(std::move(arrivals), 1, rounding_.edges()));
}

}  // namespace hepatica
