// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/paper/tear_figure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/paper/bent_axis.h"
#include "core/base/error.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/session/session.h"
#include "core/tear/torn_topology.h"

namespace hepatica {
namespace {

constexpr double shares_beside = 0.1;  // share of the longest path shown beyond the cut lines
constexpr double room_mm = 12.0;       // margin around the picture's content
constexpr int steps_after = 8;         // steps between the separation of a section and its picture

struct Step {
    double time_s = 0.0;
    double force_un = 0.0;
    TearReport tear;
    Frame frame;
};

std::vector<double> cut_shares(const Script& script) {
    std::vector<double> shares;
    for (const ScriptAction& action : script.actions)
        if (action.what == "cut_line" && action.place.share_of_longest_path)
            shares.push_back(*action.place.share_of_longest_path);
    if (shares.empty() || !script.scene || !script.scene->tear)
        throw InputError("names no scene that tears, or no cut line by its share", script.name,
                         "See assets/scripts/cut_line.json");
    std::ranges::sort(shares);
    return shares;
}

int steps_until_release(const Script& script) {
    double until_s = 5.0;
    for (const ScriptAction& action : script.actions)
        if (action.what == "release") until_s = action.at_s;
    return static_cast<int>(until_s / script.scene->dt_s);
}

// The axis in pieces that end at the cut lines; joined into one while nothing is torn through.
class Axis {
  public:
    Axis(const VesselTree& tree, const std::vector<double>& cuts, const DeformPart& deform) {
        std::vector<double> ends{std::max(0.0, cuts.front() - shares_beside)};
        constexpr double beside_cut = 0.02;
        for (const double cut : cuts) {
            ends.push_back(cut - beside_cut);
            ends.push_back(cut + beside_cut);
        }
        ends.push_back(std::min(1.0, cuts.back() + shares_beside));
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
            stretches_.emplace_back(tree, ends[i], ends[i + 1], deform.places());
    }

    std::vector<LineMark> in(const Frame& frame, bool torn) const {
        std::vector<LineMark> lines;
        for (const BentAxis& stretch : stretches_) {
            const std::vector<Vec3> points = stretch.in(frame);
            if (torn || lines.empty())
                lines.push_back({points, palette::bent_axis});
            else
                lines[0].points_mm.insert(lines[0].points_mm.end(), points.begin(), points.end());
        }
        return lines;
    }

  private:
    std::vector<BentAxis> stretches_;
};

double radius_at(const VesselTree& tree, const Vec3& point_mm) {
    return places_of({point_mm}, tree).front().radius_mm;
}

// A ring around the vessel at a cut line.
LineMark ring_at(const VesselTree& tree, double share) {
    const Vec3 centre = point_on_longest_path(tree, share);
    const Vec3 along =
        point_on_longest_path(tree, share + 0.01) - point_on_longest_path(tree, share - 0.01);
    const double radius = 1.5 * radius_at(tree, centre);
    const Vec3 first = along.unitOrthogonal(), second = along.normalized().cross(first);
    LineMark ring{.colour = palette::text, .width_px = 3.0};
    constexpr int corners = 48;
    for (int i = 0; i <= corners; ++i) {
        const double angle = 2.0 * M_PI * i / corners;
        ring.points_mm.push_back(centre + radius * std::cos(angle) * first +
                                 radius * std::sin(angle) * second);
    }
    return ring;
}

// Circles around the torn rims at each cut line, on the part that the hand does not hold.
std::vector<CircleMark> torn_places(const VesselTree& tree, const std::vector<double>& cuts,
                                    const DeformPart& deform, const Frame& frame) {
    if (!frame.tear || !frame.tear->rims || !frame.grab) return {};
    const std::vector<int> piece = deform.torn()->piece_of_vertices({});
    int held = 0;
    for (std::size_t v = 0; v < piece.size(); ++v)
        if ((frame.place_mm(static_cast<int>(v)) - frame.grab->point_mm).norm() <
            (frame.place_mm(held) - frame.grab->point_mm).norm())
            held = static_cast<int>(v);
    std::vector<CircleMark> circles;
    const bool one = std::ranges::count(piece, piece.front()) == std::ssize(piece);
    for (const double cut : cuts) {
        const Vec3 at = point_on_longest_path(tree, cut);
        const double radius = radius_at(tree, at);
        Vec3 sum = Vec3::Zero();
        int count = 0;
        for (std::size_t v = 0; v < piece.size(); ++v) {
            if ((*frame.tear->rims)[v] == 0 || (!one && piece[v] == piece[held]) ||
                (deform.rest_positions_mm()[v] - at).norm() > 4.0 * radius)
                continue;
            sum += frame.place_mm(static_cast<int>(v));
            ++count;
        }
        if (count > 0)
            circles.push_back({sum / count, std::max(4.0, 2.2 * radius), palette::torn_circle});
    }
    return circles;
}

// Indices of the steps that are shown, ascending.
std::array<std::size_t, 4> moments_of(const std::vector<Step>& steps) {
    const std::size_t last = steps.size() - 1;
    const auto first_with = [&](const auto& holds) {
        const auto found = std::ranges::find_if(steps, holds);
        return static_cast<std::size_t>(found - steps.begin());
    };
    std::size_t through =
        first_with([&](const Step& s) { return s.tear.pieces > steps.front().tear.pieces; });
    if (through > last)
        through = first_with([](const Step& s) { return s.tear.joints_broken > 0; });
    through = std::min(through, last);
    const auto hardest =
        std::max_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(through) + 1,
                         [](const Step& a, const Step& b) { return a.force_un < b.force_un; });
    const auto pulled = static_cast<std::size_t>(hardest - steps.begin());
    return {0, pulled, std::min(through + steps_after, last), last};
}

std::string words_of(char letter, const Step& step, bool first) {
    char text[200];
    if (first)
        std::snprintf(text, sizeof text, "(%c) At rest; rings: the cut lines.", letter);
    else
        std::snprintf(text, sizeof text,
                      "(%c) After %.2f s: the hand pulls with %.2f N; %d joints parted, %d of them "
                      "wholly; %d %s.",
                      letter, step.time_s, 1e-6 * step.force_un, step.tear.joints_parted,
                      step.tear.joints_broken, step.tear.pieces,
                      step.tear.pieces == 1 ? "piece" : "pieces");
    return text;
}

Chart force_chart(const std::vector<Step>& steps, const std::array<std::size_t, 4>& shown) {
    Chart chart{"Force of the hand", "Time (s)", "Force (N)", {Curve{"hand", {}, {}}}};
    for (const Step& step : steps) {
        chart.curves[0].x.push_back(step.time_s);
        chart.curves[0].y.push_back(1e-6 * step.force_un);
    }
    Curve points{"(a) to (d)", {}, {}, true};
    for (const std::size_t i : shown) {
        points.x.push_back(steps[i].time_s);
        points.y.push_back(1e-6 * steps[i].force_un);
    }
    chart.curves.push_back(points);
    return chart;
}

}  // namespace

