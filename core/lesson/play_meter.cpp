// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/play_meter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/scene/vertex_places.h"

namespace hepatica {

namespace {

constexpr double millinewton_per_un = 1e-3;

const std::vector<Vec3>& rest_of(const Lesson& lesson, const PatientCase& patient) {
    return lesson.scene.deform ? patient.mesh.vertices_mm : patient.surface.vertices_mm;
}

std::vector<int> surface_vertices(const PatientCase& patient, bool deforms) {
    const std::vector<std::array<int, 3>> triangles =
        deforms ? boundary_triangles(patient.mesh) : patient.surface.triangles;
    std::vector<int> vertices;
    for (const std::array<int, 3>& t : triangles)
        vertices.insert(vertices.end(), t.begin(), t.end());
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

int nearest_of(const std::vector<int>& vertices, const std::vector<Vec3>& places_mm,
               const Vec3& to_mm) {
    return *std::ranges::min_element(vertices, {},
                                     [&](int v) { return (places_mm[v] - to_mm).squaredNorm(); });
}

// Mean position of the vertices.
template <class PlaceOf>
Vec3 middle_of(const std::vector<int>& vertices, const PlaceOf& place) {
    Vec3 sum = Vec3::Zero();
    for (const int v : vertices) sum += place(v);
    return sum / static_cast<double>(vertices.size());
}

// `vertices`: sorted, indices in the untorn body.
bool is_touched(const Frame& frame, const std::vector<int>& vertices) {
    return std::ranges::any_of(frame.tool->touched, [&](int touched) {
        return std::ranges::binary_search(vertices, frame.origin_of(touched));
    });
}

// Jaws touch with all of their length: what they are to hold belongs between them.
Vec3 place_of_touch(const ToolView& tool) {
    return tool.has_jaws() ? tool.working_mm() : tool.at_mm;
}

// Each vascular system is one, for example.
int pieces_of(const TetMesh& mesh) {
    DisjointSets sets(mesh.vertices_mm.size());
    for (const auto& corners : mesh.tetrahedra)
        for (const int other : corners)
            sets.unite(static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(other));
    return static_cast<int>(sets.count());
}

double share_reached(const std::vector<float>& arrivals, double time_s) {
    if (arrivals.empty()) return 0.0;
    const auto reached = std::ranges::upper_bound(arrivals, static_cast<float>(time_s));
    return static_cast<double>(reached - arrivals.begin()) / static_cast<double>(arrivals.size());
}

}  // namespace

PlayMeter::PlayMeter(const Lesson& lesson, std::shared_ptr<const PatientCase> patient)
    : patient_(std::move(patient)),
      dt_s_(lesson.scene.dt_s),
      rest_mm_(rest_of(lesson, *patient_)),
      on_surface_(surface_vertices(*patient_, lesson.scene.deform.has_value())),
      surface_(rest_mm_),
      felt_force_(dt_s_) {
    if (on_surface_.empty())
        throw InputError("has no surface", "the patient", "Reconstruct the patient first");
    std::vector<Vec3> places;
    for (const int v : on_surface_) places.push_back(rest_mm_[v]);
    const std::vector<VertexPlace> on_tree = places_of(places, patient_->tree);
    place_marks(lesson, on_tree);
    if (!lesson.scene.flow) return;
    std::optional<TargetRegion> target;
    in_target_.assign(on_surface_.size(), 0);
    if (lesson.target) {
        target.emplace(patient_->tree,
                       nearest_point(patient_->tree, position_of(*lesson.target, patient_->tree)));
        for (std::size_t i = 0; i < on_tree.size(); ++i)
            in_target_[i] = target->contains(on_tree[i].on_tree);
    }
    dose_.emplace(patient_->tree, target);
}

void PlayMeter::place_marks(const Lesson& lesson, const std::vector<VertexPlace>& on_tree) {
    moment_.marks.resize(lesson.marks.size());
    for (const LessonMark& mark : lesson.marks) {
        const Vec3 place = position_of(mark.place, patient_->tree);
        const TreePoint at = nearest_point(patient_->tree, place);
        std::vector<int> around;
        int nearest = -1;  // on the mark's segment
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < on_tree.size(); ++i) {
            const TreePoint& other = on_tree[i].on_tree;
            if (other.segment != at.segment) continue;
            const double along = std::abs(other.arclength_mm - at.arclength_mm);
            if (along <= on_tree[i].radius_mm) around.push_back(on_surface_[i]);
            if (along < least) nearest = on_surface_[i];
            least = std::min(least, along);
        }
        // A short segment may be nearest to no vertex at all.
        if (around.empty())
            around.push_back(nearest >= 0 ? nearest : nearest_of(on_surface_, rest_mm_, place));
        marks_rest_mm_.push_back(middle_of(around, [&](int v) { return rest_mm_[v]; }));
        marks_.push_back(std::move(around));
    }
}

std::vector<Vec3> PlayMeter::marks_in(const Frame& frame) const {
    assert(frame.positions_mm.size() >= 3 * rest_mm_.size());  // a torn body has more vertices
    std::vector<Vec3> places;
    for (const std::vector<int>& around : marks_)
        places.push_back(middle_of(around, [&](int v) { return frame.place_mm(v); }));
    return places;
}

void PlayMeter::begin(const Frame& frame) {
    if (frame.tear)
        before_ = *frame.tear;
    else  // tearing may begin later
        before_.pieces = pieces_of(patient_->mesh);
    surface_.see(frame);
    see_marks(frame);
    moment_.leak_g_s = before_.leak_g_s;
}

void PlayMeter::see(const Frame& frame, const std::stop_token& stop) {
    if (frame.statistics.paused) return;
    metrics_.time_s += dt_s_;
    see_hand(frame);
    see_contact(frame);
    see_marks(frame);
    see_tear(frame);
    see_drug(frame, stop);
}

void PlayMeter::see_hand(const Frame& frame) {
    const auto follow = [&](std::optional<Vec3>& last, const std::optional<Vec3>& now) {
        if (last && now) metrics_.path_mm += (*now - *last).norm();
        last = now;
    };
    follow(tip_, frame.tool ? std::optional(frame.tool->tip_mm) : std::nullopt);
    follow(hand_, frame.grab ? std::optional(frame.grab->target_mm) : std::nullopt);
    double force_un = 0.0;
    if (frame.grab) force_un += frame.grab->force_un;
    if (frame.tool) force_un += frame.tool->force_un.norm();
    felt_force_.see(frame);
    moment_.force_mn = felt_force_.sum_mn();
    moment_.grip_mn = frame.tool ? millinewton_per_un * frame.tool->grip_un : 0.0;
    metrics_.peak_force_mn = std::max(metrics_.peak_force_mn, moment_.force_mn);
    metrics_.impulse_mn_s += millinewton_per_un * force_un * dt_s_;
}

void PlayMeter::see_contact(const Frame& frame) {
    const bool touches = frame.tool && !frame.tool->touched.empty();
    moment_.holding = frame.grab.has_value() || touches;
    if (!touches) {
        since_touch_s_ += dt_s_;
        return;
    }
    if (begins_contact(since_touch_s_)) ++metrics_.contacts;
    since_touch_s_ = 0.0;
    metrics_.contact_s += dt_s_;
}

void PlayMeter::see_marks(const Frame& frame) {
    constexpr double far = std::numeric_limits<double>::infinity();
    const bool touches = frame.tool && !frame.tool->touched.empty();
    const std::vector<Vec3> places = marks_in(frame);
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        const Vec3& place = places[i];
        MarkMoment& mark = moment_.marks[i];
        mark.moved_mm = (place - marks_rest_mm_[i]).norm();
        mark.distance_mm = frame.tool   ? (frame.tool->working_mm() - place).norm()
                           : frame.grab ? (frame.grab->point_mm - place).norm()
                                        : far;
        // Touching the vessel at the mark counts as distance 0, whatever its thickness. Jaws are to
        // have it between them.
        if (touches && !frame.tool->has_jaws() && is_touched(frame, marks_[i]))
            mark.distance_mm = 0.0;
        mark.touch_mm = touches      ? (place_of_touch(*frame.tool) - place).norm()
                        : frame.grab ? (frame.grab->point_mm - place).norm()
                                     : far;
    }
}

