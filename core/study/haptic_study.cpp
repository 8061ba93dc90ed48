// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/haptic_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/haptics/haptic_play.h"
#include "core/haptics/simulated_device.h"
#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/scene/deform_part.h"
#include "core/scene/world.h"
#include "core/session/session.h"
#include "core/study/job_within.h"
#include "core/study/timing.h"
#include "core/study/vessel_body.h"

namespace hepatica {
namespace {

using Clock = std::chrono::steady_clock;

double processor_us() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

// Records every tick on the loop's thread; read it after the loop has ended.
class TickMeter {
  public:
    explicit TickMeter(double seconds) {
        cost_us_.reserve(static_cast<std::size_t>(2e3 * seconds) + 1000);
        contacts_.reserve(cost_us_.capacity());
    }
    void see(const Tick& tick) {
        const double now_us = processor_us();
        const Clock::time_point now = Clock::now();
        if (begun_ && cost_us_.size() < cost_us_.capacity()) {
            cost_us_.push_back(now_us - last_us_);
            contacts_.push_back(tick.contacts);
            if (now - last_ > std::chrono::milliseconds(2)) ++late_;
        }
        begun_ = true;
        last_us_ = now_us;
        last_ = now;
    }
    void report(HapticStudy& study) const;

  private:
    std::vector<double> cost_us_, contacts_;
    double last_us_ = 0.0;
    Clock::time_point last_;
    bool begun_ = false;
    int late_ = 0;
};

void TickMeter::report(HapticStudy& study) const {
    if (cost_us_.empty()) return;
    const auto share = [](const std::vector<double>& values, const auto& good) {
        return static_cast<double>(std::ranges::count_if(values, good)) /
               static_cast<double>(values.size());
    };
    study.periods = static_cast<int>(cost_us_.size());
    study.in_time = share(cost_us_, [](double us) { return us < 1e3; });
    study.median_us = quantile(cost_us_, 0.5);
    study.p999_us = quantile(cost_us_, 0.999);
    study.longest_us = quantile(cost_us_, 1.0);
    study.late = late_;
    study.contacts = quantile(contacts_, 0.5);
    study.contacts_most = static_cast<int>(quantile(contacts_, 1.0));
    study.full = share(contacts_, [](double n) { return n >= most_local_contacts; });
}

std::shared_ptr<const PatientCase> own_patient(Job& job) {
    auto made = std::make_shared<PatientCase>();
    made->tree = study_tree(4, 4.0);
    made->mesh = tetrahedralize(made->tree, {}, job);
    made->surface = surface_of(made->mesh).mesh;
    return made;
}

// The middle of the longest branch, and the direction there.
std::pair<Vec3, Vec3> place_and_way(const VesselTree& tree) {
    const auto& longest = *std::ranges::max_element(
        tree.segments, {}, [](const auto& segment) { return segment.points_mm.size(); });
    const std::size_t middle = longest.points_mm.size() / 2;
    const Vec3 along = longest.points_mm[middle] - longest.points_mm[middle - 1];
    return {longest.points_mm[middle], along.normalized()};
}

// Closes forceps around the vessel, across it.
void hold(Session& session, const VesselTree& tree, const Job& job) {
    const auto [place, along] = place_and_way(tree);
    const Vec3 down = along.unitOrthogonal();
    session.post(AddTool{.kind = "forceps",
                         .radius_mm = 2.0,
                         .length_mm = 16.0,
                         .direction = down,
                         .point_mm = place,
                         .side = Vec3(along.cross(down))});
    session.step(job);
    session.update_frame();  // its message says why there is no tool
    if (!session.world().deform()->tool())
        throw InputError(session.frame().statistics.message, "the forceps of the benchmark",
                         "Name another case");
    session.post(ShiftTool{6.0 * down});
    for (int i = 0; i < 30; ++i) session.step(job);
    session.post(CloseForceps{});
    for (int i = 0; i < 60; ++i) session.step(job);
}

// A hand that leads what it holds around a path, and turns it.
SimulatedHand leading() {
    SimulatedHand hand{.encoder_mm = 0.02};
    hand.path = [](double t) {
        const double phase = 2.0 * M_PI * t;
        return HapticPose{
            .at_mm =
                1.5 * Vec3(1.0 - std::cos(phase), std::sin(phase), 0.5 * std::sin(0.7 * phase)),
            .turned = Eigen::Quaterniond(Eigen::AngleAxisd(0.1 * std::sin(phase), Vec3::UnitY()))};
    };
    return hand;
}

}  // namespace

HapticStudy study_haptics(std::shared_ptr<const PatientCase> patient,
                          const HapticStudyOptions& options, Job& job) {
    const ThreadLimit limit(options.threads);
    job.begin_stage("Taking hold");
    if (patient == nullptr) patient = own_patient(job);
    SceneSpec spec = default_scene();
    spec.flow.reset();
    spec.contact = ContactSpec{.self = false};
    JobWithin building(job);
    Session session(patient, spec, building.job());
    hold(session, patient->tree, job);
    job.begin_stage("Feeling");
    const auto device = std::make_shared<SimulatedDevice>(
        leading(), HapticTraits{.name = "simulated device", .damping_un_s_per_mm = 5e3});
    TickMeter meter(options.seconds);
    std::vector<double> step_ms;
    HapticPlay haptics(session);
    haptics.on_tick([&](const Tick& tick) { meter.see(tick); });
    session.on_frame([&] {
        haptics.after_step();
        if (session.update_frame() && !session.within_step())
            step_ms.push_back(session.frame().statistics.step_ms);
    });
    haptics.attach(device);
    {
        const std::jthread play([&](const std::stop_token& stop) { session.run(stop); });
        const Clock::time_point begin = Clock::now();
        for (double passed_s = 0.0; passed_s < options.seconds;) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            job.throw_if_cancelled();
            passed_s = std::chrono::duration<double>(Clock::now() - begin).count();
            job.advance(std::min(1.0, passed_s / options.seconds));
        }
    }
    haptics.detach();
    session.on_frame({});
    HapticStudy study;
    meter.report(study);
    study.work_nj = device->work_nj();
    study.steps = static_cast<int>(step_ms.size());
    study.step_ms = step_ms.empty() ? 0.0 : quantile(step_ms, 0.5);
    study.tetrahedra = static_cast<int>(patient->mesh.tetrahedra.size());
    return study;
}

}  // namespace hepatica
