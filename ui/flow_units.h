// SPDX-License-Identifier: GPL-3.0-or-later
// In which units the window shows flows and pressures: those that the program computes in, or those
// of the clinic. Only what is shown and typed changes; commands, recordings and files do not.
#pragma once

#include <QString>

#include "render/chart.h"

namespace hepatica {

enum class FlowUnits {
    computed,  // g/s, Pa
    clinic,    // mL/min, mmHg
};

// As settings keep them; any other name is `computed`.
QString name_of(FlowUnits units);
FlowUnits flow_units_named(const QString& name);

// Of a fluid of this density.
double ml_min_of(double mass_flow_g_s, double density_g_mm3);
double g_s_of(double volume_flow_ml_min, double density_g_mm3);

// A chart whose values are pressures in Pa, as its label says, in these units; any other as it is.
Chart in_units(Chart chart, FlowUnits units);

}  // namespace hepatica
