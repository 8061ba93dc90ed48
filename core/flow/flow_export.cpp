// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_export.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/atomic_write.h"
#include "core/base/error.h"

namespace hepatica {

namespace {

using Json = nlohmann::ordered_json;

// Factors from Pa to dyn/cm2, from Pa s/mm3 to dyn s/cm5 and from mm3/s to cm3/s.
constexpr double cgs_pressure = 10.0;
constexpr double cgs_resistance = 1e4;
constexpr double cgs_flow = 1e-3;

// std::to_chars ignores the locale, so that the decimal point is never a comma.
void append(std::string& text, double value) {
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text.append(digits, end);
}

class CsvRow {
  public:
    explicit CsvRow(std::string& text) : text_(text) {}
    ~CsvRow() { text_ += '\n'; }
    CsvRow(const CsvRow&) = delete;
    CsvRow& operator=(const CsvRow&) = delete;
    CsvRow& operator<<(double value) {
        separate();
        append(text_, value);
        return *this;
    }

  private:
    void separate() {
        if (!first_) text_ += ',';
        first_ = false;
    }
    std::string& text_;
    bool first_ = true;
};

// The segments through which fluid may flow: those connected to an inlet, a tear or a prescribed
// outlet pressure.
std::vector<char> connected_segments(const FlowNetwork& network, const FlowConditions& conditions) {
    const NodeSegments at = segments_at_nodes(network);
    std::vector<char> seen(network.segments.size(), 0);
    std::vector<char> reached(network.node_count, 0);
    std::vector<int> open;
    for (const Inlet& inlet : conditions.inlets) open.push_back(inlet.node);
    open.insert(open.end(), network.torn_nodes.begin(), network.torn_nodes.end());
    if (!conditions.outlet_pressures_pa.empty())
        open.insert(open.end(), network.outlet_nodes.begin(), network.outlet_nodes.end());
    for (const int node : open) reached[node] = 1;
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        for (int i = at.first[node]; i < at.first[node + 1]; ++i) {
            const int id = at.segments[i];
            const FlowSegment& s = network.segments[id];
            if (!s.open) continue;
            seen[id] = 1;
            for (const int other : {s.proximal_node, s.distal_node})
                if (!reached[other]) {
                    reached[other] = 1;
                    open.push_back(other);
                }
        }
    }
    return seen;
}

class SvZeroDModel {
  public:
    SvZeroDModel(const FlowNetwork& network, const FlowConditions& conditions)
        : network_(network),
          conditions_(conditions),
          degree_(network.node_count, 0),
          ends_(network.node_count) {
        for (const FlowSegment& s : network.segments) {
            ++degree_[s.proximal_node];
            ++degree_[s.distal_node];
        }
        const std::vector<char> connected = connected_segments(network, conditions);
        for (std::size_t i = 0; i < network.segments.size(); ++i)
            if (connected[i]) add_vessel(static_cast<int>(i));
        for (std::size_t i = 0; i < conditions.inlets.size(); ++i) add_inlet(i);
        for (std::size_t o = 0; o < network.outlet_nodes.size(); ++o) add_outlet(o);
        for (const int node : network.torn_nodes)
            add_pressure(node, "TORN_" + std::to_string(node), conditions.ambient_pressure_pa);
        for (int node = 0; node < network.node_count; ++node) close_or_join(node);
    }

    Json json() const {
        std::string description =
            "Vessel network exported by Hepatica, in centimetre, gram, second. "
            "R_poiseuille is the laminar resistance of the conical segment.";
        if (conditions_.law != PressureLaw::regime)
            description += " The turbulent friction of the form '" + name_of(conditions_.law) +
                           "' is not part of it.";
        else
            description += " Where the Reynolds number exceeds 2000 this is too little.";
        return {{"description", {{"description of test case", description}}},
                {"simulation_parameters",
                 {{"number_of_cardiac_cycles", 2}, {"number_of_time_pts_per_cardiac_cycle", 5}}},
                {"boundary_conditions", boundaries_},
                {"junctions", junctions_},
                {"vessels", vessels_}};
    }

