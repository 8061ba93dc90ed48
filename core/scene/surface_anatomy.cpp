// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/surface_anatomy.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <locale>
#include <sstream>

#include "core/base/parallel.h"

namespace hepatica {

SurfaceAnatomy::SurfaceAnatomy(const VesselTree& tree, std::span<const Vec3> rest_positions_mm,
                               Job& job) {
    points_.resize(rest_positions_mm.size());
    constexpr std::size_t batch = 2048;
    for (std::size_t begin = 0; begin < points_.size(); begin += batch) {
        job.advance(static_cast<double>(begin) / static_cast<double>(points_.size()));
        const std::size_t count = std::min(batch, points_.size() - begin);
        parallel_blocks(count, 64, [&](std::size_t from, std::size_t to) {
            for (std::size_t v = begin + from; v < begin + to; ++v) {
                points_[v] = nearest_point(tree, rest_positions_mm[v]);
            }
        });
    }
    const std::size_t segments = tree.segments.size();
    parent_.resize(segments);
    system_.resize(segments);
    length_mm_.resize(segments);
    root_.resize(segments);
    ends_.assign(segments, 0);
    std::vector<bool> has_child(segments, false);
    for (std::size_t s = 0; s < segments; ++s) {
        parent_[s] = tree.segments[s].parent;
        system_[s] = tree.segments[s].system;
        length_mm_[s] = length_mm(tree.segments[s]);
        root_[s] =
            parent_[s] < 0 ? static_cast<int>(s) : root_[static_cast<std::size_t>(parent_[s])];
        if (parent_[s] >= 0) has_child[static_cast<std::size_t>(parent_[s])] = true;
    }
    // A parent precedes its children.
    for (std::size_t s = segments; s-- > 0;) {
        if (!has_child[s]) ends_[s] = 1;
        if (parent_[s] >= 0) ends_[static_cast<std::size_t>(parent_[s])] += ends_[s];
    }
}

TreePoint SurfaceAnatomy::tree_point(int vertex) const {
    const auto index = static_cast<std::size_t>(vertex);
    return vertex >= 0 && index < points_.size() ? points_[index] : TreePoint{};
}

std::vector<VascularSystem> SurfaceAnatomy::vertex_systems() const {
    std::vector<VascularSystem> systems;
    systems.reserve(points_.size());
    for (const TreePoint& point : points_) systems.push_back(system_of(point.segment));
    return systems;
}

std::vector<std::uint8_t> SurfaceAnatomy::vertices_of(int segment) const {
    std::vector<std::uint8_t> vertices;
    vertices.reserve(points_.size());
    for (const TreePoint& point : points_) vertices.push_back(point.segment == segment);
    return vertices;
}

std::vector<std::uint8_t> SurfaceAnatomy::downstream_of(const TreePoint& from) const {
    if (from.segment < 0) return {};
    std::vector<std::uint8_t> below(parent_.size(), 0);
    for (std::size_t s = static_cast<std::size_t>(from.segment) + 1; s < parent_.size(); ++s) {
        const int parent = parent_[s];
        below[s] =
            parent >= 0 && (parent == from.segment || below[static_cast<std::size_t>(parent)]);
    }
    std::vector<std::uint8_t> marked(points_.size(), 0);
    for (std::size_t v = 0; v < points_.size(); ++v) {
        const TreePoint& point = points_[v];
        marked[v] = point.segment == from.segment
                        ? point.arclength_mm >= from.arclength_mm
                        : point.segment >= 0 && below[static_cast<std::size_t>(point.segment)];
    }
    return marked;
}

int SurfaceAnatomy::ends_downstream_of(int segment) const {
    return segment < 0 ? 0 : ends_[static_cast<std::size_t>(segment)];
}

int SurfaceAnatomy::ends_in_tree_of(int segment) const {
    return segment < 0 ? 0 : ends_downstream_of(root_[static_cast<std::size_t>(segment)]);
}

int SurfaceAnatomy::ends_in_system_of(int segment) const {
    int sum = 0;
    for (std::size_t s = 0; s < parent_.size(); ++s) {
        if (parent_[s] < 0 && system_[s] == system_of(segment)) sum += ends_[s];
    }
    return sum;
}

std::string SurfaceAnatomy::describe(const TreePoint& point,
                                     std::span<const double> flow_shares) const {
    if (point.segment < 0) return {};
    const int elsewhere = ends_in_system_of(point.segment) - ends_in_tree_of(point.segment);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(0) << "Branch " << point.segment + 1 << " ("
         << title_of(system_of(point.segment)) << "), " << point.arclength_mm << " of "
         << length_mm_[static_cast<std::size_t>(point.segment)]
         << " mm along: " << ends_downstream_of(point.segment) << " of "
         << ends_in_tree_of(point.segment) << " ends "
         << (elsewhere > 0 ? "of this tree lie downstream" : "lie downstream");
    if (static_cast<std::size_t>(point.segment) < flow_shares.size()) {
        const double percent = 100.0 * flow_shares[static_cast<std::size_t>(point.segment)];
        text << std::setprecision(percent < 10.0 ? 1 : 0) << "; they get " << percent
             << (elsewhere > 0 ? " % of its flow" : " % of the flow");
    }
    if (elsewhere > 0) text << "; " << elsewhere << " more ends of the system hang on other roots";
    return text.str();
}

VascularSystem SurfaceAnatomy::system_of(int segment) const {
    return segment < 0 ? VascularSystem::unknown : system_[static_cast<std::size_t>(segment)];
}

}  // namespace hepatica
