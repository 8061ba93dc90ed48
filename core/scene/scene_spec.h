// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts a scene requires, and their settings. Parts that are not named are not built: a flow
// lesson has no matrices of tetrahedra and no solver, a drag lesson no flow network.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/base/frame_time.h"
#include "core/base/number_range.h"
#include "core/base/vector.h"
#include "core/deform/stepper/stepper_options.h"
#include "core/tear/tear_law.h"

namespace hepatica {

// Which ends of the tree are fixed; roots are those where a system begins. With all ends fixed, a
// hard pull stretches thin side branches to several times their length; by default the tether holds
// these, as tissue does.
enum class FixedEnds { none, roots, all };

struct DeformSpec {
    std::string material = "portal vein";  // name of a preset, see core/deform/body/material.h
    FixedEnds fixed = FixedEnds::roots;
    Vec3 gravity_mm_per_s2 = Vec3::Zero();
    // Stiffness of the surrounding tissue per volume, see BodyDescription; 0: none. The default is
    // an order of magnitude: the vessel still follows most of the hand's way, and steps do not
    // fail.
    double tether_pa_per_mm2 = 20.0;
    // Wall thickness of the vessels, see validate_wall; 0: solid. See make_hollow in
    // core/deform/body/body.h.
    double wall_mm = 0.0;
    double quality = 0.5;  // on the dial, 0 to 1
    // A fixed setting instead of the dial's: what a recording begins with.
    std::optional<StepperOptions> setting{};
    RayleighDamping velocity_error{};  // E of eq. (11), for every setting; see StepperOptions
};

struct FlowSpec {
    double drug_speed = 1.0;  // drug seconds per simulated second
};

// The liver's surface and tumours as obstacles: none; those that the case knows, if any; or at
// least one required.
enum class WantedObstacles { none, known, required };

// What may touch what. Needs "deform".
struct ContactSpec {
    bool tools = true;  // a tool and the vessels
    bool self = false;  // the vessels and each other or themselves
    WantedObstacles obstacles = WantedObstacles::none;
    double friction = 0.0;  // Coulomb's, between vessels, 0 to greatest_friction; needs `self`

    bool all() const { return tools && self && obstacles == WantedObstacles::known; }
    bool nothing() const { return !tools && !self && obstacles == WantedObstacles::none; }
};

// What tears, and when it stops. Needs "deform".
struct TearSpec {
    // Multiplies the tissue's strength, see MaterialPreset and validate_tear_factor.
    double tear_factor = 1.0;
    TearStop stop = TearStop::none;
    double entropy_budget = 0.5;  // nats; for TearStop::entropy
    int vertex_budget = 200;      // vertices split off; for TearStop::vertices
    bool bare_limit = false;      // a plain force limit, as published: see TearLaw
    bool operator==(const TearSpec&) const = default;
};

// Throws InputError unless the factor is from least_tear_factor to greatest_tear_factor.
constexpr double least_tear_factor = 1e-6;
constexpr double greatest_tear_factor = 1e9;
void validate_tear_factor(double factor);

// Throws InputError unless the coefficient is from 0 to greatest_friction.
constexpr double greatest_friction = 10.0;
void validate_friction(double friction);

struct SceneSpec {
    std::string name = "scene";
    std::optional<DeformSpec> deform = DeformSpec{};
    std::optional<FlowSpec> flow = FlowSpec{};
    std::optional<ContactSpec> contact{};  // none: nothing is built for it
    std::optional<TearSpec> tear{};        // none: nothing is built for it
    double dt_s = frame_s;                 // 1e-4 to 1
};

// Throws InputError unless the thickness is 0 (solid) or from thinnest_wall_mm to thickest_wall_mm.
constexpr double thinnest_wall_mm = 0.01;
constexpr double thickest_wall_mm = 100.0;
void validate_wall(double wall_mm);

// What scenes and commands may ask for: gravity up to about a hundred times the Earth's in each
// direction, the tissue's springs, and drug seconds per simulated second.
inline constexpr NumberRange gravity_range_mm_per_s2{-1e6, 1e6};
inline constexpr NumberRange tether_range_pa_per_mm2{0.0, 1e9};
inline constexpr NumberRange drug_speed_range{1e-6, 1e6};

// Body and flow with their defaults: the scene with which the window opens a case.
SceneSpec default_scene();

nlohmann::ordered_json to_json(const SceneSpec& spec);
nlohmann::ordered_json to_json(const TearSpec& spec);
TearSpec tear_from_json(const nlohmann::ordered_json& json);
// Throws InputError that names the key that is unknown, missing or out of range.
SceneSpec scene_from_json(const nlohmann::ordered_json& json);

// A scene file names its case beside the parts; a relative path starts at the file's folder.
struct SceneFile {
    SceneSpec spec;
    std::filesystem::path patient;
};
SceneFile read_scene(const std::filesystem::path& file);

}  // namespace hepatica
