// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the radius of each root with the widest end of its tree.
#include "core/tree/systems/doubtful_roots.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>
#include <utility>

#include "core/base/median.h"
#include "core/base/patient_space.h"

namespace hepatica {
namespace {

constexpr double measured_over_mm = 5.0;
constexpr double least_end_mm = 2.5;  // differences of narrower ends are within the resolution
constexpr double clearly_wider = 1.5;

// An end of a segment with the median radius over its last 5 mm.
SystemRoot end_of(const VesselSegment& segment, bool distal) {
    const std::size_t count = segment.points_mm.size();
    const auto index = [&](std::size_t from_end) {
        return distal ? count - 1 - from_end : from_end;
    };
    std::vector<double> radii;
    double along_mm = 0.0;
    for (std::size_t i = 0; i < count && along_mm <= measured_over_mm; ++i) {
        radii.push_back(segment.radii_mm[index(i)]);
        if (i + 1 < count)
            along_mm += (segment.points_mm[index(i + 1)] - segment.points_mm[index(i)]).norm();
    }
    return {segment.points_mm[index(0)], median(std::move(radii))};
}

}  // namespace

std::vector<DoubtfulRoot> doubtful_roots(const VesselTree& tree) {
    const std::vector<std::vector<int>> below = children(tree);
    const std::vector<int> degrees = node_degrees(tree);
    std::vector<int> root_of(tree.segments.size());
    std::vector<DoubtfulRoot> trees(tree.segments.size());  // by root segment
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        // A parent stands before its children.
        root_of[s] = segment.parent < 0 ? static_cast<int>(s)
                                        : root_of[static_cast<std::size_t>(segment.parent)];
        DoubtfulRoot& whole = trees[static_cast<std::size_t>(root_of[s])];
        if (segment.parent < 0) whole = {segment.system, end_of(segment, false), {}};
        if (!below[s].empty() || degrees[static_cast<std::size_t>(segment.distal_node)] != 1)
            continue;
        const SystemRoot end = end_of(segment, true);
        if (end.radius_mm > whole.wider_end.radius_mm) whole.wider_end = end;
    }
    std::vector<DoubtfulRoot> doubted;
    for (const int root : roots(tree)) {
        const DoubtfulRoot& whole = trees[static_cast<std::size_t>(root)];
        const double limit = std::max(least_end_mm, clearly_wider * whole.root.radius_mm);
        if (whole.wider_end.radius_mm >= limit) doubted.push_back(whole);
    }
    return doubted;
}

std::vector<std::string> sentences(const std::vector<DoubtfulRoot>& roots) {
    std::vector<std::string> list;
    for (const DoubtfulRoot& one : roots) {
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << std::fixed << std::setprecision(1) << "In one tree (" << title_of(one.system)
             << ") blood comes in at an end of " << one.root.radius_mm << " mm radius ("
             << place_text(one.root.at_mm) << "), and the end at "
             << place_text(one.wider_end.at_mm) << ", of " << one.wider_end.radius_mm
             << " mm, is a wide way out for it. If that one is the trunk, set the root there.";
        list.push_back(text.str());
    }
    return list;
}

}  // namespace hepatica
