// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/fake_simulation.h"

#include <cmath>
#include <memory>
#include <utility>

#include "tests/render/fake_frame.h"

namespace hepatica::testing {

FakeSimulation::FakeSimulation(Frame rest) : rest_(std::move(rest)), frame_(rest_) {
    frame_.statistics.step_ms = 1.5;
}

void FakeSimulation::post(Command command) {
    commands_.push_back(command);
    waiting_.push_back(std::move(command));
}

void FakeSimulation::on_frame(std::function<void()> tell) {
    timer_ = std::make_unique<QTimer>();
    QObject::connect(timer_.get(), &QTimer::timeout, timer_.get(), std::move(tell));
    timer_->start(16);
}

bool FakeSimulation::update_frame() {
    for (const Command& command : std::exchange(waiting_, {})) apply(command);
    frame_.drug.speed = drug_speed_;
    if (std::exchange(diverges_, false)) stop();
    if (frame_.drug.playing && !frame_.statistics.paused) frame_.drug.time_s += 1.0 / 60.0;
    frame_.tear = tear_;
    if (tear_) frame_.time_s += 1.0 / 60.0;
    ++frame_.step;
    return true;
}

void FakeSimulation::say_of_step(const std::string& words) {
    frame_.statistics.degraded = frame_.statistics.message_of_solver = !words.empty();
    frame_.statistics.message = words;
}

void FakeSimulation::stop() {
    frame_.grab.reset();
    frame_.statistics.paused = true;
    frame_.statistics.diverged = true;
    frame_.statistics.message = "The simulation diverged";
}

void FakeSimulation::go_on() {
    frame_.statistics.paused = false;
    frame_.statistics.diverged = false;
    frame_.statistics.message.clear();
}

void FakeSimulation::apply(const Command& command) {
    if (const auto* grab = std::get_if<GrabPoint>(&command)) {
        frame_.grab = GrabView{grab->point_mm, grab->point_mm, 0.0};
        rest_ = frame_;
    } else if (const auto* move = std::get_if<MoveGrab>(&command)) {
        if (frame_.grab) pull_to(move->target_mm);
    } else if (std::holds_alternative<ReleaseGrab>(command)) {
        frame_.grab.reset();
    } else if (std::holds_alternative<InjectDrug>(command)) {
        frame_.drug = fake_frame(0.0, 0.0).drug;
        frame_.drug.playing = true;
    } else if (const auto* play = std::get_if<PlayDrug>(&command)) {
        frame_.drug.playing = play->playing;
    } else if (const auto* time = std::get_if<SetDrugTime>(&command)) {
        frame_.drug.time_s = time->time_s;
    } else if (const auto* speed = std::get_if<SetDrugSpeed>(&command)) {
        drug_speed_ = speed->factor;
    } else if (std::holds_alternative<RemoveDrug>(command)) {
        frame_.drug = {};
    } else if (const auto* hold = std::get_if<SetPaused>(&command)) {
        frame_.statistics.paused = hold->paused;
        if (!hold->paused) go_on();
    } else if (std::holds_alternative<RestoreSnapshot>(command)) {
        go_on();
    } else if (const auto* tool = std::get_if<AddTool>(&command)) {
        add_tool(*tool);
    } else if (const auto* led = std::get_if<MoveTool>(&command)) {
        if (frame_.tool) lead_tool(led->target_mm - frame_.tool->centre_mm);
    } else if (std::holds_alternative<RemoveTool>(command)) {
        frame_.tool.reset();
    } else if (std::holds_alternative<ResetWorld>(command)) {
        frame_.grab.reset();
        frame_.tool.reset();
        frame_.drug = {};
        frame_.positions_mm = at_rest_;
        go_on();
    }
}

void FakeSimulation::pull_to(const Vec3& target_mm) {
    const Vec3 start = rest_.grab->point_mm;
    frame_.grab = GrabView{target_mm, target_mm, 0.0};
    for (std::size_t v = 0; v < rest_.positions_mm.size(); v += 3) {
        const Vec3 rest(rest_.positions_mm[v], rest_.positions_mm[v + 1],
                        rest_.positions_mm[v + 2]);
        const double share = std::exp(-(rest - start).squaredNorm() / (2.0 * 15.0 * 15.0));
        const Vec3 moved = rest + share * (target_mm - start);
        for (int axis = 0; axis < 3; ++axis) {
            frame_.positions_mm[v + static_cast<std::size_t>(axis)] =
                static_cast<float>(moved[axis]);
        }
    }
}

// It is where it is wanted, and feels as many millinewtons as it was led by millimetres.
void FakeSimulation::add_tool(const AddTool& tool) {
    const Vec3 along = tool.length_mm * tool.direction.normalized();
    const Vec3 tip = tool.point_mm - tool.radius_mm * tool.direction.normalized();
    ToolView view;
    view.parts = {{tip - along, tip, tool.radius_mm}};
    view.centre_mm = tip - 0.5 * along;
    view.tip_mm = tip;
    const Vec3 side = tool.side.value_or(tool.direction.unitOrthogonal()).normalized();
    if (tool.kind == "forceps") {
        view.tip_mm = tool.point_mm + 0.25 * along;
        view.centre_mm = view.tip_mm - 0.5 * along;
        view.parts.clear();
        for (const double radii : {-4.0, 4.0}) {
            const Vec3 end = view.tip_mm + radii * tool.radius_mm * side;
            view.parts.push_back({end - along, end, tool.radius_mm});
        }
    } else if (tool.kind == "hook") {
        const Vec3 foot = 0.4 * tool.length_mm * side;
        view.parts.push_back({tip, tip + foot, tool.radius_mm});
        view.tip_mm = tip + 0.5 * foot;
    }
    frame_.tool = view;
}

void FakeSimulation::lead_tool(const Vec3& by_mm) {
    for (ToolView::Part& part : frame_.tool->parts) {
        part.from_mm += by_mm;
        part.to_mm += by_mm;
    }
    frame_.tool->centre_mm += by_mm;
    frame_.tool->tip_mm += by_mm;
    frame_.tool->force_un = 1e3 * by_mm;
}

LoadedPatient fake_patient(FakeSimulation** simulation) {
    const Frame frame = fake_frame();
    VesselSegment trunk;
    trunk.proximal_node = 0;
    trunk.distal_node = 1;
    trunk.points_mm = {Vec3(0, 0, -60), Vec3(0, 0, -15)};
    trunk.radii_mm = {6.0, 5.0};
    VesselSegment left = trunk;
    left.parent = 0;
    left.proximal_node = 1;
    left.distal_node = 2;
    left.points_mm = {Vec3(0, 0, -15), Vec3(-40, 0, 40)};
    VesselSegment right = left;
    right.distal_node = 3;
    right.points_mm = {Vec3(0, 0, -15), Vec3(40, 0, 40)};
    PatientCase patient;
    patient.tree.nodes = {{Vec3(0, 0, -60), 6.0},
                          {Vec3(0, 0, -15), 5.0},
                          {Vec3(-40, 0, 40), 5.0},
                          {Vec3(40, 0, 40), 5.0}};
    patient.tree.segments = {trunk, left, right};
    for (std::size_t v = 0; v < frame.positions_mm.size(); v += 3) {
        patient.mesh.vertices_mm.emplace_back(frame.positions_mm[v], frame.positions_mm[v + 1],
                                              frame.positions_mm[v + 2]);
    }
    LoadedPatient loaded;
    Job job;
    loaded.title = "Fake patient";
    loaded.anatomy = SurfaceAnatomy(patient.tree, patient.mesh.vertices_mm, job);
    loaded.patient = std::make_shared<const PatientCase>(std::move(patient));
    auto fake = std::make_unique<FakeSimulation>(frame);
    if (simulation) *simulation = fake.get();
    loaded.simulation = std::move(fake);
    return loaded;
}

}  // namespace hepatica::testing
