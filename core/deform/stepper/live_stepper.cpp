// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/stepper/live_stepper.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/deform/stepper/stepper_checkpoint.h"
#include "core/deform/stepper/stepper_input.h"
#include "core/mesh/hex_mesh.h"

namespace hepatica {

namespace {

BodyDescription with_skeleton(BodyDescription body) {
    if (body.skeleton.size() > 0) return body;
    TetMesh mesh = body.mesh;
    for (const auto& tetrahedron : cut_into_tetrahedra(body.hexahedra)) {
        mesh.tetrahedra.push_back(tetrahedron);
    }
    body.skeleton = skeleton_of_mesh(mesh);
    return body;
}

// Part of a body, and where its vertices are in the whole.
struct Part {
    BodyDescription body;
    std::vector<int> vertex;  // in the whole, of each vertex of the part
    std::vector<int> index;   // in the part, of each vertex of the whole; -1: not in it
};

// The skeleton nodes that are live, hung on their nearest live ancestor.
FrameSkeleton live_skeleton(const FrameSkeleton& whole, const std::vector<char>& live) {
    FrameSkeleton part;
    std::vector<int> stands_for(whole.parent.size(), -1);
    for (int n = 0; n < whole.size(); ++n) {
        const int parent = whole.parent[n];
        stands_for[n] = parent < 0 ? -1 : stands_for[parent];
        if (!live[n]) continue;
        part.parent.push_back(stands_for[n]);
        part.positions_mm.push_back(whole.positions_mm[n]);
        part.radii_mm.push_back(whole.radii_mm[n]);
        stands_for[n] = part.size() - 1;
    }
    return part;
}

// The elements with a live vertex; their other vertices are fixed. All of a body in its own
// numbering where that is asked for.
Part live_part(const BodyDescription& whole, const LiveRegion& region, bool own_numbering) {
    Part part;
    part.index.assign(whole.mesh.vertices_mm.size(), -1);
    const auto take = [&](int v) {
        if (part.index[v] < 0) {
            part.index[v] = static_cast<int>(part.vertex.size());
            part.vertex.push_back(v);
            part.body.mesh.vertices_mm.push_back(whole.mesh.vertices_mm[v]);
            const bool fixed = !whole.fixed.empty() && whole.fixed[v] != 0;
            part.body.fixed.push_back(fixed || !region.live(v) ? 1 : 0);
        }
        return part.index[v];
    };
    for (int v = 0; own_numbering && v < static_cast<int>(part.index.size()); ++v) take(v);
    std::size_t element = 0;
    const auto take_elements = [&](const auto& elements, auto& target) {
        for (const auto& nodes : elements) {
            const std::size_t e = element++;
            if (std::none_of(nodes.begin(), nodes.end(), [&](int v) { return region.live(v); })) {
                continue;
            }
            auto taken = nodes;
            for (int& v : taken) v = take(v);
            target.push_back(taken);
            if (!whole.stiffness_factor.empty()) {
                part.body.stiffness_factor.push_back(whole.stiffness_factor[e]);
            }
            if (!whole.density_factor.empty()) {
                part.body.density_factor.push_back(whole.density_factor[e]);
            }
        }
    };
    take_elements(whole.mesh.tetrahedra, part.body.mesh.tetrahedra);
    take_elements(whole.hexahedra, part.body.hexahedra);
    part.body.material = whole.material;
    part.body.tether_pa_per_mm2 = whole.tether_pa_per_mm2;
    part.body.skeleton = live_skeleton(whole.skeleton, region.live_nodes());
    return part;
}

const BodyDescription& validated(const BodyDescription& body, const StepperOptions& options) {
    validate(options);
    validate(body, options.model, options.order);
    return body;
}

StepperOptions without_sleep(StepperOptions options) {
    options.sleeping = false;  // the region sleeps
    return options;
}

class PartStepper final : public LiveStepper {
  public:
    PartStepper(const BodyDescription& body, const StepperOptions& options,
                const LiveRegionOptions& region)
        : body_(with_skeleton(validated(body, options))),
          whole_(options.order == ElementOrder::quadratic),
          options_(whole_ ? options : without_sleep(options)),
          region_(body_.skeleton, body_.mesh.vertices_mm, region),
          positions_mm_(body_.mesh.vertices_mm),
          velocities_mm_per_s_(positions_mm_.size(), Vec3::Zero()) {
        for (const auto& nodes : body_.mesh.tetrahedra) region_.connect(nodes);
        for (const auto& nodes : body_.hexahedra) region_.connect(nodes);
        rebuild();
    }

