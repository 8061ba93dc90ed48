// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of contact search as they are today: what is near, when it meets, what overlaps, and how
// often it had to be searched.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/contact/overlaps.h"
#include "core/contact/pair_cover.h"
#include "core/contact/patch_tree.h"
#include "core/contact/rigid_fit.h"
#include "core/contact/time_of_contact.h"
#include "core/contact/torn_sides.h"
#include "tests/contact/bodies.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;
using test::RandomFeatures;

template <class Numbers>
void append_all(std::vector<double>& to, const Numbers& numbers) {
    for (const auto number : numbers) to.push_back(static_cast<double>(number));
}

TEST(ContactFigures, OfClosestPoints) {
    RandomFeatures random(901);
    std::vector<double> numbers;
    for (int i = 0; i < 400; ++i) {
        const Vec3 point = random.point();
        const Segment segment = random.segment(), other = random.segment();
        const Triangle triangle = random.triangle(), second = random.triangle();
        const PointSegment a = closest(point, segment);
        const PointTriangle b = closest(point, triangle);
        const SegmentSegment c = closest(segment, other);
        const SegmentTriangle d = closest(segment, triangle);
        append_all(numbers, std::vector{a.along, a.squared_mm2, b.squared_mm2, c.along_first,
                                        c.along_second, c.squared_mm2, d.along, d.squared_mm2,
                                        squared_distance_mm2(triangle, second)});
        append_all(numbers, b.weights);
        append_all(numbers, d.weights);
    }
    expect_recorded("contact", "closest", Figures().add("all", numbers));
}

TEST(ContactFigures, OfTimesOfContact) {
    RandomFeatures random(902);
    std::vector<double> numbers;
    for (int i = 0; i < 400; ++i) {
        const double gap = random.in(0.0, 0.2), tolerance = 0.01 + random.in(0.0, 0.05);
        const Motion<Segment> first{random.segment(), random.segment(3.0)};
        const Motion<Segment> second{random.segment(), random.segment(3.0)};
        const Motion<Triangle> triangle{random.triangle(), random.triangle(3.0)};
        const Motion<Vec3> point{random.point(2.0), random.point(2.0)};
        numbers.push_back(time_of_contact(point, triangle, gap, tolerance).value_or(2.0));
        numbers.push_back(time_of_contact(first, second, gap, tolerance).value_or(2.0));
        numbers.push_back(time_of_contact(first, triangle, gap, tolerance).value_or(2.0));
    }
    expect_recorded("contact", "times", Figures().add("all", numbers));
}

// Beside the closed surfaces of other tests: triangles all over the place.
TEST(ContactFigures, OfCapsules) {
    RandomFeatures random(903);
    std::vector<double> near, shares, ways;
    for (int i = 0; i < 40; ++i) {
        const test::Soup soup = test::soup_of(random, 30, 5.0);
        const std::array capsules{test::capsule_of(random), test::capsule_of(random)};
        for (const NearTriangle& t : near_capsule(capsules[0], soup.surface, soup.vertices, 1.1)) {
            append_all(near, std::vector{static_cast<double>(t.triangle), t.gap_mm});
            append_all(near, t.weights);
            append_all(near, t.normal);
            append_all(near, t.on_axis_mm);
        }
        std::vector<Vec3> to = soup.vertices;
        for (Vec3& x : to) x += random.point(2.0);
        for (const double kept : {0.02, 0.3})
            shares.push_back(free_share(capsules[0], soup.surface, soup.vertices, to,
                                        [&](double gap) { return std::min(kept, 0.5 * gap); }));
        const Vec3 motion = random.point(6.0);
        append_all(ways, approach(capsules, {{soup.surface, soup.vertices}}, motion, 0.05));
        append_all(ways, slide(capsules, {{soup.surface, soup.vertices}}, motion, 0.05));
        std::array after = capsules;
        for (Capsule& capsule : after) {
            capsule.centre_mm += motion;
            capsule.half_axis_mm = random.point(2.0);
        }
        shares.push_back(sweep_share(capsules, after, {{soup.surface, soup.vertices}}, 0.05));
    }
    expect_recorded("contact", "capsules",
                    Figures().add("near", near).add("shares", shares).add("ways", ways));
}

