// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of fields and meshes as they are today.
#include <gtest/gtest.h>

#include <numeric>

#include "core/base/error.h"
#include "core/mesh/brick_mesh.h"
#include "core/mesh/crossing_triangles.h"
#include "core/mesh/quality.h"
#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/mesh/tube_field.h"
#include "tests/mesh/bend_along_x.h"
#include "tests/mesh/random_tree.h"
#include "tests/support/enclosed_volume.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;

std::vector<double> coordinates_of(const std::vector<Vec3>& points) {
    std::vector<double> numbers;
    for (const Vec3& point : points) numbers.insert(numbers.end(), point.begin(), point.end());
    return numbers;
}

template <std::size_t N>
std::vector<double> corners_in(const std::vector<std::array<int, N>>& cells) {
    std::vector<double> numbers;
    for (const auto& cell : cells) numbers.insert(numbers.end(), cell.begin(), cell.end());
    return numbers;
}

void add_mesh(Figures& figures, const std::string& name, const TetMesh& mesh) {
    const MeshQuality quality = quality_of(mesh);
    const BodySurface surface = surface_of(mesh);
    figures.add(name + ".vertices", coordinates_of(mesh.vertices_mm))
        .add(name + ".tetrahedra", corners_in(mesh.tetrahedra))
        .add(name + ".surface", corners_in(surface.mesh.triangles))
        .add(name + ".least_angle", quality.min_dihedral_deg)
        .add(name + ".largest_angle", quality.max_dihedral_deg)
        .add(name + ".volume", quality.volume_mm3)
        .add(name + ".enclosed", test::enclosed_volume_mm3(surface.mesh))
        .add(name + ".counts",
             std::vector{static_cast<double>(quality.components), quality.closed ? 1.0 : 0.0,
                         static_cast<double>(quality.boundary_components),
                         static_cast<double>(quality.handles)});
}

TEST(MeshFigures, OfTubeFields) {
    Figures figures;
    const VesselTree tree = test::random_tree(901, 4);
    std::vector<int> all(tree.segments.size());
    std::iota(all.begin(), all.end(), 0);
    for (const TubeFieldOptions& options :
         {TubeFieldOptions{}, TubeFieldOptions{1.07, 2.2, 0.5}, TubeFieldOptions{1.0, 0.0, 0.0}}) {
        const TubeField field(tree, all, options);
        std::mt19937_64 chance(902);
        std::vector<double> distances, radii, places;
        for (const VesselSegment& segment : tree.segments)
            for (const Vec3& centre : segment.points_mm)
                for (int i = 0; i < 12; ++i) {
                    Vec3 point = centre;
                    for (double& x : point) x += test::uniform(chance, -7.0, 7.0);
                    const double distance = field.distance_mm(point);
                    distances.push_back(std::isfinite(distance) ? distance : 99.0);
                    radii.push_back(field.radius_mm(point));
                    places.push_back(field.position_along(point));
                }
        const std::string name = "minimum" + std::to_string(options.minimum_radius_mm) + "_blend" +
                                 std::to_string(options.blend_in_radii);
        figures.add(name + ".distances", distances)
            .add(name + ".radii", radii)
            .add(name + ".places", places)
            .add(name + ".points", coordinates_of(field.surface_points_mm()))
            .add(name + ".box", coordinates_of({field.lower_mm(), field.upper_mm()}))
            .add(name + ".smallest", field.smallest_radius_mm());
    }
    expect_recorded("mesh", "fields", figures);
}

TEST(MeshFigures, OfVesselsAtEverySize) {
    Figures figures;
    const VesselTree tree = test::random_tree(903, 2);
    for (const double size : {0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95, 1.0}) {
        MeshOptions options;
        options.facet_size_in_radii = size;
        options.cell_size_in_radii = 1.0;
        options.optimise = false;
        Job job;
        add_mesh(figures, "facets" + std::to_string(size), tetrahedralize(tree, options, job));
    }
    expect_recorded("mesh", "sizes", figures);
}

TEST(MeshFigures, OfMeshesWithTheOptionsAsTheyCome) {
    Figures figures;
    VesselTree tree = test::random_tree(904, 2);
    Job job;
    add_mesh(figures, "default", tetrahedralize(tree, {}, job));
    MeshOptions options;
    options.target_tetrahedra = 3000;
    options.minimum_radius_mm = 4.2;
    add_mesh(figures, "target", tetrahedralize(tree, options, job));
    options.target_tetrahedra = 400;
    options.optimise = false;
    add_mesh(figures, "coarse", tetrahedralize(tree, options, job));
    // Another piece beside it.
    const VesselTree other = test::random_tree(905, 1, 3.0);
    const int nodes = static_cast<int>(tree.nodes.size());
    for (VesselNode node : other.nodes) {
        node.position_mm.x() += 100.0;
        tree.nodes.push_back(node);
    }
    for (VesselSegment segment : other.segments) {
        segment.proximal_node += nodes;
        segment.distal_node += nodes;
        for (Vec3& point : segment.points_mm) point.x() += 100.0;
        tree.segments.push_back(segment);
    }
    options = {};
    options.optimise = false;
    add_mesh(figures, "two", tetrahedralize(tree, options, job));
    expect_recorded("mesh", "vessels", figures);
}

TEST(MeshFigures, OfBricks) {
    Figures figures;
    TetMesh brick = kuhn_brick(Vec3(6, 2, 3), {5, 2, 3});
    add_mesh(figures, "brick", brick);
    test::bend_along_x(brick.vertices_mm, 6.0, 0.7, 1.3);
    add_mesh(figures, "bent", brick);
    const HexMesh hexahedra = hexahedral_brick(Vec3(1, 2, 3), {2, 3, 4});
    figures.add("hexahedra", corners_in(hexahedra.hexahedra))
        .add("corners", coordinates_of(hexahedra.vertices_mm))
        .add("cut", corners_in(cut_into_tetrahedra(hexahedra.hexahedra)));
    std::mt19937_64 chance(906);
    for (Vec3& x : brick.vertices_mm)
        for (double& c : x) c += test::uniform(chance, -0.6, 0.6);
    figures.add("crossing",
                corners_in(crossing_triangles(boundary_triangles(brick), brick.vertices_mm)));
    expect_recorded("mesh", "bricks", figures);
}

// The smallest and the largest size are taken, and none beyond them.
TEST(MeshFigures, SizesAtTheirLimitsAreTaken) {
    const VesselTree tree = test::random_tree(907, 1);
    const auto make = [&](double facets, double cells) {
        MeshOptions options;
        options.facet_size_in_radii = facets;
        options.cell_size_in_radii = cells;
        options.optimise = false;
        Job job;
        return tetrahedralize(tree, options, job).tetrahedra.size();
    };
    EXPECT_GT(make(1.0, 1.0), 0u);
    EXPECT_GT(make(0.3, 1.0), make(1.0, 1.0));
    EXPECT_GT(make(1.0, 0.3), make(1.0, 1.0));
    for (const double wrong : {0.299999, 1.000001, 0.0, -0.5}) {
        EXPECT_THROW(make(wrong, 0.9), InputError) << wrong;
        EXPECT_THROW(make(0.9, wrong), InputError) << wrong;
    }
}

}  // namespace
}  // namespace hepatica
