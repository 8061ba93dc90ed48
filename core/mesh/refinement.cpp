// SPDX-License-Identifier: GPL-3.0-or-later
// An implicit domain for CGAL's Mesh_3, seeded with surface points, refined, then cleared of
// slivers.
#include "core/mesh/refinement.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_3/Slivers_exuder.h>
#include <CGAL/Mesh_3/sliver_criteria.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/perturb_mesh_3.h>
#include <CGAL/refine_mesh_3.h>

#include <map>

namespace hepatica {

namespace {

namespace parameters = CGAL::parameters;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

Vec3 to_vec3(const Kernel::Point_3& point) {
    return {point.x(), point.y(), point.z()};
}

// The size field for CGAL: local radius times a factor.
struct SizeByRadius {
    using FT = Kernel::FT;
    using Point_3 = Kernel::Point_3;
    using Index = Domain::Index;

    const TubeField* field;
    double factor;

    FT operator()(const Point_3& point, int, const Index&) const {
        return factor * field->radius_mm(to_vec3(point));
    }
};

// CGAL's measure of slivers, the smallest dihedral angle. While vertices are moved it is evaluated
// far more often than the field, so progress is reported from here as well.
class WatchedCriterion : public CGAL::Mesh_3::Min_dihedral_angle_criterion<Triangulation> {
    using Base = CGAL::Mesh_3::Min_dihedral_angle_criterion<Triangulation>;

  public:
    WatchedCriterion(double bound_deg, const Triangulation& triangulation,
                     const std::function<void(int)>& on_calls)
        : Base(bound_deg, triangulation), on_calls_(&on_calls) {}

    using Base::operator();
    double operator()(const Tetrahedron_3& tetrahedron) const override {
        if (++asked_ % 2048 == 0) (*on_calls_)(0);
        return Base::operator()(tetrahedron);
    }

  private:
    const std::function<void(int)>* on_calls_;
    mutable unsigned asked_ = 0;
};

// Perturbs and exudes slivers, as CGAL's own functions do.
void remove_slivers(Complex& complex, const Domain& domain,
                    const std::function<void(int)>& on_calls) {
    constexpr double bound_deg = 15.0;
    const WatchedCriterion criterion(bound_deg, complex.triangulation(), on_calls);
    CGAL::perturb_mesh_3(complex, domain, parameters::sliver_criterion = criterion);
    on_calls(0);
    CGAL::Mesh_3::Slivers_exuder<Complex, WatchedCriterion> exuder(complex, criterion);
    exuder.set_time_limit(0.0);  // no limit
    exuder();
}

// Inserts starting points on the surface. Without them refinement may miss a thin vessel: it only
// detects what the edges of its Voronoi diagram cross.
void insert_surface_points(Complex& complex, const Domain& domain, const TubeField& field,
                           const std::function<void(int)>& on_calls) {
    unsigned inserted = 0;
    Triangulation& triangulation = complex.triangulation();
    Triangulation::Vertex_handle hint;
    const Domain::Index index =
        domain.index_from_surface_patch_index(Domain::Surface_patch_index(0, 1));
    for (const Vec3& point : field.surface_points_mm()) {
        if (++inserted % 256 == 0) on_calls(0);
        const Triangulation::Vertex_handle vertex = triangulation.insert(
            Triangulation::Weighted_point(Kernel::Point_3(point.x(), point.y(), point.z())), hint);
        if (vertex == Triangulation::Vertex_handle()) continue;
        hint = vertex;
        complex.set_dimension(vertex, 2);
        complex.set_index(vertex, index);
    }
}

TetMesh to_tet_mesh(const Complex& complex) {
    TetMesh mesh;
    std::map<Triangulation::Vertex_handle, int> number;
    for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end();
         ++cell) {
        std::array<int, 4> corners{};
        for (int i = 0; i < 4; ++i) {
            const auto [entry, added] =
                number.try_emplace(cell->vertex(i), static_cast<int>(mesh.vertices_mm.size()));
            if (added) mesh.vertices_mm.push_back(to_vec3(cell->vertex(i)->point().point()));
            corners[i] = entry->second;
        }
        mesh.tetrahedra.push_back(corners);
    }
    return mesh;
}

}  // namespace

TetMesh refine_tetrahedra(const TubeField& field, const MeshRefinementOptions& options,
                          const std::function<void(int)>& on_calls) {
    // CGAL's default generator is seeded by the clock; the result must not depend on it.
    CGAL::get_default_random() = CGAL::Random(0);
    CGAL::Random random(0);

    constexpr int calls_at_once = 1024;
    int calls = 0;
    const auto function = [&](const Kernel::Point_3& point) {
        if (++calls == calls_at_once) {
            on_calls(calls);
            calls = 0;
        }
        return std::min(field.distance_mm(to_vec3(point)), 1e3);
    };
    const Vec3 margin = Vec3::Constant(field.smallest_radius_mm());
    const Vec3 low = field.lower_mm() - margin, high = field.upper_mm() + margin;
    const double relative_error = 0.01 * field.smallest_radius_mm() / (high - low).maxCoeff();
    const Domain domain = Domain::create_implicit_mesh_domain(
        function, CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()),
        parameters::relative_error_bound = relative_error, parameters::p_rng = &random);
    const Criteria criteria(
        parameters::facet_angle = 25,
        parameters::facet_size = SizeByRadius{&field, options.facet_size_in_radii},
        parameters::cell_radius_edge_ratio = 2,
        parameters::cell_size = SizeByRadius{&field, options.cell_size_in_radii});

    Complex complex;
    insert_surface_points(complex, domain, field, on_calls);
    CGAL::refine_mesh_3(complex, domain, criteria, parameters::manifold(), parameters::no_perturb(),
                        parameters::no_exude());
    if (options.optimise) remove_slivers(complex, domain, on_calls);
    return to_tet_mesh(complex);
}

}  // namespace hepatica
