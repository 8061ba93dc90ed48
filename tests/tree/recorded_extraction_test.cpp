// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of trees as they are extracted today: from synthetic patients with one or two systems
// that touch, with gaps, crumbs and seeds, measured on their CT or on the mask; their systems,
// territories, edits and files.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/phantom/phantom.h"
#include "core/skeleton/thinning.h"
#include "core/skeleton/unit_width_skeleton.h"
#include "core/tree/editing/tree_edit.h"
#include "core/tree/files/tree_io.h"
#include "core/tree/lumen_calibre.h"
#include "core/tree/system_summary.h"
#include "core/tree/territories/couinaud_segments.h"
#include "core/tree/territories/feeders.h"
#include "core/tree/tree_extraction.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

// A small patient whose systems touch, with its skeleton; made once for each seed.
struct SmallPatient {
    Phantom phantom;
    Mask skeleton;
};

SmallPatient make_patient(std::uint64_t seed, int systems) {
    PhantomOptions options;
    options.seed = seed;
    options.generations = 4;
    options.systems = systems;
    options.touching = systems == 2 ? 2 : 0;
    options.dims = {100, 88, 80};
    options.spacing_mm = {1.2, 1.2, 1.3};
    options.noise_hu = 6.0;
    Job job;
    SmallPatient patient{make_phantom(options, job), {}};
    patient.skeleton = unit_width(thin(patient.phantom.vessels, ThinningMethod::queue, job), job);
    return patient;
}

const SmallPatient& two_systems() {
    static const SmallPatient patient = make_patient(3, 2);
    return patient;
}

void append(std::vector<double>& to, const Vec3& point) {
    to.insert(to.end(), point.begin(), point.end());
}

void add_tree(Figures& figures, const std::string& name, const VesselTree& tree) {
    std::vector<double> topology, points, radii, bridged;
    for (const VesselSegment& s : tree.segments) {
        for (const double value : {double(s.proximal_node), double(s.distal_node), double(s.parent),
                                   double(static_cast<int>(s.system)), s.system_confidence,
                                   double(s.strahler_order), double(s.closes_loop)})
            topology.push_back(value);
        for (const Vec3& point : s.points_mm) append(points, point);
        radii.insert(radii.end(), s.radii_mm.begin(), s.radii_mm.end());
        bridged.insert(bridged.end(), s.bridged.begin(), s.bridged.end());
    }
    for (const VesselNode& node : tree.nodes) {
        append(points, node.position_mm);
        radii.push_back(node.radius_mm);
    }
    figures.add(name + ".topology", topology)
        .add(name + ".points", points)
        .add(name + ".radii", radii)
        .add(name + ".bridged", bridged);
}

void add_extraction(Figures& figures, const std::string& name, const TreeExtraction& found) {
    add_tree(figures, name, found.tree);
    std::vector<double> bridges;
    for (const Bridge& bridge : found.bridges) {
        for (const Vec3& point : bridge.path_mm) append(bridges, point);
        for (const double value : {bridge.from_radius_mm, bridge.to_radius_mm, bridge.gap_mm,
                                   bridge.confidence, double(bridge.built)})
            bridges.push_back(value);
    }
    figures.add(name + ".bridges", bridges)
        .add(name + ".left_out", std::vector{double(found.too_short.count),
                                             found.too_short.length_mm, double(found.blobs.count),
                                             found.blobs.length_mm, double(found.opened_loops)});
    if (!found.systems) return;
    figures.add(name + ".evidence",
                std::vector{found.systems->brightness_difference, found.systems->gain});
}

// With holes across branches, and crumbs beside them.
Mask with_gaps(const SmallPatient& patient) {
    Mask vessels = patient.phantom.vessels;
    const VesselTree& truth = patient.phantom.tree;
    for (std::size_t s = 2; s < truth.segments.size(); s += 3) {
        const auto& points = truth.segments[s].points_mm;
        const Vec3 middle = points[points.size() / 2];
        for (std::size_t i = 0; i < vessels.voxels.size(); ++i) {
            const auto [x, y, z] = vessels.grid.index_of(i);
            if ((vessels.grid.to_mm(x, y, z) - middle).norm() < 3.2) vessels.voxels[i] = 0;
        }
    }
    for (int x = 4; x < 9; ++x) vessels.at(x, 5, 6) = vessels.at(x, 6, 6) = 1;
    return vessels;
}

TEST(TreeFigures, OfExtractions) {
    const SmallPatient& patient = two_systems();
    Figures figures;
    Job job;
    const Volume* const ct = &patient.phantom.ct;
    add_extraction(
        figures, "by_mask",
        extract_tree_and_bridges(patient.skeleton, patient.phantom.vessels, nullptr, {}, job));
    add_extraction(
        figures, "by_ct",
        extract_tree_and_bridges(patient.skeleton, patient.phantom.vessels, ct, {}, job));
    TreeOptions options;
    options.roots_mm = {Vec3(40, 30, 20), Vec3(-500, 0, 0)};
    options.spur_radii = 1.5;
    options.minimum_piece_mm = 8.0;
    options.minimum_component_mm = 40.0;
    add_extraction(
        figures, "wishes",
        extract_tree_and_bridges(patient.skeleton, patient.phantom.vessels, ct, options, job));
    const Mask gaps = with_gaps(patient);
    const Mask skeleton = unit_width(thin(gaps, ThinningMethod::queue, job), job);
    for (const double confidence : {0.05, 0.25, 0.9}) {
        TreeOptions bridging;
        bridging.bridging.confidence = confidence;
        add_extraction(figures, "gaps" + std::to_string(confidence),
                       extract_tree_and_bridges(skeleton, gaps, ct, bridging, job));
    }
    expect_recorded("tree", "extractions", figures);
}

