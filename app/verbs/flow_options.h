// SPDX-License-Identifier: GPL-3.0-or-later
// Options shared by the verbs about flow: the tree, the fluids, the pressure law.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "app/command_line.h"
#include "core/flow/pressure_drop.h"
#include "core/scene/default_injection.h"
#include "core/tree/files/tree_io.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

struct FluidOptions {
    std::string model = default_injection::pressure_model;
    std::optional<double> void_fraction;
    std::string phase;
    double liquid_density_kg_m3 = 1060.0;
    double liquid_viscosity_pa_s = 3.5e-3;
    std::optional<double> phase_density_kg_m3;
    std::optional<double> phase_viscosity_pa_s;

    // The pressure law and the liquid.
    void add_liquid_to(CLI::App& verb);
    // These, and the second phase that is mixed into the liquid.
    void add_to(CLI::App& verb);
    // Throws UsageError where a second phase is described, but nothing of it is in the fluid and
    // --void-fraction does not say so.
    void require_use_of_phase() const;
    PressureLaw law() const { return pressure_law(model); }
    // The value given, or 0.40 with `published` (the paper's value), or the default injection's.
    double share() const;
    // The phase given, or gas with `published` (the paper's), or lipiodol.
    Phase second() const;
    Phase liquid() const;
    Fluid fluid() const { return mixture(liquid(), second(), share()); }
};

Json to_json(const Fluid& fluid);

struct TreeFileOptions {
    std::string space;  // lps, ras, or "" where not stated
    std::optional<double> radius_mm;

    void add_to(CLI::App& verb);
    TreeFileFacts facts() const;
};

// Reads a case or a tree file (.vtp, .swc, .json). Throws InputError.
VesselTree read_any_tree(const std::filesystem::path& place, const TreeFileOptions& options);

// The point of the tree nearest to "X,Y,Z" (mm, LPS), given to `option`. Throws UsageError for
// malformed text, and as point_of_vessel().
TreePoint parse_point(const std::string& option, const std::string& text, const VesselTree& tree);

// The point of the tree nearest to a position given to `option`. Throws InputError where the
// nearest vessel is more than 10 mm away.
TreePoint point_of_vessel(const std::string& option, const Vec3& position_mm,
                          const VesselTree& tree);

}  // namespace hepatica
