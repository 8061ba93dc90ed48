// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/haptics/patch_feed.h"

#include <algorithm>
#include <utility>

#include "core/deform/body/torn_body.h"

namespace hepatica {
namespace {

// A sum of forces below this share of them is taken for rounding.
constexpr double rounding = 1e-9;

// End of the group of contacts, starting at `begin`, that are joined into one; groups have equal
// sizes.
std::size_t end_of_share(std::size_t begin, std::size_t contacts, int most) {
    const std::size_t shares = std::min<std::size_t>(contacts, static_cast<std::size_t>(most));
    const std::size_t share = begin * shares / contacts;
    return ((share + 1) * contacts + shares - 1) / shares;
}

// `pads` finds the body's vertices that bear a contact; null: nothing bears it, it is rigid.
void join_at_most(int most, std::span<const PadContact> points, const ToolContact* pads,
                  JoinedContacts& joined) {
    joined.contacts.clear();
    joined.loads.clear();
    joined.stiffness_un_per_mm.clear();
    for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
        LocalContact contact;
        SparseLoad load;
        double pressed_un = 0.0, stiffness_un_per_mm = 0.0;
        Vec3 force = Vec3::Zero();
        const std::size_t last = end_of_share(begin, points.size(), most);
        for (; end < last && points[end].part == points[begin].part; ++end) {
            const PadContact& point = points[end];
            const Vec3 own = point.force_un * point.normal;
            pressed_un += point.force_un;
            force += own;
            contact.at_mm += point.force_un * point.at_mm;
            stiffness_un_per_mm += point.stiffness_un_per_mm;
            for (int a = 0; pads != nullptr && a < 3; ++a) {
                load.vertices.push_back(pads->nodes_of(point)[a]);
                load.forces.emplace_back(point.weights[a] * own);
            }
        }
        contact.force_un = force.norm();
        if (!(contact.force_un > rounding * pressed_un)) continue;
        contact.normal = force / contact.force_un;
        contact.at_mm /= pressed_un;
        for (Vec3& own : load.forces) own /= contact.force_un;
        joined.contacts.push_back(contact);
        joined.loads.push_back(std::move(load));
        joined.stiffness_un_per_mm.push_back(stiffness_un_per_mm);
    }
}

}  // namespace

void join(std::span<const PadContact> points, const ToolContact& pads, JoinedContacts& joined) {
    join_at_most(most_local_contacts, points, &pads, joined);
}

void join_rigid(const ToolContact::ObstaclePress& press, JoinedContacts& joined) {
    join_at_most(most_rigid_contacts, press.contacts, nullptr, joined);
    for (LocalContact& contact : joined.contacts) contact.force_un *= press.share;
    for (double& stiffness : joined.stiffness_un_per_mm) stiffness *= press.share;
}

void PatchFeed::follow(const DeformPart& part) {
    const DeformSettings settings = part.settings();
    if (compliance_ && settings.wall_mm == wall_mm_ &&
        settings.tether_pa_per_mm2 == tether_pa_per_mm2_ && settings.stepper.model == model_ &&
        part.body().obstacles == compliance_->body().obstacles)
        return follow_tear(part.torn());
    wall_mm_ = settings.wall_mm;
    tether_pa_per_mm2_ = settings.tether_pa_per_mm2;
    model_ = settings.stepper.model;
    contact_.reset();
    compliance_.emplace(part.body(), model_);
    contact_.emplace(compliance_->body());
    split_ = split_version_ = 0;
    follow_tear(part.torn());
}

// The surface that a tear has left, bare faces included.
void PatchFeed::follow_tear(const TornTopology* torn) {
    const Body& whole = compliance_->body();
    const auto vertices = static_cast<std::uint64_t>(torn != nullptr ? torn->vertex_count() : 0);
    const std::uint64_t split =
        vertices > whole.rest_positions_mm.size() ? vertices - whole.rest_positions_mm.size() : 0;
    const std::uint64_t version = split > 0 ? torn->version() : 0;
    if (split == split_ && version == split_version_) return;
    Body body;
    body.obstacles = whole.obstacles;
    body.surface = split > 0 ? torn->surface() : whole.surface;
    body.rest_positions_mm = whole.rest_positions_mm;
    if (split > 0) inherit(torn->parents(), body.rest_positions_mm);
    contact_.emplace(body);
    split_ = split;
    split_version_ = version;
}

Eigen::MatrixXd PatchFeed::give(std::span<const Vec3> positions_mm, double dt_s) {
    if (positions_mm.size() != compliance_->body().rest_positions_mm.size()) {
        const auto count = static_cast<Eigen::Index>(joined_.loads.size());
        return Eigen::MatrixXd::Zero(count, count);
    }
    compliance_->follow(positions_mm, dt_s, joined_.loads);
    return compliance_->block(joined_.loads, dt_s);
}

void PatchFeed::fill(const DeformPart& part, double dt_s, LocalModel& model) {
    model.contacts.clear();
    model.compliance.resize(0, 0);
    model.tool = part.tool().has_value();
    if (!model.tool) {
        split_version_ =
            ~std::uint64_t{0};  // the body may be torn anew before there is a tool again
        return;
    }
    follow(part);
    model.tool_number = part.tools_added();
    const Tool& tool = *part.tool();
    model.centre_mm = tool.centre_mm();
    model.left_rad = tool.turn_rad;
    contact_->set(tool);
    join(contact_->contacts(part.positions_mm()), *contact_, joined_);
    join_rigid(contact_->pressed_by_obstacles(), rigid_);
    const auto own = static_cast<Eigen::Index>(joined_.contacts.size());
    const Eigen::Index all = own + static_cast<Eigen::Index>(rigid_.contacts.size());
    if (all == 0) return;
    model.contacts.assign(joined_.contacts.begin(), joined_.contacts.end());
    model.contacts.insert(model.contacts.end(), rigid_.contacts.begin(), rigid_.contacts.end());
    model.compliance.setZero(all, all);
    if (own > 0) model.compliance.topLeftCorner(own, own) = give(part.positions_mm(), dt_s);
    for (Eigen::Index i = 0; i < all; ++i) {
        const JoinedContacts& pads = i < own ? joined_ : rigid_;
        const auto k = static_cast<std::size_t>(i < own ? i : i - own);
        model.compliance(i, i) += 1.0 / pads.stiffness_un_per_mm[k];
    }
}

}  // namespace hepatica
