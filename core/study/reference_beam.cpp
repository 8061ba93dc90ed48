// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/reference_beam.h"

#include <cmath>
#include <numbers>

#include "core/deform/body/element_name.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

double bending_stiffness(const BeamSpec& spec) {
    return spec.material.young_modulus_pa * std::pow(spec.section_mm, 4) / 12.0;
}

double weight_per_length(const BeamSpec& spec) {
    return spec.material.density_g_mm3 * spec.section_mm * spec.section_mm * spec.gravity_mm_s2;
}

}  // namespace

std::string name_of(const Discretisation& d) {
    return d.hexahedra ? "hexahedron" : element_name(d.model, d.order);
}

Discretisation discretisation_of(const std::string& name) {
    if (name == "hexahedron") return {ElementModel::corotated, ElementOrder::linear, true};
    const auto [model, order] = element_of(name);
    return {model, order, false};
}

BeamSpec short_beam(const Discretisation& d) {
    BeamSpec spec;
    spec.length_mm = 100.0;
    spec.section_mm = 20.0;
    spec.cells = d.order == ElementOrder::quadratic ? Index3{8, 1, 1} : Index3{10, 2, 2};
    return spec;
}

BodyDescription clamped_beam(const BeamSpec& spec, const Discretisation& discretisation) {
    BodyDescription body;
    const Vec3 size(spec.length_mm, spec.section_mm, spec.section_mm);
    if (discretisation.hexahedra) {
        HexMesh brick = hexahedral_brick(size, spec.cells);
        body.mesh.vertices_mm = std::move(brick.vertices_mm);
        body.hexahedra = std::move(brick.hexahedra);
    } else {
        body.mesh = kuhn_brick(size, spec.cells);
    }
    for (const Vec3& x : body.mesh.vertices_mm) body.fixed.push_back(x[0] == 0.0);
    body.material = spec.material;
    return body;
}

double shear_coefficient(const Material& material) {
    const double nu = material.poisson_ratio;
    return 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
}

double timoshenko_tip_mm(const BeamSpec& spec) {
    const double length = spec.length_mm, kappa = shear_coefficient(spec.material);
    const double shear_modulus = lame_of(spec.material).mu_pa;
    const double q = weight_per_length(spec);
    return q * std::pow(length, 4) / (8.0 * bending_stiffness(spec)) +
           q * length * length / (2.0 * kappa * shear_modulus * spec.section_mm * spec.section_mm);
}

double first_period_s(const BeamSpec& spec) {
    const double mass = spec.material.density_g_mm3 * spec.section_mm * spec.section_mm;
    const double omega =
        3.51602 * std::sqrt(bending_stiffness(spec) / (mass * std::pow(spec.length_mm, 4)));
    return 2.0 * std::numbers::pi / omega;
}

double tip_deflection_mm(const BeamSpec& spec, std::span<const Vec3> rest_mm,
                         std::span<const Vec3> positions_mm) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t v = 0; v < rest_mm.size(); ++v)
        if (rest_mm[v][0] == spec.length_mm) {
            sum += rest_mm[v][2] - positions_mm[v][2];
            ++count;
        }
    return sum / count;
}

}  // namespace hepatica
