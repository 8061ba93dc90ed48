// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flow/flow_network.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/flow/tube_law.h"

namespace hepatica {

namespace {

using std::numbers::pi;

double volume_within(const Cone& c, double x_mm) {
    const double share = c.length_mm > 0.0 ? x_mm / c.length_mm : 0.0;
    const double r = c.proximal_radius_mm + share * (c.distal_radius_mm - c.proximal_radius_mm);
    return volume_mm3({c.proximal_radius_mm, r, x_mm});
}

// x = 3V / (pi (R^2 + R R1 + R1^2)) with the radius R at x; avoids a difference of radii.
double length_holding(const Cone& c, double volume) {
    const double r1 = c.proximal_radius_mm;
    if (!(c.length_mm > 0.0)) return 0.0;
    const double taper = (c.distal_radius_mm - r1) / c.length_mm;
    const double cube = r1 * r1 * r1 + 3.0 * taper * volume / pi;
    const double r = std::cbrt(std::max(cube, 0.0));
    return std::min(3.0 * volume / (pi * (r * r + r * r1 + r1 * r1)), c.length_mm);
}

// Least squares line over arclength through radii that vary linearly between the points.
Cone fitted_cone(const VesselSegment& segment) {
    double length = 0.0;
    double moment0 = 0.0;
    double moment1 = 0.0;
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
        const double step = (segment.points_mm[i] - segment.points_mm[i - 1]).norm();
        const double r1 = segment.radii_mm[i - 1];
        const double r2 = segment.radii_mm[i];
        moment0 += 0.5 * step * (r1 + r2);
        moment1 += step * (0.5 * length * (r1 + r2) + step * (r1 + 2.0 * r2) / 6.0);
        length += step;
    }
    const double mean = moment0 / length;
    const double slope = 12.0 * (moment1 / length - 0.5 * length * mean) / (length * length);
    const auto radii = std::ranges::minmax(segment.radii_mm);
    const auto at = [&](double from_middle) {
        return std::clamp(mean + slope * from_middle, radii.min, radii.max);
    };
    return {at(-0.5 * length), at(0.5 * length), length};
}

void append_cones(const VesselSegment& segment, SegmentShape shape, std::vector<Cone>& cones) {
    if (shape == SegmentShape::one_cone) {
        cones.push_back(fitted_cone(segment));
        return;
    }
    for (std::size_t i = 1; i < segment.points_mm.size(); ++i)
        cones.push_back({segment.radii_mm[i - 1], segment.radii_mm[i],
                         (segment.points_mm[i] - segment.points_mm[i - 1]).norm()});
}

void find_ends(const VesselTree& tree, FlowNetwork& network) {
    std::vector<char> is_root(tree.nodes.size(), 0);
    for (const int root : roots(tree)) {
        const int node = tree.segments[root].proximal_node;
        if (!is_root[node]) network.root_nodes.push_back(node);
        is_root[node] = 1;
    }
    const std::vector<int> degrees = node_degrees(tree);
    for (int n = 0; n < network.node_count; ++n)
        if (degrees[n] == 1 && !is_root[n]) network.outlet_nodes.push_back(n);
}

}  // namespace

FlowNetwork network_of(const VesselTree& tree, SegmentShape shape) {
    validate(tree);
    FlowNetwork network;
    network.node_count = static_cast<int>(tree.nodes.size());
    network.segments.reserve(tree.segments.size() + 4);
    for (std::size_t i = 0; i < tree.segments.size(); ++i) {
        const VesselSegment& from = tree.segments[i];
        FlowSegment to;
        to.proximal_node = from.proximal_node;
        to.distal_node = from.distal_node;
        to.first_cone = static_cast<int>(network.cones.size());
        append_cones(from, shape, network.cones);
        to.cone_count = static_cast<int>(network.cones.size()) - to.first_cone;
        to.tree_segment = static_cast<int>(i);
        // A ring on a single node carries no steady flow.
        to.open = from.proximal_node != from.distal_node;
        network.segments.push_back(to);
    }
    find_ends(tree, network);
    validate(network);
    return network;
}

