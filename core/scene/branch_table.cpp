// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/branch_table.h"

#include <iomanip>
#include <locale>
#include <sstream>

#include "core/tree/station.h"

namespace hepatica {
namespace {

double mean_radius(const VesselSegment& segment, double length) {
    double sum = 0.0;
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i)
        sum += 0.5 * (segment.radii_mm[i] + segment.radii_mm[i - 1]) *
               (segment.points_mm[i] - segment.points_mm[i - 1]).norm();
    return sum / length;
}

}  // namespace

std::vector<BranchRow> branch_rows(const VesselTree& tree, std::span<const BranchLabel> labels,
                                   std::span<const double> flow_shares) {
    std::vector<BranchRow> rows;
    rows.reserve(tree.segments.size());
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const VesselSegment& segment = tree.segments[s];
        BranchRow row;
        row.branch = static_cast<int>(s);
        row.system = segment.system;
        row.system_confidence = segment.system_confidence;
        // A parent precedes its children.
        if (segment.parent >= 0)
            row.generation = rows[static_cast<std::size_t>(segment.parent)].generation + 1;
        row.strahler_order = segment.strahler_order;
        row.length_mm = length_mm(segment);
        row.radius_mm = mean_radius(segment, row.length_mm);
        row.middle_mm = station_at(segment, 0.5 * row.length_mm).position_mm;
        if (!labels.empty()) {
            row.couinaud = labels[s].segment;
            row.couinaud_confidence = labels[s].confidence;
        }
        if (!flow_shares.empty()) row.flow_share = flow_shares[s];
        rows.push_back(row);
    }
    return rows;
}

std::string branch_table_csv(std::span<const BranchRow> rows) {
    std::ostringstream csv;
    csv.imbue(std::locale::classic());
    csv << std::fixed
        << "branch,system,system_confidence,generation,strahler_order,length_mm,radius_mm,"
           "couinaud,couinaud_confidence,flow_share,x_mm,y_mm,z_mm\n";
    for (const BranchRow& row : rows) {
        csv << row.branch + 1 << ',' << name_of(row.system) << ',' << std::setprecision(3)
            << row.system_confidence << ',' << row.generation << ',' << row.strahler_order << ','
            << row.length_mm << ',' << row.radius_mm << ',';
        if (row.couinaud > 0)
            csv << row.couinaud << ',' << row.couinaud_confidence << ',';
        else
            csv << ",,";
        if (row.flow_share) csv << std::setprecision(6) << *row.flow_share << std::setprecision(3);
        csv << ',' << row.middle_mm.x() << ',' << row.middle_mm.y() << ',' << row.middle_mm.z()
            << '\n';
    }
    return csv.str();
}

}  // namespace hepatica
