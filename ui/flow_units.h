// SPDX-License-Identifier: GPL-3.0-or-later
// Units in which the window shows flows and pressures: those of the computation or those of the
// clinic. Commands, recordings and files always use the former.
#pragma once

#include <QString>
#include <array>

#include "render/chart.h"

namespace hepatica {

enum class FlowUnits {
    computed,  // g/s, Pa
    clinic,    // mL/min, mmHg
};

inline constexpr std::array all_flow_units{FlowUnits::computed, FlowUnits::clinic};
// As one chooses them: "mL/min, mmHg".
QString choice_words(FlowUnits units);

// Names in the settings; an unknown name means `computed`.
QString name_of(FlowUnits units);
FlowUnits flow_units_named(const QString& name);

// Mass flow (g/s) to volume flow (mL/min) and back, for a fluid of this density in g/mm^3.
double ml_min_of(double mass_flow_g_s, double density_g_mm3);
double g_s_of(double volume_flow_ml_min, double density_g_mm3);

// How fast blood is lost, with its unit; `leak_g_s` >= 0.
QString leak_text(double leak_g_s, FlowUnits units);

// Converts a chart whose label says that its values are in Pa; returns any other unchanged.
Chart in_units(Chart chart, FlowUnits units);

}  // namespace hepatica