TEST(TreeFigures, OfSystemsToldApart) {
    Figures figures;
    Job job;
    for (const std::uint64_t seed : {3u, 8u}) {
        const SmallPatient other = seed == 3 ? SmallPatient{} : make_patient(seed, 2);
        const SmallPatient& patient = seed == 3 ? two_systems() : other;
        Mask vessels = patient.phantom.vessels;
        for (std::uint8_t& voxel : vessels.voxels)
            if (voxel != 0) voxel = static_cast<std::uint8_t>(VascularSystem::unknown);
        TreeOptions options;
        options.find_systems = true;
        const Grid& grid = vessels.grid;
        options.liver_mm = Eigen::AlignedBox3d(grid.to_mm(8, 8, 8), grid.to_mm(90, 80, 70));
        for (const bool seeded : {false, true}) {
            if (seeded) {
                options.seeds = {
                    {patient.phantom.tree.segments[0].points_mm[1], VascularSystem::hepatic}};
                options.portal_trunk_mm = grid.to_mm(50, 40, 10);
            }
            add_extraction(figures, "seed" + std::to_string(seed) + (seeded ? ".seeded" : ".alone"),
                           extract_tree_and_bridges(patient.skeleton, vessels, &patient.phantom.ct,
                                                    options, job));
        }
    }
    expect_recorded("tree", "systems", figures);
}

TEST(TreeFigures, OfSummariesAndTerritories) {
    const SmallPatient& patient = two_systems();
    const VesselTree& tree = patient.phantom.tree;
    Figures figures;
    Job job;
    std::vector<double> summary;
    for (const SystemSummary& system : systems_of(tree)) {
        for (const double value : {double(static_cast<int>(system.system)), system.length_mm,
                                   system.confidence, double(system.loops)})
            summary.push_back(value);
        for (const SystemRoot& root : system.roots) {
            append(summary, root.at_mm);
            summary.push_back(root.radius_mm);
        }
    }
    std::vector<double> calibres;
    for (const VesselSegment& segment : tree.segments)
        for (const Vec3& point : segment.points_mm)
            if (const auto found = calibre_at(tree, point + Vec3(0.3, -0.2, 0.1)))
                for (const double value :
                     {double(found->segment), found->arclength_mm, found->diameter_mm,
                      found->reference_mm.value_or(-1.0), found->stenosis.value_or(-9.0)})
                    calibres.push_back(value);
    figures.add("summary", summary).add("calibres", calibres);
    const auto segments = couinaud_segments(tree, patient.phantom.liver, job);
    ASSERT_TRUE(segments.has_value());
    std::vector<double> labels;
    for (const BranchLabel& label : segments->branches) {
        labels.push_back(label.segment);
        labels.push_back(label.confidence);
    }
    figures.add("couinaud.labels", labels)
        .add("couinaud.voxels", segments->labels.voxels)
        .add("couinaud.unsure", segments->unsure_share);
    Mask tumours(patient.phantom.liver.grid);
    for (std::size_t i = 0; i < tumours.voxels.size(); ++i) {
        const auto [x, y, z] = tumours.grid.index_of(i);
        const bool in_liver = patient.phantom.liver.voxels[i] != 0;
        if (in_liver && x > 30 && x < 50 && y > 30 && y < 46) tumours.voxels[i] = 10;
        if (in_liver && z > 44 && x > 56) tumours.voxels[i] = 11;
    }
    std::vector<double> shares;
    for (const auto& feeders : feeders_of(tree, patient.phantom.liver, tumours, {10, 11}, job))
        for (const Feeder& feeder : feeders)
            for (const double value :
                 {double(feeder.segment), double(static_cast<int>(feeder.system)), feeder.share})
                shares.push_back(value);
    figures.add("feeders", shares);
    expect_recorded("tree", "territories", figures);
}

TEST(TreeFigures, OfEditsAndFiles) {
    VesselTree tree = two_systems().phantom.tree;
    const auto middle = [&](std::size_t segment) {
        const auto& points = tree.segments[segment].points_mm;
        return points[points.size() / 2];
    };
    const Vec3 far_end = tree.segments.back().points_mm.back();
    const auto edit = [](TreeEditKind kind, const Vec3& at_mm) {
        TreeEdit one;
        one.kind = kind;
        one.at_mm = at_mm;
        return one;
    };
    std::vector<TreeEdit> edits{
        edit(TreeEditKind::cut_link, middle(2)), edit(TreeEditKind::add_link, far_end),
        edit(TreeEditKind::delete_branch, middle(6)), edit(TreeEditKind::set_root, middle(3)),
        edit(TreeEditKind::reassign_system, middle(5))};
    edits[1].to_mm = middle(4);
    edits[4].system = VascularSystem::artery;
    Figures figures;
    for (std::size_t e = 0; e < edits.size(); ++e) {
        tree = edited(tree, edits[e]);
        add_tree(figures, "edit" + std::to_string(e), tree);
    }
    const std::string json = edits_to_json(edits);
    figures.add("edits",
                std::span(reinterpret_cast<const std::uint8_t*>(json.data()), json.size()));
    const std::filesystem::path folder = testing::TempDir();
    for (const char* name : {"recorded.vtp", "recorded.swc", "recorded.json"}) {
        write_tree(folder / name, tree);
        std::ifstream in(folder / name, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        figures.add(name,
                    std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
        add_tree(figures, std::string(name) + ".read",
                 read_tree(folder / name, {.space = PatientSpace::lps}));
    }
    expect_recorded("tree", "edits_and_files", figures);
}

}  // namespace
}  // namespace hepatica
