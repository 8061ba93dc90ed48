// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/iteration_study.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "core/deform/solvers/cholesky_solver.h"
#include "core/deform/solvers/skeleton_preconditioner.h"
#include "core/deform/step/assembly.h"
#include "core/study/job_within.h"
#include "core/study/timing.h"
#include "core/study/vessel_body.h"

namespace hepatica {

namespace {

constexpr double gravity_mm_s2 = 9810.0;
constexpr double pull_un = 2e4;

double form(const BlockMatrix& matrix, const std::vector<Vec3>& x) {
    std::vector<Vec3> product;
    multiply(matrix, x, product);
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i].dot(product[i]);
    return sum;
}

void fix(const Body& body, BlockMatrix& matrix) {
    for (int i = 0; i < matrix.rows(); ++i) {
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            const int j = matrix.column[k];
            if (i != j && (body.fixed[i] || body.fixed[j])) matrix.block[k].setZero();
        }
    }
}

std::vector<Vec3> stopped_after(LinearSolver& solver, const StudySystem& system, int iterations) {
    std::vector<Vec3> x(system.rhs.size(), Vec3::Zero());
    solver.solve(system.rhs, x, {.energy_tolerance = 0.0, .max_iterations = iterations});
    return x;
}

// Number of iterations after which the error is at most `error`, to about 1/64; the energy norm
// falls monotonically.
int iterations_to(double error, LinearSolver& solver, const StudySystem& system) {
    constexpr int most = 40000;
    int enough = 1;
    while (enough < most && energy_error(system, stopped_after(solver, system, enough)) > error) {
        enough *= 2;
    }
    int few = enough / 2;
    while (enough - few > std::max(1, enough / 64)) {
        const int middle = (few + enough) / 2;
        const bool good = energy_error(system, stopped_after(solver, system, middle)) <= error;
        (good ? enough : few) = middle;
    }
    return enough;
}

struct StudyCase {
    std::string name;
    double slenderness;
    double bend_rad;
    std::function<BodyDescription(Job&)> make;
};

// Turns the body so that the line from its clamp to its furthest end is along x, for bent().
void lay_along_x(BodyDescription& body) {
    const Vec3 clamp = clamp_mm(body);
    const Vec3 end = body.mesh.vertices_mm[static_cast<std::size_t>(furthest_vertex(body))];
    const Mat3 turn =
        Eigen::Quaterniond::FromTwoVectors(end - clamp, Vec3::UnitX()).toRotationMatrix();
    for (Vec3& x : body.mesh.vertices_mm) x = turn * (x - clamp);
    for (Vec3& x : body.skeleton.positions_mm) x = turn * (x - clamp);
}

// Longest path from a root, over the diameter at the root.
double slenderness_of(const VesselTree& tree) {
    std::vector<double> way(tree.segments.size()), diameter(tree.segments.size());
    double most = 0.0;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        const bool root = segment.parent < 0;
        way[s] = (root ? 0.0 : way[segment.parent]) + length_mm(segment);
        diameter[s] = root ? 2.0 * segment.radii_mm.front() : diameter[segment.parent];
        most = std::max(most, way[s] / diameter[s]);
    }
    return most;
}

std::vector<StudyCase> cases_of_patient(const VesselTree& patient, int tetrahedra, const Job& job) {
    JobWithin meshing(job);
    const auto body =
        std::make_shared<BodyDescription>(body_of(patient, tetrahedra, meshing.job()));
    lay_along_x(*body);
    std::vector<StudyCase> cases;
    for (const double bend_rad : {0.0, 1.0})
        cases.push_back({bend_rad > 0.0 ? "patient, bent" : "patient", slenderness_of(patient),
                         bend_rad, [body](Job&) { return *body; }});
    return cases;
}

std::vector<StudyCase> cases_of(bool quick) {
    std::vector<StudyCase> cases;
    const auto bar = [&](double slenderness, int across, double bend_rad) {
        cases.push_back({bend_rad > 0.0 ? "bar, bent" : "bar", slenderness, bend_rad,
                         [=](Job&) { return study_bar(slenderness, across); }});
    };
    const auto tree = [&](int tetrahedra) {
        const auto meshed =
            std::make_shared<BodyDescription>();  // meshed by whichever case comes first
        const auto make = [=](Job& job) {
            if (meshed->mesh.tetrahedra.empty())
                *meshed = body_of(study_tree(6, 6.0), tetrahedra, job);
            return *meshed;
        };
        cases.push_back({"tree", 36.0, 0.0, make});
        cases.push_back({"tree, bent", 36.0, 1.0, make});
    };
    bar(10.0, 4, 2.5);
    bar(60.0, 3, 2.5);
    if (quick) return cases;
    bar(10.0, 8, 2.5);
    bar(60.0, 4, 0.0);
    bar(60.0, 4, 2.5);
    bar(100.0, 3, 2.5);
    bar(200.0, 3, 2.5);
    bar(500.0, 2, 2.5);
    bar(500.0, 3, 2.5);
    for (const int tetrahedra : {8000, 25000, 100000}) tree(tetrahedra);
    return cases;
}

}  // namespace