    void set_grabs(std::span<const Grab> grabs) override {
        validate_grabs(grabs, positions_mm_.size());
        std::vector<int> held;
        for (const Grab& grab : grabs)
            for (const int v : grab.vertices)
                if (v >= 0) held.push_back(v);
        // Under the old grabs, which still hold what is live: the new ones' work is booked after.
        if (!whole_ && region_.hold(held)) change_region();
        grabs_.assign(grabs.begin(), grabs.end());
        hand_over_grabs();
    }

    void set_gravity(const Vec3& gravity_mm_per_s2) override {
        validate_gravity(gravity_mm_per_s2);
        if (gravity_mm_per_s2 == gravity_mm_per_s2_) return;
        gravity_mm_per_s2_ = gravity_mm_per_s2;
        if (whole_) {
            stepper_->set_gravity(gravity_mm_per_s2);
            return;
        }
        region_.wake_all();
        change_region();
    }

    bool set_options(const StepperOptions& options) override {
        validated(body_, options);
        if (options.order != options_.order) return false;
        const StepperOptions now = whole_ ? options : without_sleep(options);
        if (whole_ && !stepper_->set_options(now)) return false;
        options_ = now;
        if (!whole_ && stepper_ && !stepper_->set_options(now)) rebuild();
        return true;
    }

    StepReport step(double dt_s) override;

    std::span<const Vec3> positions_mm() const override { return positions_mm_; }
    std::span<const Vec3> velocities_mm_per_s() const override { return velocities_mm_per_s_; }

    BodyState state() const override {
        return whole_ ? stepper_->state() : BodyState{positions_mm_, velocities_mm_per_s_};
    }

    void set_state(std::span<const Vec3> positions_mm,
                   std::span<const Vec3> velocities_mm_per_s) override {
        if (whole_) {
            stepper_->set_state(positions_mm, velocities_mm_per_s);
            copy_from_part();
            return;
        }
        validate_state(positions_mm, velocities_mm_per_s, positions_mm_.size());
        positions_mm_.assign(positions_mm.begin(), positions_mm.end());
        velocities_mm_per_s_.assign(velocities_mm_per_s.begin(), velocities_mm_per_s.end());
        region_.wake_all();
        rebuild();
        frozen_ = {};
        booked_ = {};
    }

    StepperCheckpoint checkpoint() const override;
    void restore(const StepperCheckpoint& checkpoint) override;

    Extent extent() const override {
        Extent extent;
        extent.elements = static_cast<int>(body_.mesh.tetrahedra.size() + body_.hexahedra.size());
        extent.vertices = static_cast<int>(positions_mm_.size());
        extent.live_elements =
            static_cast<int>(part_.body.mesh.tetrahedra.size() + part_.body.hexahedra.size());
        extent.live_vertices = static_cast<int>(part_.vertex.size());
        return extent;
    }

    EnergyLedger energies() const override {
        EnergyLedger now = stepper_ ? stepper_->energies() : EnergyLedger{};
        now.elastic += frozen_.elastic;
        now.tether += frozen_.tether;
        now.tool_work += booked_.tool_work;
        return now;
    }

  private:
    void rebuild();
    void change_region();
    void hand_over_grabs();
    void copy_from_part();