void PlayMeter::see_tear(const Frame& frame) {
    surface_.see(frame);
    moment_.stretch = surface_.largest();
    metrics_.largest_stretch = std::max(metrics_.largest_stretch, moment_.stretch);
    moment_.leak_g_s = frame.tear ? frame.tear->leak_g_s : 0.0;
    if (!frame.tear) return;
    const auto raise = [](auto& metric, auto value) { metric = std::max(metric, value); };
    raise(metrics_.joints_broken, frame.tear->joints_broken - before_.joints_broken);
    raise(metrics_.torn_area_mm2, frame.tear->torn_area_mm2 - before_.torn_area_mm2);
    raise(metrics_.pieces_off, frame.tear->pieces - before_.pieces);
    raise(metrics_.blood_lost_g, frame.tear->leaked_g - before_.leaked_g);
}

// Sorted at each change of the arrival times, so that each step costs two binary searches. What
// injections before this one have reached stays reached.
void PlayMeter::take_arrivals(const DrugView& drug) {
    constexpr float at_once = -1.0f;
    target_arrivals_.clear();
    other_arrivals_.clear();
    if (!drug.arrival_s) return;
    for (std::size_t i = 0; i < on_surface_.size(); ++i) {
        const auto vertex = static_cast<std::size_t>(on_surface_[i]);
        (in_target_[i] != 0 ? target_arrivals_ : other_arrivals_)
            .push_back(drug.had_reached(vertex) ? at_once : (*drug.arrival_s)[vertex]);
    }
    std::ranges::sort(target_arrivals_);
    std::ranges::sort(other_arrivals_);
}

void PlayMeter::see_drug(const Frame& frame, const std::stop_token& stop) {
    if (!dose_) return;
    if (frame.drug.version != drug_.version) take_arrivals(frame.drug);
    drug_ = frame.drug;
    // A pump that stands ends the injection; what it filled stays filled.
    moment_.drug_present = drug_.arrival_s != nullptr && drug_.playing;
    moment_.target_filled = share_reached(target_arrivals_, drug_.time_s);
    moment_.elsewhere_filled = share_reached(other_arrivals_, drug_.time_s);
    dose_->see(frame.drug, stop);
    const Dose dose = dose_->total();
    metrics_.injected_g = dose.injected_g;
    metrics_.delivered_g = dose.delivered_g;
    metrics_.dose_target_g = dose.target_g;
    metrics_.dose_elsewhere_g = dose.elsewhere_g();
    metrics_.reflux_g = dose.reflux_g;
}

}  // namespace hepatica
