// SPDX-License-Identifier: GPL-3.0-or-later
// What a body is made of: elasticity, density and a damping ratio; presets with their sources.
#pragma once

#include <span>
#include <string>

namespace hepatica {

// How an element turns strain into energy. All models take the same parameters.
// - spring: springs along the edges and one for the volume; the cheapest, and only roughly the
//   given material
// - corotated: Hooke's law in the frame of the element's rotation; the default
// - neohookean: stable Neo-Hookean; the reference at large strain
enum class ElementModel { spring, corotated, neohookean };

struct Material {
    double young_modulus_pa = 0.5e6;  // > 0
    double poisson_ratio = 0.45;      // in [0, 0.49999]
    double density_g_mm3 = 1.06e-3;   // > 0
    // Fraction of critical damping at both frequencies; between them it is roughly constant.
    double damping_ratio = 0.05;    // >= 0
    double damping_low_hz = 1.0;    // > 0
    double damping_high_hz = 30.0;  // >= damping_low_hz
};

struct Lame {
    double lambda_pa;
    double mu_pa;
};
Lame lame_of(const Material& material);

// Damping matrix B = alpha M + beta K that has the material's damping ratio at both frequencies.
struct RayleighDamping {
    double alpha_per_s = 0.0;
    double beta_s = 0.0;
};
RayleighDamping rayleigh_of(const Material& material);

// Throws InputError that names the parameter, its value and its valid range.
void validate(const Material& material);

struct MaterialPreset {
    std::string name;
    std::string source;
    Material material;
    // What it takes to tear the tissue, and the source of these values.
    double strength_pa = 1e6;
    double fracture_energy_j_m2 = 164.0;
    std::string strength_source{};
};
std::span<const MaterialPreset> material_presets();

}  // namespace hepatica
