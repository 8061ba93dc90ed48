// SPDX-License-Identifier: GPL-3.0-or-later
// A portal vein as textbooks draw it, in the phantom's liver, whose every branch carries the number
// of the segment that it was drawn for; and the three hepatic veins between them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/phantom/phantom_body.h"
#include "core/tree/extraction/vessel_graph.h"
#include "tests/support/test_trees.h"

namespace hepatica::test {

// How the trunk divides: into left and right, into three, or the right posterior branch leaves it
// first.
enum class PortalType { usual, trifurcation, early_posterior };

struct TextbookPatient {
    Mask liver;
    VesselTree tree;
    std::vector<int> segment;  // of each branch of the tree: 1 to 8, 0 for what supplies several
    Vec3 bifurcation_mm = Vec3::Zero();
};

inline Mask liver_of_phantom(double spacing_mm) {
    const PhantomBody body(1, 110.0);
    const Vec3 low = PhantomBody::liver_low(), size = PhantomBody::liver_high() - low;
    Grid grid;
    grid.spacing_mm = Vec3::Constant(spacing_mm);
    grid.origin_mm = low;
    for (int a = 0; a < 3; ++a) grid.dims[a] = static_cast<int>(size[a] / spacing_mm) + 1;
    Mask liver(grid);
    for (std::size_t i = 0; i < liver.voxels.size(); ++i) {
        const auto [x, y, z] = grid.index_of(i);
        liver.voxels[i] = body.liver_distance_mm(grid.to_mm(x, y, z)) <= 0.0 ? 1 : 0;
    }
    return liver;
}

class TextbookDrawing {
  public:
    int node(const Vec3& at, double radius_mm) {
        graph_.nodes.push_back({at, radius_mm});
        return static_cast<int>(graph_.nodes.size()) - 1;
    }
    // From a node to a new one; returns that.
    int branch(int from, const Vec3& to, double radius_mm, int segment,
               VascularSystem system = VascularSystem::portal) {
        const int end = node(to, radius_mm);
        graph_.links.push_back(
            straight_link(graph_, from, end, 1.1 * radius_mm, radius_mm, system));
        segment_of_end_[end] = segment;
        return end;
    }
    // A branch that forks into two at its end.
    void segmental(int from, const Vec3& to, const Vec3& spread, int segment) {
        const int fork = branch(from, to, 2.0, segment);
        const Vec3 on = to - graph_.nodes[from].position_mm;
        branch(fork, to + 0.3 * on + spread, 1.3, segment);
        branch(fork, to + 0.3 * on - spread, 1.2, segment);
    }
    TextbookPatient finished(Mask liver, int root, int cava) {
        TextbookPatient patient;
        std::vector<RootWish> wishes{{root, VascularSystem::portal}};
        if (cava >= 0) wishes.push_back({cava, VascularSystem::hepatic});
        patient.tree = directed(graph_, wishes);
        for (const VesselSegment& branch : patient.tree.segments)
            for (const auto& [end, segment] : segment_of_end_)
                if (graph_.nodes[end].position_mm == branch.points_mm.back())
                    patient.segment.push_back(segment);
        patient.liver = std::move(liver);
        return patient;
    }

  private:
    VesselGraph graph_;
    std::map<int, int> segment_of_end_;
};

inline TextbookPatient textbook_patient(PortalType type, bool hepatic_veins, Mask liver) {
    TextbookDrawing draw;
    const Vec3 hilum(-40, 10, -10);
    const int root = draw.node(Vec3(-20, 24, -38), 6.0);
    int trunk = root;
    int posterior = -1;
    if (type == PortalType::early_posterior) {
        trunk = draw.branch(root, Vec3(-33, 15, -20), 6.0, 0);
        posterior = draw.branch(trunk, Vec3(-88, 30, -8), 3.5, 0);
    }
    trunk = draw.branch(trunk, hilum, 5.5, 0);
    int anterior;
    if (type == PortalType::usual) {
        const int right = draw.branch(trunk, Vec3(-62, 10, -6), 4.5, 0);
        anterior = draw.branch(right, Vec3(-74, -4, -2), 3.5, 0);
        posterior = draw.branch(right, Vec3(-88, 28, -6), 3.5, 0);
    } else {
        anterior = draw.branch(trunk, Vec3(-72, -4, -3), 3.8, 0);
        if (posterior < 0) posterior = draw.branch(trunk, Vec3(-86, 28, -7), 3.6, 0);
    }
    draw.segmental(anterior, Vec3(-80, -26, -32), Vec3(10, 3, 0), 5);
    draw.segmental(anterior, Vec3(-78, -22, 32), Vec3(12, -4, 0), 8);
    draw.segmental(posterior, Vec3(-104, 34, -38), Vec3(3, 10, 0), 6);
    draw.segmental(posterior, Vec3(-98, 40, 26), Vec3(4, 10, 0), 7);
    const int left_root = draw.branch(trunk, Vec3(-24, -2, -2), 4.2, 0);
    const int left = draw.branch(left_root, Vec3(-8, -16, 8), 4.0, 0);
    draw.branch(left_root, Vec3(-20, 26, 10), 1.2, 1);
    const int umbilical = draw.branch(left, Vec3(0, -34, 14), 3.5, 0);
    draw.segmental(umbilical, Vec3(-32, -44, 8), Vec3(2, 3, 12), 4);
    draw.segmental(left, Vec3(28, -22, 34), Vec3(4, 6, 2), 2);
    draw.segmental(umbilical, Vec3(26, -50, 8), Vec3(4, -4, -2), 3);
    int cava = -1;
    if (hepatic_veins) {
        const auto system = VascularSystem::hepatic;
        cava = draw.node(Vec3(-27, 34, 44), 8.0);
        draw.branch(cava, Vec3(-110, 0, 0), 3.5, 0, system);
        draw.branch(cava, Vec3(-52, -55, -5), 3.2, 0, system);
        draw.branch(cava, Vec3(22, -38, 22), 3.0, 0, system);
    }
    TextbookPatient patient = draw.finished(std::move(liver), root, cava);
    patient.bifurcation_mm = type == PortalType::early_posterior ? Vec3(-33, 15, -20) : hilum;
    return patient;
}

}  // namespace hepatica::test
