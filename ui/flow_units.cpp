// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/flow_units.h"

#include <string>

#include "core/base/units.h"
#include "core/flow/fluid.h"
#include "ui/words.h"

namespace hepatica {

QString choice_words(FlowUnits units) {
    return units == FlowUnits::clinic ? Words::tr("mL/min, mmHg") : Words::tr("g/s, Pa");
}

QString name_of(FlowUnits units) {
    return units == FlowUnits::clinic ? "clinic" : "computed";
}

FlowUnits flow_units_named(const QString& name) {
    return name == name_of(FlowUnits::clinic) ? FlowUnits::clinic : FlowUnits::computed;
}

double ml_min_of(double mass_flow_g_s, double density_g_mm3) {
    return mass_flow_g_s / density_g_mm3 / units::millilitre_per_minute;
}

double g_s_of(double volume_flow_ml_min, double density_g_mm3) {
    return volume_flow_ml_min * units::millilitre_per_minute * density_g_mm3;
}

QString leak_text(double leak_g_s, FlowUnits units) {
    return units == FlowUnits::computed
               ? Words::tr("%L1 g/s").arg(leak_g_s, 0, 'f', 1)
               : Words::tr("%L1 mL/min").arg(ml_min_of(leak_g_s, blood().density_g_mm3), 0, 'f', 0);
}

Chart in_units(Chart chart, FlowUnits units) {
    const std::string pascal = "(Pa)";
    const std::size_t at = chart.y_label.find(pascal);
    if (units == FlowUnits::computed || at == std::string::npos) return chart;
    chart.y_label.replace(at, pascal.size(), "(mmHg)");
    for (Curve& curve : chart.curves)
        for (double& pressure : curve.y) pressure /= units::millimetre_of_mercury;
    return chart;
}

}  // namespace hepatica