TEST(ContactFigures, OfPatchesAndFeatures) {
    std::mt19937 chance(904);
    const test::Bar bar(chance);
    test::Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.2);
    boxes.add(Vec3(1, 0.5, 1.7), 1.0, 0.8);
    boxes.add(Vec3(20, 0, 0), 0.0);
    Figures figures;
    for (const bool of_bar : {false, true}) {
        const std::vector<Vec3>& x = of_bar ? bar.rest : boxes.mesh.vertices_mm;
        const SurfaceFeatures features(
            SurfacePatches(boundary_triangles(of_bar ? bar.mesh : boxes.mesh)), x);
        std::vector<double> numbers{static_cast<double>(features.pieces())};
        for (std::size_t p = 0; p < features.surface().size(); ++p) {
            append_all(numbers, features.surface().triangles_of(p));
            append_all(numbers, features.surface().vertices_of(p));
            append_all(numbers, features.neighbours_above(static_cast<int>(p)));
            append_all(numbers, features.surface().box(p, x).low);
            append_all(numbers, features.surface().box(p, x).high);
            numbers.push_back(features.piece_of_patch(static_cast<int>(p)));
        }
        for (std::size_t t = 0; t < features.surface().triangles().size(); ++t) {
            append_all(numbers, features.nodes_owned_by(static_cast<int>(t)));
            append_all(numbers, features.edges_owned_by(static_cast<int>(t)));
        }
        std::vector<double> areas;
        for (const int node : features.nodes()) {
            areas.push_back(features.area_of_node_mm2(node));
            append_all(numbers, features.patches_of_node(node));
        }
        for (int e = 0; e < std::ssize(features.edges()); ++e) {
            areas.push_back(features.area_of_edge_mm2(e));
            append_all(numbers, features.patches_of_edge(e));
        }
        const std::string name = of_bar ? "bar" : "boxes";
        figures.add(name, numbers).add(name + ".areas", areas);
        std::vector<double> found;
        Box box;
        box.add(Vec3(-1, -0.3, -0.2));
        box.add(Vec3(2, 1, 1.3));
        append_all(found, features.surface().triangles_in(box, x));
        figures.add(name + ".in_box", found);
    }
    expect_recorded("contact", "features", figures);
}

TEST(ContactFigures, OfPairsAlongMotions) {
    std::mt19937 chance(905);
    const test::Bar bar(chance);
    const SurfaceFeatures features(SurfacePatches(boundary_triangles(bar.mesh)), bar.rest);
    PairCover cover(features, 0.3, 0.15);
    const Vec3 axis = Vec3(2, 1, -1).normalized();
    std::vector<Vec3> from = bar.bent(0.02, Eigen::AngleAxisd(0.0, axis), Vec3::Zero());
    std::vector<double> numbers, searches;
    const auto none = [](int, int) { return false; };
    // It is bent until its ends meet, so that there are strangers, too.
    for (int step = 1; step <= 16; ++step) {
        const std::vector<Vec3> to = bar.bent(
            0.02 + 0.031 * step, Eigen::AngleAxisd(0.15 * step, axis), 0.4 * step * Vec3::UnitY());
        std::vector<FeaturePair> pairs = cover.along(from, to, none);
        std::ranges::sort(pairs, {}, [](const FeaturePair& p) {
            return std::tuple(p.of_edges, p.first, p.second);
        });
        for (const FeaturePair& pair : pairs) {
            append_all(numbers, std::array{pair.of_edges ? 1 : 0, pair.first, pair.second});
            append_all(numbers, pair.nodes);
        }
        searches.push_back(cover.answers());
        searches.push_back(cover.searches());
        std::vector<Vec3> middle = from;
        for (std::size_t i = 0; i < from.size(); ++i)
            middle[i] += 0.5 * (to[i] - from[i]) + (step % 2 ? 0.001 : 0.002) * axis;
        searches.push_back(static_cast<double>(cover.along(middle, middle, none).size()));
        searches.push_back(cover.answers());
        from = to;
    }
    expect_recorded("contact", "pairs", Figures().add("pairs", numbers).add("searches", searches));
}

TEST(ContactFigures, OfTreesOfBoxes) {
    RandomFeatures random(906);
    std::vector<Box> boxes(60);
    std::vector<double> numbers;
    for (int round = 0; round < 5; ++round) {
        for (std::size_t b = round == 0 ? 0 : 40; b < boxes.size(); ++b) {
            boxes[b] = {};
            const Vec3 at = random.point(4.0);
            boxes[b].add(at);
            boxes[b].add(at + random.point());
        }
        PatchTree tree(boxes);
        for (const auto& pair : tree.meeting_pairs()) append_all(numbers, pair);
        for (Box& box : boxes) box.grow(0.1);
        tree.refit(boxes);
        for (const auto& pair : tree.meeting_pairs()) append_all(numbers, pair);
    }
    expect_recorded("contact", "tree", Figures().add("pairs", numbers));
}

TEST(ContactFigures, OfRigidFits) {
    RandomFeatures random(907);
    std::vector<double> numbers;
    for (int i = 0; i < 60; ++i) {
        std::vector<Vec3> shape(9), now(9);
        std::vector<int> nodes(9);
        Vec3 mean = Vec3::Zero();
        for (Vec3& x : shape) x = random.point(), mean += x / 9.0;
        for (Vec3& x : shape) x -= mean;
        const double angle = 0.06 * i;
        const Eigen::AngleAxisd turn(angle, random.point().normalized());
        for (int k = 0; k < 9; ++k) {
            nodes[k] = 8 - k;
            now[8 - k] = turn * shape[k] + Vec3(3, -2, 1) + random.point(0.001 * i);
        }
        const RigidFit fit = fit_rigid(shape, nodes, now, Eigen::Quaterniond::Identity());
        append_all(numbers, fit.turn.toRotationMatrix().reshaped());
        numbers.push_back(fit.beside_mm);
    }
    expect_recorded("contact", "rigid", Figures().add("fits", numbers));
}

