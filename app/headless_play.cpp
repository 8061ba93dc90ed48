// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless_play.h"

#include <array>
#include <cstdio>
#include <functional>
#include <utility>

#include "app/case_picture.h"
#include "app/step_times.h"
#include "core/base/error.h"
#include "core/flow/injection.h"
#include "core/scene/frame.h"
#include "core/scene/world.h"
#include "core/session/script.h"
#include "core/session/session.h"
#include "render/chart.h"

namespace hepatica {

namespace {

using Json = nlohmann::ordered_json;

constexpr double pull_mm = 25.0;
constexpr int pull_steps = 60;
constexpr int hold_steps = 60;
constexpr int settle_steps = 240;

// Steps a session and records the cost of its steps.
class Player {
  public:
    Player(Session& session, Job& job) : session_(session), job_(job) {}

    void step(int count) {
        for (int i = 0; i < count; ++i) {
            session_.finish_injection();
            times_.add(session_.step(job_));
            job_.throw_if_cancelled();
        }
        session_.update_frame();
    }
    const Frame& frame() const { return session_.frame(); }
    const StepTimes& times() const { return times_; }

  private:
    Session& session_;
    Job& job_;
    StepTimes times_;
};

// Towards the upper left of the anterior picture, so that the pull is visible.
Vec3 pull_way_mm() {
    return Vec3(-1.0, 0.0, 1.0).normalized() * pull_mm;
}

// Box around the tree at rest and the target of the hand.
std::array<Vec3, 2> box_of_play(const Frame& rest, const Vec3& held) {
    const Vec3 target = held + pull_way_mm();
    const auto [low, high] = rest.box_mm();
    return {low.cwiseMin(target), high.cwiseMax(target)};
}

Json pull(Session& session, const Vec3& held, Player& player, Album& album) {
    session.post(GrabPoint{held});
    for (int i = 1; i <= pull_steps; ++i) {
        session.post(MoveGrab{held + pull_way_mm() * i / pull_steps});
        player.step(1);
    }
    player.step(hold_steps);
    album.add(player.frame(), "2_pull", "A vessel pulled by 25 mm, its ends held.");
    const auto grab = player.frame().grab;
    session.post(ReleaseGrab{});
    player.step(settle_steps);
    album.add(player.frame(), "3_released", "Let go, four seconds later.");
    Json facts;
    facts["hand_moved_mm"] = pull_mm;
    if (grab) {
        facts["vessel_followed_mm"] = (grab->point_mm - held).norm();
        facts["force_mN"] = grab->force_un * 1e-3;
    }
    return facts;
}

// Returns the drug of the pictures, the last of which is at its end.
DrugView watch_injection(Session& session, const Vec3& tip_mm, Player& player, Album& album) {
    session.post(InjectDrug{tip_mm});
    session.post(FinishInjection{});
    player.step(1);
    const DrugView drug = player.frame().drug;
    if (!drug.injection)
        throw InputError("is not possible: " + player.frame().statistics.message, "the injection",
                         "Play on vessels that are longer");
    for (const int percent : drug_moments_percent) {
        const double time_s = drug.end_s * percent / 100.0;
        session.post(SetDrugTime{time_s});
        session.post(PlayDrug{false});
        player.step(1);
        char caption[80];
        std::snprintf(caption, sizeof caption, "The drug front %.3g s after the injection began.",
                      time_s);
        album.add(player.frame(), "4_drug_" + std::to_string(percent), caption);
    }
    return drug;
}

Chart curve_over_time(const InjectionResult& injection, const std::string& title,
                      const std::string& unit,
                      const std::function<double(const InjectionSample&)>& value) {
    Chart chart{title, "Time (s)", unit, {Curve{title, {}, {}}}};
    for (const InjectionSample& sample : injection.series) {
        chart.curves[0].x.push_back(sample.time_s);
        chart.curves[0].y.push_back(value(sample));
    }
    return chart;
}

// Computes the injection of the pictures again, through the same tears, with its curves up to the
// last picture.
Json injection_facts(const VesselTree& tree, const DrugView& drug, Album& album, Job& job) {
    InjectionOptions options = *drug.injection;
    options.until_s = drug.end_s;
    options.step_s = drug.end_s / 200.0;
    const InjectionResult injection = inject(tree, options, job);
    album.add(curve_over_time(injection, "Share of the vessels filled with the drug", "Share",
                              [](const InjectionSample& s) { return s.filled_fraction; }),
              "5_filled");
    album.add(
        curve_over_time(injection, "Share of the injected drug delivered through the ends", "Share",
                        [](const InjectionSample& s) {
                            return s.injected_g > 0.0 ? s.delivered_g / s.injected_g : 0.0;
                        }),
        "6_delivered");
    const InjectionSample& last = injection.series.back();
    return {{"drug", options.second_phase.name},
            {"void_fraction", options.void_fraction},
            {"pressure_law", name_of(options.law)},
            {"mass_flow_g_s", options.mass_flow_g_s},
            {"duration_s", last.time_s},
            {"inlet_pressure_begin_pa", injection.series.front().inlet_pressure_pa},
            {"inlet_pressure_end_pa", last.inlet_pressure_pa},
            {"injected_g", last.injected_g},
            {"inside_g", last.inside_g},
            {"delivered_g", last.delivered_g},
            {"mass_error_relative", injection.balance.error_relative()}};
}

}  // namespace

HeadlessPlay play_headless(std::shared_ptr<const PatientCase> patient,
                           const std::filesystem::path& folder, Job& job,
                           const DeformBackEnd& back_end) {
    Session session(patient, default_scene(), job, back_end);
    Player player(session, job);
    job.begin_stage("Playing");
    player.step(1);
    const Vec3 held = point_on_longest_path(patient->tree, 0.5);
    // All pictures show the same box, so that they can be compared.
    PictureOptions pictures{.fitted_box_mm = box_of_play(player.frame(), held)};
    colour_vessels(session.world(), *patient, false, pictures);
    Album album(folder, std::move(pictures));
    album.add(player.frame(), "1_patient", "The vessel tree from the front.");
    job.advance(0.1);

    HeadlessPlay played;
    played.simulation = pull(session, held, player, album);
    job.advance(0.5);
    const Vec3 tip_mm = point_on_longest_path(patient->tree, 0.0);
    const DrugView drug = watch_injection(session, tip_mm, player, album);
    const StepTimes& times = player.times();
    played.simulation["steps"] = times.steps();
    played.simulation["steps_asleep"] = times.asleep();
    played.simulation["step_ms_median"] = times.quantile(0.5);
    played.simulation["step_ms_max"] = times.quantile(1.0);
    played.simulation["frames_in_time"] = times.frames_in_time();
    const FrameStatistics& statistics = player.frame().statistics;
    played.simulation["setting"] = statistics.setting;
    played.simulation["expected_error"] = statistics.expected_error;
    played.simulation["error_reference"] = statistics.error_reference;
    played.injection = injection_facts(patient->tree, drug, album, job);
    played.pictures = album.pictures();
    return played;
}

}  // namespace hepatica
