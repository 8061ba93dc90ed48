// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/deform/support/test_bodies.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace hepatica::test {

namespace {

using Cell = std::array<int, 3>;

// Each cell cut into six tetrahedra around its diagonal: neighbours' faces match.
TetMesh mesh_of_cells(const std::set<Cell>& cells, const Vec3& cell_mm) {
    static constexpr std::array<std::array<int, 3>, 6> paths{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    TetMesh mesh;
    std::map<Cell, int> index;
    const auto vertex = [&](const Cell& c) {
        const auto [entry, fresh] = index.try_emplace(c, static_cast<int>(index.size()));
        if (fresh) mesh.vertices_mm.push_back(Vec3(c[0], c[1], c[2]).cwiseProduct(cell_mm));
        return entry->second;
    };
    for (const Cell& cell : cells) {
        for (std::size_t p = 0; p < 6; ++p) {
            Cell corner = cell;
            std::array<int, 4> tetrahedron{vertex(corner)};
            for (std::size_t k = 0; k < 3; ++k) {
                ++corner[static_cast<std::size_t>(paths[p][k])];
                tetrahedron[k + 1] = vertex(corner);
            }
            if (p >= 3) std::swap(tetrahedron[2], tetrahedron[3]);
            mesh.tetrahedra.push_back(tetrahedron);
        }
    }
    return mesh;
}

using Block12 = Eigen::Matrix<double, 12, 12>;

struct RestShape {
    Mat3 inverse_edges;
    double volume_mm3 = 0.0;
    std::array<Vec3, 4> gradients;
};

RestShape rest_shape(const TetMesh& mesh, const std::array<int, 4>& t) {
    Mat3 edges;
    for (int k = 0; k < 3; ++k) {
        edges.col(k) =
            mesh.vertices_mm[t[static_cast<std::size_t>(k) + 1]] - mesh.vertices_mm[t[0]];
    }
    RestShape shape;
    shape.volume_mm3 = edges.determinant() / 6.0;
    shape.inverse_edges = edges.inverse();
    shape.gradients[0].setZero();
    for (int k = 0; k < 3; ++k) {
        shape.gradients[static_cast<std::size_t>(k) + 1] = shape.inverse_edges.row(k).transpose();
        shape.gradients[0] -= shape.inverse_edges.row(k).transpose();
    }
    return shape;
}

Mat3 rotation_of(const Mat3& deformation) {
    const Eigen::JacobiSVD<Mat3> svd(deformation, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0.0) u.col(2) *= -1.0;
    return u * svd.matrixV().transpose();
}

double vertex_mass(const TetMesh& mesh, const SampleMaterial& material, std::vector<double>& mass) {
    mass.assign(mesh.vertices_mm.size(), 0.0);
    for (const auto& t : mesh.tetrahedra) {
        for (const int v : t) {
            mass[v] += 0.25 * material.density_g_mm3 * rest_shape(mesh, t).volume_mm3;
        }
    }
    return 0.0;
}

}  // namespace

SampleBody make_bar(double length_mm, double width_mm, int cells_along, int cells_across) {
    std::set<Cell> cells;
    for (int i = 0; i < cells_along; ++i) {
        for (int j = 0; j < cells_across; ++j) {
            for (int k = 0; k < cells_across; ++k) cells.insert({i, j, k});
        }
    }
    const double across = width_mm / cells_across;
    SampleBody body;
    body.mesh = mesh_of_cells(cells, Vec3(length_mm / cells_along, across, across));
    for (Vec3& x : body.mesh.vertices_mm) x -= Vec3(0.0, 0.5 * width_mm, 0.5 * width_mm);
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() == 0.0);
    const SkeletonPolyline line{
        {Vec3::Zero(), Vec3(length_mm, 0.0, 0.0)}, {0.5 * width_mm, 0.5 * width_mm}, -1};
    body.skeleton = resample(std::span(&line, 1));
    return body;
}