void validate(const FlowNetwork& network) {
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
        const FlowSegment& s = network.segments[i];
        const auto reject = [&](const std::string& what) {
            throw InputError(what, "segment " + std::to_string(i),
                             "Correct the vessel tree there, or delete the segment");
        };
        if (s.proximal_node < 0 || s.proximal_node >= network.node_count || s.distal_node < 0 ||
            s.distal_node >= network.node_count)
            reject("it names a node that does not exist");
        if (s.open && s.proximal_node == s.distal_node)
            reject("it begins and ends in the same node");
        if (s.cone_count < 1 || s.first_cone < 0 ||
            s.first_cone + s.cone_count > static_cast<int>(network.cones.size()))
            reject("it has no cones");
        for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c) {
            try {
                validate(network.cones[c]);
            } catch (const InputError& error) {
                reject(error.problem());
            }
        }
    }
    for (const std::vector<int>* nodes :
         {&network.root_nodes, &network.outlet_nodes, &network.torn_nodes})
        for (const int node : *nodes)
            if (node < 0 || node >= network.node_count)
                throw InputError("node " + std::to_string(node) + " does not exist",
                                 "vessel network", "Correct the list of roots and outlets");
}

double volume_mm3(const Cone& c) {
    const double r1 = c.proximal_radius_mm;
    const double r2 = c.distal_radius_mm;
    return pi * c.length_mm * (r1 * r1 + r1 * r2 + r2 * r2) / 3.0;
}

double length_mm(const FlowNetwork& network, int segment) {
    const FlowSegment& s = network.segments[segment];
    double length = 0.0;
    for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c)
        length += network.cones[c].length_mm;
    return length;
}

double volume_mm3(const FlowNetwork& network, int segment) {
    const FlowSegment& s = network.segments[segment];
    double volume = 0.0;
    for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c)
        volume += volume_mm3(network.cones[c]);
    return volume;
}

double smallest_radius_mm(const FlowNetwork& network, int segment) {
    const FlowSegment& s = network.segments[segment];
    double smallest = HUGE_VAL;
    for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c)
        smallest = std::min(
            {smallest, network.cones[c].proximal_radius_mm, network.cones[c].distal_radius_mm});
    return smallest;
}

double volume_mm3(const FlowNetwork& network) {
    double volume = 0.0;
    for (std::size_t i = 0; i < network.segments.size(); ++i)
        volume += volume_mm3(network, static_cast<int>(i));
    return volume;
}

double volume_up_to_mm3(const FlowNetwork& network, int segment, double arclength_mm) {
    const FlowSegment& s = network.segments[segment];
    double volume = 0.0;
    double left = std::max(arclength_mm, 0.0);
    for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c) {
        const Cone& cone = network.cones[c];
        if (left < cone.length_mm) return volume + volume_within(cone, left);
        volume += volume_mm3(cone);
        left -= cone.length_mm;
    }
    return volume;
}

double arclength_at_mm(const FlowNetwork& network, int segment, double volume) {
    const FlowSegment& s = network.segments[segment];
    double arclength = 0.0;
    double left = std::max(volume, 0.0);
    for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c) {
        const Cone& cone = network.cones[c];
        const double held = volume_mm3(cone);
        if (left < held) return arclength + length_holding(cone, left);
        arclength += cone.length_mm;
        left -= held;
    }
    return arclength;
}

double proximal_radius_mm(const FlowNetwork& network, int segment) {
    return network.cones[network.segments[segment].first_cone].proximal_radius_mm;
}

double distal_radius_mm(const FlowNetwork& network, int segment) {
    const FlowSegment& s = network.segments[segment];
    return network.cones[s.first_cone + s.cone_count - 1].distal_radius_mm;
}