  private:
    struct End {
        int vessel;
        bool inlet;  // the vessel's inlet is at the node
        bool bounded = false;
    };

    int add(const std::string& name, double length_cm, Json values, int from, int to) {
        const int id = static_cast<int>(vessels_.size());
        vessels_.push_back({{"vessel_id", id},
                            {"vessel_name", name},
                            {"vessel_length", length_cm},
                            {"zero_d_element_type", "BloodVessel"},
                            {"zero_d_element_values", std::move(values)}});
        if (from >= 0) ends_[from].push_back({id, true});
        if (to >= 0) ends_[to].push_back({id, false});
        return id;
    }

    void add_vessel(int segment) {
        const FlowSegment& s = network_.segments[segment];
        const double density = conditions_.resident.density_g_mm3;
        double resistance = 0.0;
        for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c)
            resistance +=
                density * kinematic_drop(network_.cones[c], conditions_.resident, 1.0).pressure_pa;
        Json values = {{"R_poiseuille", resistance * cgs_resistance}};
        if (conditions_.bifurcation_loss_coefficient > 0.0 && degree_[s.proximal_node] > 2)
            values["stenosis_coefficient"] =
                bifurcation_loss(conditions_.bifurcation_loss_coefficient,
                                 network_.cones[s.first_cone], conditions_.resident, density)
                    .pressure_pa *
                cgs_pressure / (cgs_flow * cgs_flow);
        add("segment" + std::to_string(s.tree_segment) + "_" + std::to_string(segment),
            0.1 * length_mm(network_, segment), std::move(values), s.proximal_node, s.distal_node);
    }

    void bound(End& end, const std::string& name, const char* type, Json values) {
        boundaries_.push_back(
            {{"bc_name", name}, {"bc_type", type}, {"bc_values", std::move(values)}});
        vessels_[end.vessel]["boundary_conditions"][end.inlet ? "inlet" : "outlet"] = name;
        end.bounded = true;
    }

    static Json steady(const char* name, double value) {
        return {{name, {value, value}}, {"t", {0.0, 1.0}}};
    }

    // A boundary condition belongs to one vessel end; a node with several ends gets a feeder vessel
    // without resistance.
    End& lone_end(int node, bool inlet) {
        if (ends_[node].size() == 1 && !ends_[node][0].bounded && ends_[node][0].inlet == inlet)
            return ends_[node][0];
        const int id = add("feeder" + std::to_string(node) + "_" + std::to_string(feeders_.size()),
                           0.0, {{"R_poiseuille", 0.0}}, inlet ? -1 : node, inlet ? node : -1);
        feeders_.push_back({id, inlet});
        return feeders_.back();
    }

    void add_inlet(std::size_t i) {
        const Inlet& inlet = conditions_.inlets[i];
        const std::string name = "INFLOW_" + std::to_string(i);
        if (inlet.kind == InletKind::mass_flow)
            bound(lone_end(inlet.node, true), name, "FLOW",
                  steady("Q", inlet.value / inlet.fluid.density_g_mm3 * cgs_flow));
        else
            bound(lone_end(inlet.node, true), name, "PRESSURE",
                  steady("P", inlet.value * cgs_pressure));
    }

    void add_pressure(int node, const std::string& name, double pressure_pa) {
        if (!ends_[node].empty())
            bound(lone_end(node, false), name, "PRESSURE", steady("P", pressure_pa * cgs_pressure));
    }

    void add_outlet(std::size_t o) {
        const int node = network_.outlet_nodes[o];
        if (ends_[node].empty()) return;
        const std::string name = "OUT_" + std::to_string(o);
        const double pressure = conditions_.outlet_pressures_pa.empty()
                                    ? conditions_.outlet_pressure_pa
                                    : conditions_.outlet_pressures_pa[o];
        const double resistance =
            conditions_.terminal_resistances.empty() ? 0.0 : conditions_.terminal_resistances[o];
        if (std::isinf(resistance)) return;
        if (resistance > 0.0)
            bound(lone_end(node, false), name, "RESISTANCE",
                  {{"R", resistance * cgs_resistance}, {"Pd", pressure * cgs_pressure}});
        else
            add_pressure(node, name, pressure);
    }

