// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tree/editing/doubtful_link.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

#include "core/tree/editing/edit_reach.h"
#include "core/tree/station.h"

namespace hepatica {

namespace {

constexpr double long_gap_mm = 20.0;
constexpr double long_gap_diameters = 5.0;

struct LinkEnd {
    VascularSystem system;
    Station at;
};

LinkEnd end_at(const TreePoint& point, const VesselTree& tree) {
    const VesselSegment& segment = tree.segments[static_cast<std::size_t>(point.segment)];
    return {segment.system, station_at(segment, point.arclength_mm)};
}

std::string gap_text(double gap_mm) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(1) << gap_mm << " mm";
    return text.str();
}

}  // namespace

std::vector<std::string> doubts_of_link(const VesselTree& tree, const TreeEdit& edit) {
    if (edit.kind != TreeEditKind::add_link || !edit.path_mm.empty() || tree.segments.empty())
        return {};
    const TreePoint first = nearest_point(tree, edit.at_mm);
    const TreePoint second = nearest_point(tree, edit.to_mm);
    if (!(std::max(first.distance_mm, second.distance_mm) <= edit_reach_mm)) return {};
    const LinkEnd from = end_at(first, tree), to = end_at(second, tree);
    std::vector<std::string> doubts;
    if (from.system != to.system && from.system != VascularSystem::unknown &&
        to.system != VascularSystem::unknown)
        doubts.push_back(
            "The link joins two systems, which do not meet in a liver: what hangs "
            "together with its second end (" +
            title_of(to.system) + ") belongs to the system of its first (" + title_of(from.system) +
            ") from now on.");
    const double gap_mm =
        (from.at.position_mm - to.at.position_mm).norm() - from.at.radius_mm - to.at.radius_mm;
    const double wider_mm = 2.0 * std::max(from.at.radius_mm, to.at.radius_mm);
    if (gap_mm > std::min(long_gap_mm, long_gap_diameters * wider_mm))
        doubts.push_back("The link leads over " + gap_text(gap_mm) +
                         " from wall to wall, farther than a gap in one vessel is likely to be.");
    return doubts;
}

}  // namespace hepatica