NetworkPoint locate(const FlowNetwork& network, const TreePoint& point) {
    // Pieces that divide() appended are at the end of the list and few; the first piece of a tree
    // segment keeps its index.
    const int count = static_cast<int>(network.segments.size());
    if (point.segment < 0 || point.segment >= count ||
        network.segments[point.segment].tree_segment != point.segment ||
        std::isnan(point.arclength_mm))
        throw InputError("there is no segment " + std::to_string(point.segment), "vessel network",
                         "Choose a point on the vessel tree");
    NetworkPoint best{point.segment, point.arclength_mm};
    for (int i = count - 1; i > point.segment; --i) {
        const FlowSegment& s = network.segments[i];
        if (s.tree_segment == i) break;
        if (s.tree_segment != point.segment || s.offset_mm > point.arclength_mm) continue;
        if (best.segment == point.segment || s.offset_mm > network.segments[best.segment].offset_mm)
            best = {i, point.arclength_mm - s.offset_mm};
    }
    best.arclength_mm = std::clamp(best.arclength_mm, 0.0, length_mm(network, best.segment));
    return best;
}

int divide(FlowNetwork& network, const TreePoint& point) {
    const auto [segment, arclength] = locate(network, point);
    const double length = length_mm(network, segment);
    const double near = std::max(1e-6, 1e-9 * length);
    if (arclength <= near) return network.segments[segment].proximal_node;
    if (arclength >= length - near) return network.segments[segment].distal_node;
    const int node = network.node_count++;
    FlowSegment proximal = network.segments[segment];
    FlowSegment distal = proximal;
    distal.offset_mm += arclength;
    distal.jet_loss = 0.0;  // lost once, as a share at the proximal end
    distal.proximal_node = node;
    proximal.distal_node = node;
    // Both halves get new cones at the end of the list.
    const int first = proximal.first_cone;
    const int count = proximal.cone_count;
    const auto begin_half = [&](FlowSegment& half) {
        half.first_cone = static_cast<int>(network.cones.size());
        half.cone_count = 0;
    };
    const auto add = [&](FlowSegment& half, const Cone& cone) {
        if (cone.length_mm <= 0.0 && half.cone_count > 0) return;
        network.cones.push_back(cone);
        ++half.cone_count;
    };
    std::vector<Cone> after;
    begin_half(proximal);
    double left = arclength;
    for (int c = first; c < first + count; ++c) {
        const Cone cone = network.cones[c];
        if (left >= cone.length_mm) {
            add(proximal, cone);
        } else if (left > 0.0) {
            const double share = left / cone.length_mm;
            const double r =
                cone.proximal_radius_mm + share * (cone.distal_radius_mm - cone.proximal_radius_mm);
            add(proximal, {cone.proximal_radius_mm, r, left});
            after.push_back({r, cone.distal_radius_mm, cone.length_mm - left});
        } else {
            after.push_back(cone);
        }
        left -= cone.length_mm;
    }
    begin_half(distal);
    for (const Cone& cone : after) add(distal, cone);
    network.segments[segment] = proximal;
    network.segments.push_back(distal);
    return node;
}

int place_catheter(FlowNetwork& network, const TreePoint& tip, bool wedged) {
    const int node = divide(network, tip);
    if (wedged)
        for (FlowSegment& s : network.segments)
            if (s.distal_node == node) s.open = false;
    return node;
}

std::array<int, 2> tear(FlowNetwork& network, const TreePoint& point) {
    const int node = divide(network, point);
    FlowSegment *before = nullptr, *behind = nullptr;  // the pieces of this vessel at the node
    int others = 0;
    for (FlowSegment& s : network.segments) {
        const bool of_vessel = s.tree_segment == point.segment;
        if (of_vessel && s.distal_node == node)
            before = &s;
        else if (of_vessel && s.proximal_node == node)
            behind = &s;
        else if (s.proximal_node == node || s.distal_node == node)
            ++others;
    }
    std::array<int, 2> stumps{node, node};
    if (before != nullptr)
        stumps[0] = before->distal_node = network.node_count++;
    else if (others > 0)
        stumps[1] = behind->proximal_node = network.node_count++;
    if (std::ranges::find(network.torn_nodes, node) == network.torn_nodes.end())
        network.torn_nodes.push_back(node);
    if (stumps[0] != stumps[1]) network.torn_nodes.push_back(network.node_count - 1);
    std::erase(network.outlet_nodes, node);
    return stumps;
}