void add_overlaps(Figures& figures, const std::string& name, const Overlaps& overlaps) {
    std::vector<double> numbers;
    for (const auto& pair : overlaps.touching()) append_all(numbers, pair);
    numbers.push_back(-1.0);
    for (const auto& pair : overlaps.buried()) append_all(numbers, pair);
    figures.add(name, numbers);
}

TEST(ContactFigures, OfOverlapsThatComeApart) {
    test::Boxes boxes;
    boxes.add(Vec3(0, 0, 0), 0.0);
    boxes.add(Vec3(0.2, 0.1, 0), 0.3, 0.3);
    boxes.add(Vec3(0.1, 0, 1.8), 1.2);
    boxes.add(Vec3(6.05, 0.2, 0.1), 0.0, 0.9);
    boxes.add(Vec3(-5.3, 0.2, 0.4), 0.7);
    const SurfaceFeatures features = boxes.features(4);
    Overlaps overlaps(features);
    std::vector<Vec3> x = boxes.mesh.vertices_mm;
    Figures figures;
    for (const double touch : {0.01, 0.3}) {
        overlaps.find(x, touch);
        add_overlaps(figures, "touch" + std::to_string(touch), overlaps);
    }
    const std::size_t fifth = x.size() / 5;
    for (int step = 0; step < 9; ++step) {
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] += 0.25 * static_cast<double>(i / fifth) * Vec3(0.1, 0.3, 0.2);
        figures.add("freed" + std::to_string(step), overlaps.let_go(x, 0.25) ? 1.0 : 0.0);
        add_overlaps(figures, "apart" + std::to_string(step), overlaps);
    }
    expect_recorded("contact", "overlaps", figures);
}

// Parts the second of three boxes between its cells: what lies beyond the cut gets vertices of its
// own.
std::vector<int> part_second_box(TetMesh& mesh) {
    const std::size_t third = mesh.vertices_mm.size() / 3, tetrahedra = mesh.tetrahedra.size() / 3;
    std::vector<int> before(mesh.vertices_mm.size());
    std::iota(before.begin(), before.end(), 0);
    std::map<int, int> copy;
    constexpr int row = 4;
    for (std::size_t t = tetrahedra; t < 2 * tetrahedra; ++t) {
        const bool beyond = t - tetrahedra >= tetrahedra / 3;
        for (int& v : mesh.tetrahedra[t]) {
            if (!beyond || (v - static_cast<int>(third)) % row != 1) continue;
            const auto [entry, added] =
                copy.try_emplace(v, static_cast<int>(mesh.vertices_mm.size()));
            if (added) {
                mesh.vertices_mm.push_back(Vec3(mesh.vertices_mm[v]));
                before.push_back(v);
            }
            v = entry->second;
        }
    }
    return before;
}

// One box within another, and a third that touches both; the second is torn.
TEST(ContactFigures, OfOverlapsAfterATear) {
    Figures figures;
    for (const double lift : {1.2, 1.95, 2.3}) {
        test::Boxes boxes;
        boxes.add(Vec3(0, 0, 0), 0.0);
        boxes.add(Vec3(0.7, 0.3, lift), 0.4);
        boxes.add(Vec3(1.0, 0.2, lift + 0.1), 0.1, 0.25);
        const SurfaceFeatures whole = boxes.features(4);
        Overlaps overlaps(whole);
        overlaps.find(boxes.mesh.vertices_mm, 0.05);
        const OverlapsBefore before{whole, overlaps.touching(), overlaps.buried()};
        const std::vector<int> node_before = part_second_box(boxes.mesh);
        const SurfaceFeatures torn = boxes.features(4);
        EXPECT_EQ(torn.pieces(), 4);
        TornSides sides(torn);
        const Overlaps::Pairs parted = sides.follow_split({}, node_before, node_before);
        for (const double reach : {0.02, 0.3})
            for (const Overlaps::Pairs* around_twins :
                 {static_cast<const Overlaps::Pairs*>(nullptr), &parted}) {
                Overlaps after(torn);
                after.follow_split(before, node_before, boxes.mesh.vertices_mm, reach,
                                   around_twins);
                add_overlaps(figures,
                             "lift" + std::to_string(lift) + "_reach" + std::to_string(reach) +
                                 (around_twins ? "_parted" : ""),
                             after);
            }
    }
    expect_recorded("contact", "torn", figures);
}

}  // namespace
}  // namespace hepatica
