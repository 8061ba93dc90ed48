// SPDX-License-Identifier: GPL-3.0-or-later
// Connects a drawn curve to the vessels it touches and limits its radii beside their walls.
#include "core/tree/editing/drawn_vessel.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/tree/station.h"

namespace hepatica {

namespace {

// Position of a point relative to the nearest wall of the graph.
struct Beside {
    int link = -1;
    double along_mm = 0.0;
    double beyond_wall_mm = std::numeric_limits<double>::infinity();  // negative in the lumen
};

// The walls of a graph, as a snapshot.
class Walls {
  public:
    explicit Walls(const VesselGraph& graph) : segments_(segments_of(graph)) {}

    Beside nearest(const Vec3& place_mm) const {
        Beside nearest;
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const NearestStation foot = nearest_station(segments_[i], place_mm);
            const double beyond =
                foot.distance_mm - station_at(segments_[i], foot.arclength_mm).radius_mm;
            if (beyond < nearest.beyond_wall_mm)
                nearest = {static_cast<int>(i), foot.arclength_mm, beyond};
        }
        return nearest;
    }

  private:
    std::vector<VesselSegment> segments_;
};

// The part of a drawn curve outside existing vessels.
struct FreePart {
    std::size_t first = 0;
    std::size_t last = 0;          // one past the last
    std::vector<double> radii_mm;  // of the whole curve
};

// A section nearer to a wall than its own radius includes blood of the vessel behind that wall.
// Where the curve touches a vessel, sections up to the first that is clear of it are limited to the
// radius there; where none is clear, to the smallest radius.
void narrow_to_clear_section(FreePart& part, const std::vector<double>& beyond_wall_mm,
                             bool at_begin) {
    const auto at = [&](std::size_t step) {
        return at_begin ? part.first + step : part.last - 1 - step;
    };
    const std::size_t count = part.last - part.first;
    std::size_t clear = 0;
    while (clear < count && beyond_wall_mm[at(clear)] < part.radii_mm[at(clear)]) ++clear;
    double widest = std::numeric_limits<double>::infinity();
    if (clear < count)
        widest = part.radii_mm[at(clear)];
    else
        for (std::size_t step = 0; step < count; ++step)
            widest = std::min(widest, part.radii_mm[at(step)]);
    for (std::size_t step = 0; step < clear; ++step)
        part.radii_mm[at(step)] = std::min(part.radii_mm[at(step)], widest);
}

// The points after the start's lumen and before the end's. Throws InputError where more than half
// of the curve lies in existing vessels.
FreePart free_part(const VesselGraph& graph, const Centreline& drawn) {
    std::vector<double> beyond_wall_mm;
    const Walls walls(graph);
    for (const Vec3& point : drawn.points_mm)
        beyond_wall_mm.push_back(walls.nearest(point).beyond_wall_mm);
    const auto inside = [](double beyond) { return beyond < 0.0; };
    if (2 * std::ranges::count_if(beyond_wall_mm, inside) > std::ssize(beyond_wall_mm))
        throw InputError("more than half of it lies in vessels that are there already",
                         place_text(drawn.points_mm.front()),
                         "Begin at the wall of the vessel and draw what is missing, or delete the "
                         "branch first");
    FreePart part{0, drawn.points_mm.size(), drawn.radii_mm};
    while (inside(beyond_wall_mm[part.first])) ++part.first;
    while (inside(beyond_wall_mm[part.last - 1])) --part.last;
    if (beyond_wall_mm.front() <= drawn_touch_mm)
        narrow_to_clear_section(part, beyond_wall_mm, true);
    if (beyond_wall_mm.back() <= drawn_touch_mm)
        narrow_to_clear_section(part, beyond_wall_mm, false);
    return part;
}

[[noreturn]] void refuse_one_point(const Centreline& drawn) {
    throw InputError("both ends of the vessel lie at one point",
                     place_text(drawn.points_mm.front()), "Draw it from one place to another");
}

}  // namespace

DrawnVessel add_drawn_vessel(VesselGraph& graph, const Centreline& drawn, VascularSystem system) {
    const FreePart part = free_part(graph, drawn);
    const double radius_at_from = part.radii_mm[part.first];
    const double radius_at_to = part.radii_mm[part.last - 1];

    DrawnVessel result;
    result.system = system;
    const auto node_at = [&](const Vec3& end_mm, double radius_mm, bool& touches,
                             VascularSystem& touched) {
        // looked up anew: the other end may have split a link
        const Beside beside = Walls(graph).nearest(end_mm);
        touches = beside.beyond_wall_mm <= drawn_touch_mm;
        if (!touches) {
            graph.nodes.push_back({end_mm, radius_mm});
            return static_cast<int>(graph.nodes.size()) - 1;
        }
        touched = graph.links[static_cast<std::size_t>(beside.link)].system;
        return split_link(graph, beside.link, beside.along_mm, radius_mm);
    };
    VascularSystem at_from = system;
    result.from = node_at(drawn.points_mm.front(), radius_at_from, result.grows_out, at_from);
    result.to = node_at(drawn.points_mm.back(), radius_at_to, result.leads_in, result.system_at_to);
    const auto node_mm = [&](int node) {
        return graph.nodes[static_cast<std::size_t>(node)].position_mm;
    };
    // Ends that touch nothing have a node each, and so has each of two systems that touch.
    if (result.from == result.to || node_mm(result.from) == node_mm(result.to))
        refuse_one_point(drawn);
    if (result.grows_out)
        result.system = at_from;
    else if (result.leads_in)
        result.system = result.system_at_to;

    Centreline curve;
    const auto add = [&](const Vec3& point, double radius) {
        if (!curve.points_mm.empty() && curve.points_mm.back() == point) return;
        curve.points_mm.push_back(point);
        curve.radii_mm.push_back(radius);
    };
    add(node_mm(result.from), radius_at_from);
    for (std::size_t i = part.first; i < part.last; ++i) add(drawn.points_mm[i], part.radii_mm[i]);
    add(node_mm(result.to), radius_at_to);
    const double narrowest = *std::ranges::min_element(curve.radii_mm);
    curve = resampled(curve, std::max(0.5 * narrowest, 0.5));
    graph.links.push_back({result.from, result.to, result.system,
                           result.system == VascularSystem::unknown ? 0.0 : 1.0, curve.points_mm,
                           curve.radii_mm});
    return result;
}

}  // namespace hepatica