SampleBody make_brick_tree(int generations, double root_radius_mm, double cell_mm) {
    std::vector<SkeletonPolyline> lines;
    std::vector<Vec3> directions, sides;
    std::vector<int> generation;
    const auto add = [&](int parent, const Vec3& start, const Vec3& direction, const Vec3& side,
                         double radius, int depth) {
        lines.push_back({{start, start + 8.0 * radius * direction}, {radius, radius}, parent});
        directions.push_back(direction);
        sides.push_back(side);
        generation.push_back(depth);
    };
    add(-1, Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), root_radius_mm, 0);
    for (std::size_t b = 0; b < lines.size(); ++b) {
        if (generation[b] + 1 >= generations) continue;
        for (const double turn : {0.6, -0.5}) {
            const Vec3 direction =
                (std::cos(turn) * directions[b] + std::sin(turn) * sides[b]).normalized();
            const Vec3 side = directions[b].cross(sides[b]).normalized();
            add(static_cast<int>(b), lines[b].points_mm[1], direction, side,
                0.8 * lines[b].radii_mm[1], generation[b] + 1);
        }
    }
    std::set<Cell> cells;
    for (const SkeletonPolyline& line : lines) {
        const Vec3 along = line.points_mm[1] - line.points_mm[0];
        const double radius = line.radii_mm[0];
        const auto low = (line.points_mm[0].cwiseMin(line.points_mm[1]).array() - radius) / cell_mm;
        const auto high =
            (line.points_mm[0].cwiseMax(line.points_mm[1]).array() + radius) / cell_mm;
        const Eigen::Array3i first = low.floor().cast<int>(), last = high.ceil().cast<int>();
        for (int i = std::max(first[0], 0); i <= last[0]; ++i) {
            for (int j = first[1]; j <= last[1]; ++j) {
                for (int k = first[2]; k <= last[2]; ++k) {
                    const Vec3 centre = cell_mm * Vec3(i + 0.5, j + 0.5, k + 0.5);
                    const double t = std::clamp(
                        (centre - line.points_mm[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
                    const double distance = (line.points_mm[0] + t * along - centre).norm();
                    if (distance <= radius) cells.insert({i, j, k});
                }
            }
        }
    }
    SampleBody body;
    body.mesh = mesh_of_cells(cells, Vec3::Constant(cell_mm));
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x.x() == 0.0);
    body.skeleton = resample(lines);
    return body;
}

BodyDescription description_of(const SampleBody& body) {
    BodyDescription description;
    description.mesh = body.mesh;
    description.fixed.assign(body.fixed.begin(), body.fixed.end());
    description.skeleton = body.skeleton;
    return description;
}

int tip_of(const BodyDescription& body) {
    const Vec3 end = body.skeleton.positions_mm.back();
    const auto& vertices = body.mesh.vertices_mm;
    return static_cast<int>(
        std::ranges::min_element(vertices, {}, [&](const Vec3& v) { return (v - end).norm(); }) -
        vertices.begin());
}

std::vector<Vec3> bend(const std::vector<Vec3>& positions_mm, double angle_rad, double length_mm) {
    std::vector<Vec3> bent;
    const double radius = length_mm / angle_rad;
    for (const Vec3& x : positions_mm) {
        const double angle = x.x() / radius;
        bent.emplace_back((radius - x.y()) * std::sin(angle),
                          radius - (radius - x.y()) * std::cos(angle), x.z());
    }
    return bent;
}

std::vector<double> vertex_masses(const SampleBody& body, const SampleMaterial& material) {
    std::vector<double> mass;
    vertex_mass(body.mesh, material, mass);
    return mass;
}

BlockMatrix assemble(const SampleBody& body, const std::vector<Vec3>& positions_mm,
                     const SampleMaterial& material) {
    const TetMesh& mesh = body.mesh;
    const std::size_t count = mesh.vertices_mm.size();
    std::vector<std::set<int>> columns(count);
    for (std::size_t v = 0; v < count; ++v) columns[v].insert(static_cast<int>(v));
    for (const auto& t : mesh.tetrahedra) {
        for (const int a : t) columns[a].insert(t.begin(), t.end());
    }
    BlockMatrix matrix;
    for (const auto& row : columns) {
        for (const int j : row) {
            if (j + 1 == static_cast<int>(matrix.row_begin.size())) {
                matrix.diagonal.push_back(static_cast<int>(matrix.column.size()));
            }
            matrix.column.push_back(j);
        }
        matrix.row_begin.push_back(static_cast<int>(matrix.column.size()));
    }
    matrix.block.assign(matrix.column.size(), Mat3::Zero());
    std::vector<double> mass;
    vertex_mass(mesh, material, mass);
    for (std::size_t v = 0; v < count; ++v) {
        matrix.block[matrix.diagonal[v]] += mass[v] * Mat3::Identity();
    }
    const double mu = material.young_pa / (2.0 * (1.0 + material.poisson));
    const double lambda = material.young_pa * material.poisson /
                          ((1.0 + material.poisson) * (1.0 - 2.0 * material.poisson));
    const double dt2 = material.dt_s * material.dt_s;
    for (const auto& t : mesh.tetrahedra) {
        const RestShape shape = rest_shape(mesh, t);
        Mat3 edges;
        for (int k = 0; k < 3; ++k) {
            edges.col(k) = positions_mm[t[static_cast<std::size_t>(k) + 1]] - positions_mm[t[0]];
        }
        const Mat3 rotation = rotation_of(edges * shape.inverse_edges);
        for (std::size_t a = 0; a < 4; ++a) {
            for (std::size_t b = 0; b < 4; ++b) {
                if (body.fixed[t[a]] || body.fixed[t[b]]) continue;
                const Vec3& ga = shape.gradients[a];
                const Vec3& gb = shape.gradients[b];
                const Mat3 stiffness =
                    shape.volume_mm3 * (lambda * ga * gb.transpose() + mu * gb * ga.transpose() +
                                        mu * ga.dot(gb) * Mat3::Identity());
                if (t[a] <= t[b]) {
                    const Mat3 block = dt2 * rotation * stiffness * rotation.transpose();
                    matrix.block[matrix.find(t[a], t[b])] += block;
                    if (t[a] != t[b]) matrix.block[matrix.find(t[b], t[a])] += block.transpose();
                }
            }
        }
    }
    return matrix;
}

std::vector<Vec3> make_load(const SampleBody& body, const SampleMaterial& material) {
    std::vector<double> mass;
    vertex_mass(body.mesh, material, mass);
    std::vector<Vec3> load;
    for (std::size_t v = 0; v < mass.size(); ++v) {
        load.push_back(body.fixed[v] ? Vec3(Vec3::Zero())
                                     : Vec3(0.0, -9810.0 * material.dt_s * mass[v], 0.0));
    }
    load.back() += Vec3(0.0, 0.0, 2.0e4 * material.dt_s);
    return load;
}

std::vector<Vec3> solve_exactly(const BlockMatrix& matrix, const std::vector<Vec3>& rhs) {
    const int n = 3 * matrix.rows();
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < matrix.rows(); ++i) {
        for (int k = matrix.row_begin[i]; k < matrix.row_begin[i + 1]; ++k) {
            for (int r = 0; r < 3; ++r) {
                for (int c = 0; c < 3; ++c) {
                    entries.emplace_back(3 * i + r, 3 * matrix.column[k] + c,
                                         matrix.block[k](r, c));
                }
            }
        }
    }
    Eigen::SparseMatrix<double> sparse(n, n);
    sparse.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor(sparse);
    Eigen::VectorXd b(n);
    for (int i = 0; i < matrix.rows(); ++i) b.segment<3>(3 * i) = rhs[i];
    const Eigen::VectorXd x = factor.solve(b);
    std::vector<Vec3> solution;
    for (int i = 0; i < matrix.rows(); ++i) solution.emplace_back(x.segment<3>(3 * i));
    return solution;
}

double energy_norm(const BlockMatrix& matrix, const std::vector<Vec3>& x) {
    std::vector<Vec3> product;
    multiply(matrix, x, product);
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i].dot(product[i]);
    return std::sqrt(sum);
}

double energy_error(const BlockMatrix& matrix, const std::vector<Vec3>& x,
                    const std::vector<Vec3>& exact) {
    std::vector<Vec3> difference;
    for (std::size_t i = 0; i < x.size(); ++i) difference.emplace_back(x[i] - exact[i]);
    return energy_norm(matrix, difference) / energy_norm(matrix, exact);
}

}  // namespace hepatica::test
