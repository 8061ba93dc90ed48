// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/step/device_touches.h"

#include <algorithm>
#include <iterator>

#include "core/base/small_matrix_eigen.h"

namespace hepatica::gpu {
namespace {

std::vector<Vector3<double>> plain(std::span<const Vec3> places) {
    std::vector<Vector3<double>> all;
    for (const Vec3& x : places) all.push_back(small::from_eigen(x));
    return all;
}

// The four nodes of each touch that move with it; -1 for nodes of weight 0.
template <class Touch>
void add_nodes(const std::vector<Touch>& touches, std::vector<int>& nodes) {
    for (const Touch& touch : touches)
        for (int a = 0; a < 4; ++a) {
            if constexpr (requires { touch.weights; }) {
                const bool has = a < static_cast<int>(std::size(touch.nodes));
                nodes.push_back(has && touch.weights[a] != 0.0 ? touch.nodes[a] : -1);
            } else {
                nodes.push_back(touch.nodes[a]);
            }
        }
}

}  // namespace

DeviceTouches::DeviceTouches(Machine& machine, std::span<const Vec3> standing_mm)
    : machine_(machine),
      standing_(machine, plain(standing_mm)),
      row_(machine),
      tool_(machine),
      points_(machine),
      pairs_(machine),
      rubs_(machine),
      ties_(machine),
      touch_nodes_(machine),
      touched_(machine),
      begin_(machine),
      entries_(machine),
      pulls_(machine) {}

void DeviceTouches::set_nodes(std::size_t nodes) {
    list_by_node({});
    nodes_ = static_cast<int>(nodes);
    row_.set(std::vector<int>(nodes, -1));
    count_of_node_.assign(nodes, 0);
}

void DeviceTouches::set(const TouchList& list) {
    tool_.set(list.tool);
    points_.set(list.points);
    pairs_.set(list.pairs);
    rubs_.set(list.rubs);
    softening_ = list.softening;
    ties_.set(list.ties);
    std::vector<int> nodes;
    add_nodes(list.points, nodes);
    add_nodes(list.pairs, nodes);
    add_nodes(list.rubs, nodes);
    for (const TieTouch& tie : list.ties)
        nodes.insert(nodes.end(), {tie.nodes[0], tie.nodes[1], -1, -1});
    for (int& node : nodes)
        if (node >= nodes_) node = -1;
    list_by_node(std::move(nodes));
    pulls_.resize(first_tie() + ties_.size());
}

// Lists by node, with the touches of each node in their own order.
DeviceTouches::ByNode DeviceTouches::lists_by_node(const std::vector<int>& touch_nodes) {
    ByNode lists;
    for (const int node : touch_nodes)
        if (node >= 0 && count_of_node_[node]++ == 0) lists.nodes.push_back(node);
    std::ranges::sort(lists.nodes);
    for (const int node : lists.nodes) {
        lists.begin.push_back(lists.begin.back() + count_of_node_[node]);
        count_of_node_[node] = lists.begin[lists.begin.size() - 2];
    }
    lists.entries.resize(static_cast<std::size_t>(lists.begin.back()));
    for (std::size_t entry = 0; entry < touch_nodes.size(); ++entry)
        if (const int node = touch_nodes[entry]; node >= 0)
            lists.entries[count_of_node_[node]++] = static_cast<int>(entry);
    for (const int node : lists.nodes) count_of_node_[node] = 0;
    return lists;
}

void DeviceTouches::list_by_node(std::vector<int> touch_nodes) {
    if (touch_nodes == touch_nodes_.values()) return;
    ByNode lists = lists_by_node(touch_nodes);
    touch_nodes_.set(std::move(touch_nodes));
    if (lists.nodes != touched_.values()) {
        machine_.for_each(SetRows{touched_.read(), -1, 0, row_.view()});
        touched_.set(std::move(lists.nodes));
        machine_.for_each(SetRows{touched_.read(), 0, 1, row_.view()});
    }
    begin_.set(std::move(lists.begin));
    entries_.set(std::move(lists.entries));
}

void DeviceTouches::press(View<const Vector3<double>> position) {
    const PlacesView place = places(position);
    machine_.for_each(
        PressPoints{points_.read(), tool_.read(), place, pulls_.view(0, points_.size())});
    machine_.for_each(PressPairs{pairs_.read(), place, pulls_.view(points_.size(), pairs_.size())});
    machine_.for_each(RubPoints{rubs_.read(), place, pulls_.view(pads(), rubs_.size())});
    machine_.for_each(
        PullTies{softening_, ties_.read(), position, pulls_.view(first_tie(), ties_.size())});
}

void DeviceTouches::foresee(const NodeViews& nodes) {
    machine_.for_each(ForeseeSlips{nodes, rubs_.read(), places(nodes.position),
                                   pulls_.view(pads(), rubs_.size())});
}

TouchesView DeviceTouches::view() const {
    if (touched_.size() == 0) return {};
    return {row_.read(),
            begin_.read(),
            entries_.read(),
            touch_nodes_.read(),
            pulls_.read(),
            static_cast<int>(pads()),
            static_cast<int>(first_tie())};
}

}  // namespace hepatica::gpu
