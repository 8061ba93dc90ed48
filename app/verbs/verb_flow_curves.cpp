// SPDX-License-Identifier: GPL-3.0-or-later
// flow-curves: compares the forms of the pressure law over the Reynolds number and for the hepatic
// arteries (core/flow/pressure_drop.h).
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

#include "app/chart_file.h"
#include "app/output_place.h"
#include "app/verbs/flow_options.h"
#include "app/verbs/verbs.h"
#include "core/base/atomic_write.h"
#include "core/base/units.h"

namespace hepatica {

namespace {

constexpr int points_per_decade = 40;

struct FlowCurvesChoices {
    std::filesystem::path out;
    Cone cone{2.15, 1.465, 20.0};  // the common hepatic artery narrowing to the proper one
    std::string format = "png";
};

// A form of the pressure law with a fluid, drawn as one curve.
struct Form {
    const char* name;
    PressureLaw law;
    Fluid fluid;
};

std::vector<Form> forms() {
    return {{"regime, blood", PressureLaw::regime, pure(blood())},
            {"consistent, blood", PressureLaw::consistent, pure(blood())},
            {"published, blood", PressureLaw::published, pure(blood())},
            {"published, 40 % gas", PressureLaw::published,
             mixture(blood(), gas(), published_void_fraction)}};
}

// Draws the drops over the Reynolds number of blood at the same mass flow into files of `folder`.
void draw_forms(const FlowCurvesChoices& options, const std::filesystem::path& folder) {
    Chart drops{"Drop of total pressure along one vessel",
                "Reynolds number of blood at the inlet",
                "Drop (Pa)",
                {},
                true,
                true};
    Chart ratios{"Each form over the regime form",
                 "Reynolds number of blood at the inlet",
                 "Ratio of drops",
                 {},
                 true,
                 false};
    const Fluid liquid = pure(blood());
    for (const Form& form : forms()) {
        Curve drop{form.name, {}, {}};
        Curve ratio{form.name, {}, {}};
        for (int i = 0; i <= 5 * points_per_decade; ++i) {
            const double reynolds = std::pow(10.0, static_cast<double>(i) / points_per_decade);
            const double m = 0.5 * reynolds * std::numbers::pi * options.cone.proximal_radius_mm *
                             liquid.viscosity_pa_s;
            const double yardstick =
                total_pressure_drop(PressureLaw::regime, options.cone, liquid, m).pressure_pa;
            const double pa =
                total_pressure_drop(form.law, options.cone, form.fluid, m).pressure_pa;
            drop.x.push_back(reynolds);
            drop.y.push_back(pa);
            ratio.x.push_back(reynolds);
            ratio.y.push_back(pa / yardstick);
        }
        drops.curves.push_back(drop);
        ratios.curves.push_back(ratio);
    }
    for (const std::string& extension : {std::string("csv"), options.format}) {
        write_chart(folder / ("flow_forms." + extension), drops);
        write_chart(folder / ("flow_forms_ratio." + extension), ratios);
    }
}

// Diameters: Bilir 2021 (computed tomography, 500 adults). Flow at rest: hepatic artery 245, portal
// vein 945 mL/min (Carlisle 1992, at 70 kg); right and left hepatic artery share it by the cube of
// the radius.
struct Vessel {
    const char* name;
    double proximal_diameter_mm;
    double distal_diameter_mm;
    double flow_ml_min;
};

std::vector<Vessel> vessels() {
    const double right = std::pow(2.92, 3);
    const double left = std::pow(2.51, 3);
    return {{"common hepatic artery", 4.3, 4.3, 245.0},
            {"proper hepatic artery", 2.93, 2.93, 245.0},
            {"common into proper, as one cone", 4.3, 2.93, 245.0},
            {"right hepatic artery", 2.92, 2.92, 245.0 * right / (right + left)},
            {"left hepatic artery", 2.51, 2.51, 245.0 * left / (right + left)}};
}

Json hepatic_arteries() {
    Json rows = Json::array();
    const Fluid liquid = pure(blood());
    for (const Vessel& vessel : vessels()) {
        const Cone cone{0.5 * vessel.proximal_diameter_mm, 0.5 * vessel.distal_diameter_mm, 10.0};
        const double m = vessel.flow_ml_min * units::millilitre_per_minute * liquid.density_g_mm3;
        const double regime = total_pressure_drop(PressureLaw::regime, cone, liquid, m).pressure_pa;
        Json row = {{"vessel", vessel.name},
                    {"flow_ml_min", vessel.flow_ml_min},
                    {"reynolds", reynolds_number(cone.distal_radius_mm, liquid, m)},
                    {"regime_pa_per_cm", regime}};
        for (const Form& form : forms()) {
            if (form.law == PressureLaw::regime) continue;
            row[std::string(form.name) + " / regime"] =
                total_pressure_drop(form.law, cone, form.fluid, m).pressure_pa / regime;
        }
        row["bernoulli_pa"] = bernoulli_drop_pa(cone, liquid, m);
        rows.push_back(row);
    }
    return rows;
}

Json run_flow_curves(const FlowCurvesChoices& options) {
    validate(options.cone);
    require_chart_file(options.out / ("flow_forms." + options.format));
    require_writable_folder(options.out);
    write_files_atomically(
        options.out, [&](const std::filesystem::path& folder) { draw_forms(options, folder); });
    return {{"files",
             {(options.out / ("flow_forms." + options.format)).string(),
              (options.out / ("flow_forms_ratio." + options.format)).string()}},
            {"hepatic_arteries", hepatic_arteries()}};
}

}  // namespace

void add_flow_curves(CommandLine& line) {
    const auto options = std::make_shared<FlowCurvesChoices>();
    CLI::App& verb = line.add_verb("flow-curves",
                                   "Compare the forms of the pressure law over the Reynolds number",
                                   [options](Job&) { return run_flow_curves(*options); });
    verb.add_option("OUT", options->out, "Folder for the plots")->required();
    verb.add_option("--r1-mm", options->cone.proximal_radius_mm, "Radius at the inlet")
        ->capture_default_str();
    verb.add_option("--r2-mm", options->cone.distal_radius_mm, "Radius at the outlet")
        ->capture_default_str();
    verb.add_option("--length-mm", options->cone.length_mm, "Length")->capture_default_str();
    verb.add_option("--format", options->format, "png, or csv for the numbers alone")
        ->capture_default_str()
        ->check(CLI::IsMember({"png", "csv"}));
}

}  // namespace hepatica
