// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/editing/drawn_vessel.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/patient_space.h"
#include "core/tree/station.h"

namespace hepatica {

namespace {

constexpr double touch_mm = 1.0;  // beyond a lumen's wall, for an end that is meant to touch it

// Where a point lies with respect to the nearest wall of the graph.
struct Beside {
    int link = -1;
    double along_mm = 0.0;
    double beyond_wall_mm = std::numeric_limits<double>::infinity();  // below 0: in the lumen
};

// The walls of a graph as it is now.
class Walls {
  public:
    explicit Walls(const VesselGraph& graph) {
        for (const VesselLink& link : graph.links) {
            VesselSegment& segment = segments_.emplace_back();
            segment.points_mm = link.points_mm;
            segment.radii_mm = link.radii_mm;
        }
    }

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

}  // namespace

DrawnVessel add_drawn_vessel(VesselGraph& graph, const Centreline& drawn, VascularSystem system) {
    const std::size_t count = drawn.points_mm.size();
    std::vector<std::uint8_t> inside;
    const Walls walls(graph);
    for (const Vec3& point : drawn.points_mm)
        inside.push_back(walls.nearest(point).beyond_wall_mm < 0.0 ? 1 : 0);
    if (2 * std::ranges::count(inside, 1) > std::ssize(inside))
        throw InputError("more than half of it lies in vessels that are there already",
                         place_text(drawn.points_mm.front()),
                         "Begin at the wall of the vessel and draw what is missing, or delete the "
                         "branch first");
    // The free part: from the last point of the beginning within a lumen to the first at the end.
    std::size_t first = 0, last = count;
    while (inside[first] != 0) ++first;
    while (inside[last - 1] != 0) --last;

    DrawnVessel result;
    result.system = system;
    const auto node_at = [&](const Vec3& end_mm, double radius_mm, bool& touches,
                             VascularSystem& touched) {
        const Beside beside = Walls(graph).nearest(end_mm);  // the other end may have split one
        touches = beside.beyond_wall_mm <= touch_mm;
        if (!touches) {
            graph.nodes.push_back({end_mm, radius_mm});
            return static_cast<int>(graph.nodes.size()) - 1;
        }
        touched = graph.links[static_cast<std::size_t>(beside.link)].system;
        return split_link(graph, beside.link, beside.along_mm, radius_mm);
    };
    VascularSystem at_from = system;
    result.from =
        node_at(drawn.points_mm.front(), drawn.radii_mm[first], result.grows_out, at_from);
    result.to = node_at(drawn.points_mm.back(), drawn.radii_mm[last - 1], result.leads_in,
                        result.system_at_to);
    if (result.from == result.to)
        throw InputError("both ends of the vessel lie at one point",
                         place_text(drawn.points_mm.front()), "Draw it from one place to another");
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
    const auto node_mm = [&](int node) {
        return graph.nodes[static_cast<std::size_t>(node)].position_mm;
    };
    add(node_mm(result.from), drawn.radii_mm[first]);
    for (std::size_t i = first; i < last; ++i) add(drawn.points_mm[i], drawn.radii_mm[i]);
    add(node_mm(result.to), drawn.radii_mm[last - 1]);
    const double narrowest = *std::ranges::min_element(curve.radii_mm);
    curve = resampled(curve, std::max(0.5 * narrowest, 0.5));
    graph.links.push_back({result.from, result.to, result.system,
                           result.system == VascularSystem::unknown ? 0.0 : 1.0, curve.points_mm,
                           curve.radii_mm});
    return result;
}

}  // namespace hepatica