StudySystem study_system(const BodyDescription& description, double bend_rad, double dt_s) {
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    StudySystem system;
    system.positions_mm = body.rest_positions_mm;
    if (bend_rad > 0.0) system.positions_mm = bent(system.positions_mm, bend_rad);
    Assembly assembly(body);
    assembly.evaluate(system.positions_mm);
    assembly.gather_stiffness(dt_s * dt_s, system.matrix);
    for (int i = 0; i < system.matrix.rows(); ++i) {
        system.matrix.block[system.matrix.diagonal[i]] += body.mass_g[i] * Mat3::Identity();
    }
    fix(body, system.matrix);

    const std::size_t furthest = static_cast<std::size_t>(furthest_vertex(description));
    for (int i = 0; i < body.node_count(); ++i) {
        const Vec3 weight(0.0, -gravity_mm_s2 * body.mass_g[i], 0.0);
        system.rhs.push_back(body.fixed[i] ? Vec3(Vec3::Zero()) : Vec3(dt_s * weight));
    }
    system.rhs[furthest] += Vec3(0.0, 0.0, dt_s * pull_un);

    CholeskySolver solver;
    solver.prepare(system.matrix, system.positions_mm);
    system.exact.assign(system.rhs.size(), Vec3::Zero());
    solver.solve(system.rhs, system.exact, {.energy_tolerance = 1e-12});
    return system;
}

double energy_error(const StudySystem& system, const std::vector<Vec3>& x) {
    std::vector<Vec3> difference(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) difference[i] = x[i] - system.exact[i];
    return std::sqrt(form(system.matrix, difference) / form(system.matrix, system.exact));
}

IterationRow measure_iterations(const std::string& name, const BodyDescription& body,
                                const StudySystem& system, double slenderness,
                                LinearSolverKind kind, const std::stop_token& stop) {
    const std::vector<Vec3>& rest = body.mesh.vertices_mm;
    std::unique_ptr<LinearSolver> solver;
    if (kind == LinearSolverKind::skeleton)
        solver = std::make_unique<SkeletonSolver>(body.skeleton, rest, SkeletonSettings{true});
    else
        solver = make_linear_solver(kind, body.skeleton, rest);
    solver->heed(stop);
    IterationRow row;
    row.body = name;
    row.solver = name_of(kind);
    row.slenderness = slenderness;
    row.tetrahedra = static_cast<int>(body.mesh.tetrahedra.size());
    solver->prepare(system.matrix, system.positions_mm);
    std::vector<Vec3> x(system.rhs.size(), Vec3::Zero());
    const SolveReport report = solver->solve(system.rhs, x, {.energy_tolerance = 1e-2});
    row.iterations_stopped = report.iterations;
    row.estimate = report.energy_error;
    row.error = energy_error(system, x);
    if (report.iterations > 0) {
        row.iterations_10pct = iterations_to(0.1, *solver, system);
        row.iterations_1pct = iterations_to(0.01, *solver, system);
    }
    // Alternates with another matrix, so that a solver that keeps its factor must factor again.
    BlockMatrix other = system.matrix;
    for (Mat3& block : other.block) block *= 2.0;
    row.prepare_ms = std::numeric_limits<double>::infinity();
    row.ms = row.prepare_ms;
    const int repetitions = row.iterations_1pct > 200 ? 2 : 6;
    for (int k = 0; k < repetitions; ++k) {
        solver->prepare(other, system.positions_mm);
        const double prepared_ms =
            timed_ms([&] { solver->prepare(system.matrix, system.positions_mm); });
        const double solved_ms =
            timed_ms([&] { stopped_after(*solver, system, std::max(row.iterations_1pct, 1)); });
        row.prepare_ms = std::min(row.prepare_ms, prepared_ms);
        row.ms = std::min(row.ms, prepared_ms + solved_ms);
    }
    return row;
}

std::vector<IterationRow> study_iterations(const IterationStudyOptions& options, Job& job) {
    std::vector<IterationRow> rows;
    const std::vector<StudyCase> cases =
        options.tree.segments.empty() ? cases_of(options.quick)
                                      : cases_of_patient(options.tree, options.tetrahedra, job);
    job.expect_stages(static_cast<int>(cases.size()));
    for (const StudyCase& study : cases) {
        job.begin_stage(study.name + ", slenderness " +
                        std::to_string(static_cast<int>(study.slenderness)));
        JobWithin meshing(job);
        const BodyDescription body = study.make(meshing.job());
        const StudySystem system = study_system(body, study.bend_rad);
        for (const auto kind : {LinearSolverKind::skeleton, LinearSolverKind::cholesky,
                                LinearSolverKind::block_jacobi}) {
            job.throw_if_cancelled();
            if (kind == LinearSolverKind::block_jacobi && !options.block_jacobi) continue;
            rows.push_back(measure_iterations(study.name, body, system, study.slenderness, kind,
                                              job.stop_token()));
        }
    }
    return rows;
}

}  // namespace hepatica
