// SPDX-License-Identifier: GPL-3.0-or-later
// Fits axes to the links outside a node, solves a 3 x 3 system for their meeting point, and redraws
// the links.
#include "core/tree/extraction/fork_placement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

#include "core/tree/extraction/centreline.h"

namespace hepatica {

namespace {

constexpr double pull_to_old_place = 0.02;  // against 1 per axis: matters only along parallel axes

// A link at one of its ends: where it leaves the node's lumen, and its axis there.
struct Exit {
    int link;
    bool at_from;       // the node is the link's first point
    std::size_t first;  // number of points between the node and the axis, counted from the node
    Vec3 position_mm;   // of the axis
    Vec3 direction;
};

class Placer {
  public:
    Placer(VesselGraph& graph, const std::vector<std::vector<std::uint8_t>>& reliable,
           double voxel_mm)
        : graph_(graph), reliable_(reliable), voxel_mm_(voxel_mm) {}

    void run() {
        const auto at_node = links_of_nodes(graph_);
        std::vector<Exit> all;
        for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
            if (at_node[n].size() < 3) continue;
            std::vector<Exit> exits;
            for (std::size_t k = 0; k < at_node[n].size(); ++k) {
                const int id = at_node[n][k];
                const bool ring_again = k > 0 && at_node[n][k - 1] == id;
                add_exit(id, graph_.links[id].from == static_cast<int>(n) && !ring_again, exits);
            }
            if (exits.size() < 2) continue;
            graph_.nodes[n].position_mm = meeting_point(graph_.nodes[n], exits);
            all.insert(all.end(), exits.begin(), exits.end());
        }
        // After all nodes, because a link's other end needs the original points.
        std::ranges::stable_sort(
            all, {}, [](const Exit& exit) { return std::pair(exit.link, exit.at_from); });
        for (const Exit& exit : all) lay(exit);
        for (VesselLink& link : graph_.links) {
            link.points_mm.front() = graph_.nodes[link.from].position_mm;
            link.points_mm.back() = graph_.nodes[link.to].position_mm;
        }
    }

  private:
    // The axis of a link just outside the node's lumen: principal direction of its reliable points.
    void add_exit(int id, bool at_from, std::vector<Exit>& exits) const {
        const VesselLink& link = graph_.links[id];
        const std::size_t n = link.points_mm.size();
        const std::vector<double> at_mm = arclengths_mm(link.points_mm);
        const double wall_mm = graph_.nodes[at_from ? link.from : link.to].radius_mm;
        const auto point = [&](std::size_t k) { return at_from ? k : n - 1 - k; };
        const auto away_mm = [&](std::size_t k) {
            return at_from ? at_mm[k] : at_mm.back() - at_mm[n - 1 - k];
        };
        std::size_t first = 1;
        while (first < n && (away_mm(first) < wall_mm || reliable_[id][point(first)] == 0)) ++first;
        const double window_mm = std::max(wall_mm, 4.0 * voxel_mm_);
        std::vector<Vec3> stretch;
        for (std::size_t k = first; k < n && away_mm(k) <= away_mm(first) + window_mm; ++k)
            if (reliable_[id][point(k)] != 0) stretch.push_back(link.points_mm[point(k)]);
        if (stretch.size() < 3) return;
        Exit exit{id, at_from, first, Vec3::Zero(), Vec3::Zero()};
        for (const Vec3& p : stretch) exit.position_mm += p / static_cast<double>(stretch.size());
        Mat3 spread = Mat3::Zero();
        for (const Vec3& p : stretch)
            spread += (p - exit.position_mm) * (p - exit.position_mm).transpose();
        exit.direction = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().col(2);
        exits.push_back(exit);
    }

    // The point with the least sum of squared distances to the axes.
    Vec3 meeting_point(const VesselNode& node, const std::vector<Exit>& exits) const {
        Mat3 matrix = pull_to_old_place * Mat3::Identity();
        Vec3 right = pull_to_old_place * node.position_mm;
        for (const Exit& exit : exits) {
            const Mat3 across = Mat3::Identity() - exit.direction * exit.direction.transpose();
            matrix += across;
            right += across * exit.position_mm;
        }
        const Vec3 move = matrix.ldlt().solve(right) - node.position_mm;
        const double farthest = node.radius_mm + 2.0 * voxel_mm_;
        return node.position_mm + move * std::min(1.0, farthest / std::max(move.norm(), 1e-12));
    }

    // Moves the points between the node and the axis onto a straight line.
    void lay(const Exit& exit) {
        VesselLink& link = graph_.links[exit.link];
        const std::size_t n = link.points_mm.size();
        const Vec3 node = graph_.nodes[exit.at_from ? link.from : link.to].position_mm;
        const auto point = [&](std::size_t k) { return exit.at_from ? k : n - 1 - k; };
        const Vec3 target = link.points_mm[point(exit.first)];
        for (std::size_t k = 0; k < exit.first; ++k)
            link.points_mm[point(k)] =
                node + (target - node) * (static_cast<double>(k) / static_cast<double>(exit.first));
    }

    VesselGraph& graph_;
    const std::vector<std::vector<std::uint8_t>>& reliable_;
    double voxel_mm_;
};

}  // namespace

void place_forks(VesselGraph& graph, const std::vector<std::vector<std::uint8_t>>& reliable,
                 double voxel_mm) {
    Placer(graph, reliable, voxel_mm).run();
}

}  // namespace hepatica