int open_side(FlowNetwork& network, const TreePoint& point) {
    const int node = divide(network, point);
    if (std::ranges::find(network.torn_nodes, node) == network.torn_nodes.end())
        network.torn_nodes.push_back(node);
    return node;
}

std::vector<TearOpening> tear_all(FlowNetwork& network, std::span<const TreePoint> points,
                                  std::span<const double> areas_mm2,
                                  std::span<const std::uint8_t> sides) {
    std::vector<TearOpening> openings;
    const auto add = [&](std::size_t tear, int node) {
        const auto found = std::ranges::find(network.torn_nodes, node);
        openings.push_back(
            {tear, static_cast<std::size_t>(found - network.torn_nodes.begin()), areas_mm2[tear]});
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!sides.empty() && sides[i] != 0) {
            add(i, open_side(network, points[i]));
            continue;
        }
        const auto [proximal, distal] = tear(network, points[i]);
        add(i, distal);
        if (proximal != distal) add(i, proximal);
    }
    return openings;
}

std::vector<double> torn_areas_mm2(const FlowNetwork& network,
                                   std::span<const TearOpening> openings) {
    std::vector<double> areas(network.torn_nodes.size(), 0.0);
    for (const TearOpening& one : openings) areas[one.torn_node] += one.area_mm2;
    return areas;
}

std::vector<double> of_outlets_left(const FlowNetwork& torn, std::span<const int> whole_outlets,
                                    std::span<const double> values) {
    std::vector<double> left;
    for (std::size_t i = 0; i < whole_outlets.size(); ++i)
        if (std::ranges::find(torn.outlet_nodes, whole_outlets[i]) != torn.outlet_nodes.end())
            left.push_back(values[i]);
    return left;
}

void set_open(FlowNetwork& network, int tree_segment, bool open) {
    for (FlowSegment& s : network.segments)
        if (s.tree_segment == tree_segment && s.proximal_node != s.distal_node) s.open = open;
}

void squeeze(FlowNetwork& network, int tree_segment, double from_mm, double to_mm, double share) {
    if (!(share > 0.0 && share <= 1.0))
        throw InputError("is " + number_text(share), "the share of a lumen that is left open",
                         "Give more than 0, up to 1");
    if (share == 1.0 || !(to_mm > from_mm)) return;
    divide(network, {.segment = tree_segment, .arclength_mm = from_mm});
    divide(network, {.segment = tree_segment, .arclength_mm = to_mm});
    FlowSegment* first = nullptr;
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
        FlowSegment& s = network.segments[i];
        const double middle = s.offset_mm + 0.5 * length_mm(network, static_cast<int>(i));
        if (s.tree_segment != tree_segment || middle <= from_mm || middle >= to_mm) continue;
        for (int c = s.first_cone; c < s.first_cone + s.cone_count; ++c) {
            network.cones[c].proximal_radius_mm *= std::sqrt(share);
            network.cones[c].distal_radius_mm *= std::sqrt(share);
        }
        // An earlier jet loses the head that it lost before, of a higher dynamic pressure.
        s.jet_loss *= share * share;
        if (first == nullptr || s.offset_mm < first->offset_mm) first = &s;
    }
    if (first != nullptr) first->jet_loss += jet_loss(share);
}

NodeSegments segments_at_nodes(const FlowNetwork& network) {
    NodeSegments at;
    at.first.assign(network.node_count + 1, 0);
    for (const FlowSegment& s : network.segments) {
        ++at.first[s.proximal_node + 1];
        ++at.first[s.distal_node + 1];
    }
    for (int n = 0; n < network.node_count; ++n) at.first[n + 1] += at.first[n];
    at.segments.resize(at.first.back());
    std::vector<int> next(at.first.begin(), at.first.end() - 1);
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
        at.segments[next[network.segments[i].proximal_node]++] = static_cast<int>(i);
        at.segments[next[network.segments[i].distal_node]++] = static_cast<int>(i);
    }
    return at;
}

}  // namespace hepatica