TearFigure play_tear_figure(const std::shared_ptr<const PatientCase>& patient, const Script& script,
                            Job& job) {
    const std::vector<double> cuts = cut_shares(script);
    Session session(patient, *script.scene, job);
    const DeformPart& deform = *session.world().deform();
    const Axis axis(patient->tree, cuts, deform);
    const auto commands =
        schedule(script, patient->tree, script.scene->dt_s, steps_until_release(script));
    job.begin_stage("Tearing");
    TearFigure figure;
    std::vector<Step> steps;
    Eigen::AlignedBox3d box;
    for (const std::vector<Command>& now : commands) {
        for (const Command& command : now) session.post(command);
        const SessionStep done = session.step(job);
        session.update_frame();
        const Frame& frame = session.frame();
        if (done.paused)
            throw InputError(frame.statistics.message, script.name, "Report this with the case");
        steps.push_back(
            {frame.time_s, frame.grab ? frame.grab->force_un : 0.0, done.deform.tear, frame});
        figure.entropy_produced_max_nats =
            std::max(figure.entropy_produced_max_nats, done.deform.tear.entropy_produced_nats);
        figure.work_nj += done.deform.energy.tear_loss;
        figure.force_max_un = std::max(figure.force_max_un, steps.back().force_un);
        for (const LineMark& line : axis.in(frame, true))
            for (const Vec3& point : line.points_mm) box.extend(point);
        job.advance(static_cast<double>(steps.size()) / static_cast<double>(commands.size()));
    }
    figure.box_mm = {box.min() - Vec3::Constant(room_mm), box.max() + Vec3::Constant(room_mm)};
    figure.body_mass_error_relative = deform.mass_error_relative();
    const std::array<std::size_t, 4> shown = moments_of(steps);
    figure.force = force_chart(steps, shown);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Step& step = steps[shown[i]];
        figure.moments[i] = {
            .time_s = step.time_s,
            .force_un = step.force_un,
            .tear = step.tear,
            .lines = axis.in(step.frame, step.tear.pieces > steps.front().tear.pieces),
            .circles = {},
            .frame = step.frame,
            .words = words_of(static_cast<char>('a' + i), step, i == 0)};
    }
    for (const double cut : cuts) figure.moments[0].lines.push_back(ring_at(patient->tree, cut));
    figure.moments[3].circles = torn_places(patient->tree, cuts, deform, figure.moments[3].frame);
    return figure;
}

}  // namespace hepatica
