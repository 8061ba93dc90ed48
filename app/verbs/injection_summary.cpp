// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/injection_summary.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hepatica {

namespace {

constexpr std::size_t most_rows = 10;

Json arrivals(const Json& arrival_s) {
    std::vector<double> reached;
    for (const Json& time_s : arrival_s)
        if (time_s.is_number()) reached.push_back(time_s.get<double>());
    Json found{{"segments", arrival_s.size()}, {"reached", reached.size()}};
    if (reached.empty()) return found;
    std::ranges::sort(reached);
    found["first_s"] = reached.front();
    found["median_s"] = reached[reached.size() / 2];
    found["last_s"] = reached.back();
    return found;
}

Json largest_flows(const Json& flow_g_s, const Json& arrival_s) {
    std::vector<Json> rows;
    for (const auto& [segment, flow] : flow_g_s.items())
        rows.push_back(
            {{"segment", segment}, {"flow_g_s", flow}, {"arrival_s", arrival_s.at(segment)}});
    std::ranges::stable_sort(rows, std::ranges::greater(), [](const Json& row) {
        return std::abs(row.at("flow_g_s").get<double>());
    });
    rows.resize(std::min(rows.size(), most_rows));
    return rows;
}

Json outlets(const Json& outlet_g) {
    const auto supplied =
        std::ranges::count_if(outlet_g, [](const Json& g) { return g.get<double>() > 0.0; });
    return {{"outlets", outlet_g.size()}, {"supplied", supplied}};
}

// Ten rows, evenly spaced, the last one included.
Json thinned_out(const Json& rows) {
    if (rows.size() <= most_rows) return rows;
    Json some = Json::array();
    for (std::size_t i = 1; i <= most_rows; ++i)
        some.push_back(rows[i * (rows.size() - 1) / most_rows]);
    return some;
}

Json territories(Json rows) {
    for (Json& row : rows) row["outlet_nodes"] = row["outlet_nodes"].size();
    return rows;
}

}  // namespace

Json summary_of_injection(const Json& answer) {
    Json shown;
    for (const auto& [name, value] : answer.items()) {
        if (name == "arrival_s")
            shown["arrival"] = arrivals(value);
        else if (name == "flow_g_s")
            shown["largest_flows"] = largest_flows(value, answer.at("arrival_s"));
        else if (name == "outlet_g")
            shown["delivery"] = outlets(value);
        else if (name == "filled_fraction")
            shown[name] = thinned_out(value);
        else if (name == "territories")
            shown[name] = territories(value);
        else
            shown[name] = value;
    }
    shown["every_segment"] = "with --json";
    return shown;
}

}  // namespace hepatica