    BodyDescription body_;
    bool whole_;  // nothing ever freezes
    StepperOptions options_;
    LiveRegion region_;
    Part part_;
    std::unique_ptr<Stepper> stepper_;  // of the part; none where nothing is live
    std::vector<Vec3> positions_mm_, velocities_mm_per_s_;
    std::vector<Grab> grabs_;
    EnergyLedger frozen_;  // elastic and tether of what is frozen
    EnergyLedger booked_;  // tool_work and integrator_loss that no report has named yet
    Vec3 gravity_mm_per_s2_ = Vec3::Zero();
};

void PartStepper::hand_over_grabs() {
    if (!stepper_) return;
    std::vector<Grab> grabs = grabs_;
    for (Grab& grab : grabs) {
        for (int& v : grab.vertices) v = v < 0 ? v : part_.index[v];
    }
    stepper_->set_grabs(grabs);
}

// The energies of the whole body go on; what moved and froze has lost its motion.
void PartStepper::change_region() {
    const EnergyLedger before = energies();
    rebuild();
    const EnergyLedger part = stepper_ ? stepper_->energies() : EnergyLedger{};
    frozen_ = {};
    if (region_.live_count() < body_.skeleton.size()) {
        frozen_.elastic = before.elastic - part.elastic;
        frozen_.tether = before.tether - part.tether;
    }
    booked_.integrator_loss += before.kinetic - part.kinetic;
}

void PartStepper::rebuild() {
    if (stepper_) booked_.tool_work += stepper_->energies().tool_work;
    part_ = live_part(body_, region_, whole_);
    stepper_.reset();
    // What froze has stopped.
    for (std::size_t v = 0; v < positions_mm_.size(); ++v) {
        if (!region_.live(static_cast<int>(v))) velocities_mm_per_s_[v].setZero();
    }
    if (part_.vertex.empty()) return;
    stepper_ = make_cpu_stepper(part_.body, options_);
    stepper_->set_gravity(gravity_mm_per_s2_);
    hand_over_grabs();
    std::vector<Vec3> positions, velocities;
    for (const int v : part_.vertex) {
        positions.push_back(positions_mm_[v]);
        velocities.push_back(velocities_mm_per_s_[v]);
    }
    stepper_->set_state(positions, velocities);  // forgets the grabs' work: it was booked before
}

StepperCheckpoint PartStepper::checkpoint() const {
    StepperCheckpoint kept;
    kept.nodes = {positions_mm_, velocities_mm_per_s_};
    kept.grabs = grabs_;
    kept.gravity_mm_per_s2 = gravity_mm_per_s2_;
    kept.region = region_.checkpoint();
    kept.region->frozen_elastic = frozen_.elastic;
    kept.region->frozen_tether = frozen_.tether;
    kept.region->unreported_tool_work = booked_.tool_work;
    kept.region->unreported_loss = booked_.integrator_loss;
    if (stepper_) kept.part.push_back(stepper_->checkpoint());
    return kept;
}

void PartStepper::restore(const StepperCheckpoint& checkpoint) {
    validate_checkpoint(checkpoint, positions_mm_.size());
    const auto fits = [](bool condition, const std::string& problem) {
        if (!condition)
            throw InputError(problem, "the checkpoint of a body",
                             "Make a stepper of the kind that it was taken of");
    };
    fits(checkpoint.region.has_value(), "is of a stepper that computes the whole body");
    LiveRegion region = region_;
    region.restore(*checkpoint.region);
    Part part = live_part(body_, region, whole_);
    fits(checkpoint.part.size() == (part.vertex.empty() ? 0 : 1),
         "lacks the part that is computed");
    std::unique_ptr<Stepper> stepper;
    if (!part.vertex.empty()) {
        stepper = make_cpu_stepper(part.body, options_);
        stepper->restore(checkpoint.part.front());
    }
    region_ = std::move(region);
    part_ = std::move(part);
    stepper_ = std::move(stepper);
    positions_mm_ = checkpoint.nodes.positions_mm;
    velocities_mm_per_s_ = checkpoint.nodes.velocities_mm_per_s;
    grabs_ = checkpoint.grabs;
    gravity_mm_per_s2_ = checkpoint.gravity_mm_per_s2;
    frozen_ = {};
    frozen_.elastic = checkpoint.region->frozen_elastic;
    frozen_.tether = checkpoint.region->frozen_tether;
    booked_ = {};
    booked_.tool_work = checkpoint.region->unreported_tool_work;
    booked_.integrator_loss = checkpoint.region->unreported_loss;
}

void PartStepper::copy_from_part() {
    const auto positions = stepper_->positions_mm();
    const auto velocities = stepper_->velocities_mm_per_s();
    for (std::size_t i = 0; i < part_.vertex.size(); ++i) {
        positions_mm_[part_.vertex[i]] = positions[i];
        velocities_mm_per_s_[part_.vertex[i]] = velocities[i];
    }
}

StepReport PartStepper::step(double dt_s) {
    validate_time_step(dt_s);
    StepReport report;
    report.dt_s = dt_s;
    report.asleep = true;
    if (stepper_) {
        report = stepper_->step(dt_s);
        copy_from_part();
    }
    report.energy.elastic += frozen_.elastic;
    report.energy.tether += frozen_.tether;
    report.energy.tool_work += std::exchange(booked_.tool_work, 0.0);
    const bool moved = stepper_ && !whole_;
    if (moved && region_.watch(positions_mm_, velocities_mm_per_s_, dt_s)) {
        change_region();
        report.energy.kinetic -= booked_.integrator_loss;
    }
    report.energy.integrator_loss += std::exchange(booked_.integrator_loss, 0.0);
    return report;
}

}  // namespace

std::unique_ptr<LiveStepper> make_live_stepper(const BodyDescription& body,
                                               const StepperOptions& options,
                                               const LiveRegionOptions& region) {
    return std::make_unique<PartStepper>(body, options, region);
}

}  // namespace hepatica