    void close_or_join(int node) {
        std::vector<End>& ends = ends_[node];
        if (ends.size() == 1 && !ends[0].bounded)
            bound(ends[0], "CLOSED_" + std::to_string(node), "FLOW", steady("Q", 0.0));
        if (ends.size() < 2) return;
        Json inlets = Json::array();
        Json outlets = Json::array();
        for (const End& end : ends) (end.inlet ? outlets : inlets).push_back(end.vessel);
        junctions_.push_back({{"junction_name", "J" + std::to_string(node)},
                              {"junction_type", "NORMAL_JUNCTION"},
                              {"inlet_vessels", inlets},
                              {"outlet_vessels", outlets}});
    }

    const FlowNetwork& network_;
    const FlowConditions& conditions_;
    std::vector<int> degree_;
    std::vector<std::vector<End>> ends_;
    std::vector<End> feeders_;
    Json vessels_ = Json::array();
    Json junctions_ = Json::array();
    Json boundaries_ = Json::array();
};

}  // namespace

void write_series_csv(const std::filesystem::path& file, const InjectionResult& injection) {
    std::string text =
        "time_s,inlet_pressure_pa,inlet_flow_g_s,injected_g,inside_g,delivered_g,"
        "delivered_fraction,filled_fraction";
    for (std::size_t i = 0; i < injection.territories.size(); ++i)
        text += ",territory_" + std::to_string(i) + "_g";
    for (const int node : injection.outlet_nodes)
        text += ",outlet_node_" + std::to_string(node) + "_g";
    text += '\n';
    for (const InjectionSample& s : injection.series) {
        CsvRow row(text);
        row << s.time_s << s.inlet_pressure_pa << s.inlet_flow_g_s << s.injected_g << s.inside_g
            << s.delivered_g << (s.injected_g > 0.0 ? s.delivered_g / s.injected_g : 0.0)
            << s.filled_fraction;
        for (const double mass : s.territory_mass_g) row << mass;
        for (const double mass : s.outlet_mass_g) row << mass;
    }
    write_text_atomically(file, text);
}

void write_filled_lengths_csv(const std::filesystem::path& file, const InjectionResult& injection) {
    if (injection.series.empty() || injection.series.front().filled_length_mm.empty())
        throw InputError("the filled lengths were not recorded", file.string(),
                         "Ask for them before the injection");
    std::string text = "time_s";
    for (std::size_t i = 0; i < injection.series.front().filled_length_mm.size(); ++i)
        text += ",segment_" + std::to_string(i) + "_mm";
    text += '\n';
    for (const InjectionSample& s : injection.series) {
        CsvRow row(text);
        row << s.time_s;
        for (const float length : s.filled_length_mm) row << static_cast<double>(length);
    }
    write_text_atomically(file, text);
}

void write_series_csv(const std::filesystem::path& file, const Embolization& embolization) {
    std::string text =
        "beads_injected,flow_mm3_s,inlet_pressure_pa,beads_lodged,beads_passed,open_outlets\n";
    for (const EmbolizationSample& s : embolization.series) {
        CsvRow row(text);
        row << s.injected << s.flow_mm3_s << s.inlet_pressure_pa << s.lodged << s.passed
            << s.open_outlets;
    }
    write_text_atomically(file, text);
}

std::string svzerod_json(const FlowNetwork& network, const FlowConditions& conditions) {
    return SvZeroDModel(network, conditions).json().dump(2) + "\n";
}

void write_svzerod_json(const std::filesystem::path& file, const FlowNetwork& network,
                        const FlowConditions& conditions) {
    write_text_atomically(file, svzerod_json(network, conditions));
}

}  // namespace hepatica
