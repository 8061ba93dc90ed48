// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless_play.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>

#include "core/base/atomic_write.h"
#include "core/flow/injection.h"
#include "core/scene/world.h"
#include "core/session/script.h"
#include "core/session/session.h"
#include "render/chart.h"
#include "render/offscreen_picture.h"

namespace hepatica {

namespace {

using Json = nlohmann::ordered_json;

constexpr double pull_mm = 25.0;
constexpr int pull_steps = 60;
constexpr int hold_steps = 60;
constexpr int settle_steps = 240;
constexpr double mass_flow_g_s = 2.0;

// Steps a session and keeps account of what its steps cost.
class Player {
  public:
    Player(Session& session, Job& job) : session_(session), job_(job) {}

    void step(int count) {
        for (int i = 0; i < count; ++i) {
            step_ms_.push_back(session_.step().step_ms);
            job_.throw_if_cancelled();
        }
        session_.update_frame();
    }
    const Frame& frame() const { return session_.frame(); }
    std::vector<double> sorted_step_ms() const {
        std::vector<double> sorted = step_ms_;
        std::ranges::sort(sorted);
        return sorted;
    }

  private:
    Session& session_;
    Job& job_;
    std::vector<double> step_ms_;
};

class Album {
  public:
    explicit Album(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void add(const Frame& frame, const std::string& name, const std::string& caption) {
        const std::filesystem::path file = name + ".png";
        write_png(folder_ / file, draw_frame(frame, PictureOptions{}).picture);
        pictures_.push_back({file, caption});
    }
    void add(const Chart& chart, const std::string& name) {
        const std::filesystem::path file = name + ".png";
        write_png(folder_ / file, draw_chart(chart).picture);
        write_text_atomically(folder_ / (name + ".csv"), to_csv(chart));
        pictures_.push_back({file, chart.title});
    }
    std::vector<PlayedPicture> pictures() const { return pictures_; }

  private:
    std::filesystem::path folder_;
    std::vector<PlayedPicture> pictures_;
};

Json pull(Session& session, Player& player, Album& album) {
    const Vec3 held = point_on_longest_path(session.world().patient().tree, 0.5);
    session.post(GrabPoint{held});
    for (int i = 1; i <= pull_steps; ++i) {
        // Towards the viewer of the anterior picture's upper left, so that the pull is seen.
        const Vec3 way = Vec3(-1.0, 0.0, 1.0).normalized() * pull_mm * i / pull_steps;
        session.post(MoveGrab{held + way});
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

void watch_injection(Session& session, Player& player, Album& album) {
    InjectDrug injection;
    injection.point_mm = point_on_longest_path(session.world().patient().tree, 0.0);
    injection.mass_flow_g_s = mass_flow_g_s;
    session.post(injection);
    player.step(1);
    const double end_s = player.frame().drug.end_s;
    for (const int percent : {2, 10, 30, 100}) {
        const double time_s = end_s * percent / 100.0;
        session.post(SetDrugTime{time_s});
        session.post(PlayDrug{false});
        player.step(1);
        char caption[80];
        std::snprintf(caption, sizeof caption, "The drug front %.3g s after the injection began.",
                      time_s);
        album.add(player.frame(), "4_drug_" + std::to_string(percent), caption);
    }
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

Json injection_facts(const VesselTree& tree, Album& album, Job& job) {
    InjectionOptions options;
    options.mass_flow_g_s = mass_flow_g_s;
    options.void_fraction = 0.4;  // an emulsion: differs from blood, so that the splits change
    const InjectionResult injection = inject(tree, options, job);
    album.add(curve_over_time(injection, "Inlet pressure while lipiodol emulsion is injected",
                              "Pressure (Pa)",
                              [](const InjectionSample& s) { return s.inlet_pressure_pa; }),
              "5_inlet_pressure");
    album.add(
        curve_over_time(injection, "Share of the injected drug delivered through the ends", "Share",
                        [](const InjectionSample& s) {
                            return s.injected_g > 0.0 ? s.delivered_g / s.injected_g : 0.0;
                        }),
        "6_delivered");
    const InjectionSample& last = injection.series.back();
    return {{"mass_flow_g_s", mass_flow_g_s},
            {"duration_s", last.time_s},
            {"inlet_pressure_begin_pa", injection.series.front().inlet_pressure_pa},
            {"inlet_pressure_end_pa", last.inlet_pressure_pa},
            {"injected_g", last.injected_g},
            {"inside_g", last.inside_g},
            {"delivered_g", last.delivered_g},
            {"mass_error_relative",
             std::abs(last.injected_g - last.inside_g - last.delivered_g) / last.injected_g}};
}

}  // namespace

HeadlessPlay play_headless(std::shared_ptr<const PatientCase> patient,
                           const std::filesystem::path& folder, Job& job) {
    Session session(patient, default_scene(), job);
    Player player(session, job);
    Album album(folder);
    job.begin_stage("Playing");
    player.step(1);
    album.add(player.frame(), "1_patient", "The vessel tree from the front.");
    job.advance(0.1);

    HeadlessPlay played;
    played.simulation = pull(session, player, album);
    job.advance(0.5);
    watch_injection(session, player, album);
    const std::vector<double> step_ms = player.sorted_step_ms();
    played.simulation["steps"] = step_ms.size();
    played.simulation["step_ms_median"] = step_ms[step_ms.size() / 2];
    played.simulation["step_ms_max"] = step_ms.back();
    const FrameStatistics& statistics = player.frame().statistics;
    played.simulation["setting"] = statistics.setting;
    played.simulation["expected_error"] = statistics.expected_error;
    played.simulation["error_reference"] = statistics.error_reference;
    played.injection = injection_facts(patient->tree, album, job);
    played.pictures = album.pictures();
    return played;
}

}  // namespace hepatica
