// SPDX-License-Identifier: GPL-3.0-or-later
// A patient in play: the parts that the scene names and nothing else. Changed only by its Session,
// at step boundaries; not thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/deform/stepper/stepper.h"
#include "core/flow/tube_law.h"
#include "core/mesh/body_topology.h"
#include "core/patient/patient_case.h"
#include "core/scene/deform_back_end.h"
#include "core/scene/drug_leak.h"
#include "core/scene/frame.h"
#include "core/scene/scene_spec.h"
#include "core/scene/side_tears.h"

namespace hepatica {

class Bleeding;
class DeformPart;
class FlowPart;
struct WorldCheckpoint;

// The cost of a part: its name, the heap memory that it holds, the time to build it.
struct PartCost {
    std::string name;
    std::size_t bytes = 0;
    double build_ms = 0.0;
    double frame_ms = 0.0;  // of the last step
};

class World {
  public:
    // Throws InputError where the case lacks what a part needs; Cancelled.
    World(std::shared_ptr<const PatientCase> patient, const SceneSpec& spec, Job& job,
          const DeformBackEnd& back_end = cpu_back_end());
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    const SceneSpec& spec() const { return spec_; }
    const PatientCase& patient() const { return *patient_; }
    std::span<const PartCost> parts() const { return parts_; }

    // Null where the scene has no such part.
    DeformPart* deform() { return deform_.get(); }
    FlowPart* flow() { return flow_.get(); }
    const DeformPart* deform() const { return deform_.get(); }
    const FlowPart* flow() const { return flow_.get(); }

    // The vertices shown: those of the mesh where it deforms, otherwise those of the surface.
    std::size_t vertex_count() const;
    Vec3 vertex_mm(int vertex) const;  // where it is now
    // The surface triangles over these vertices, and the parent of each vertex.
    const BodyTopology& topology() const { return *topology_; }
    // The place on the tree nearest to a point of the present, deformed shape.
    TreePoint place_near(const Vec3& point_mm) const;
    // Rest positions of the vertices.
    const std::vector<Vec3>& rest_positions_mm() const;

    // Advances all parts by the scene's time step; the report is that of the deforming body. Throws
    // Cancelled soon after a stop is requested; restore() must then be called before another step.
    // Between substeps of the body `part_done` may fill() a frame, see Stepper::step; nothing else
    // has moved on by then.
    StepReport step(const std::stop_token& stop = {}, const Stepper::PartDone& part_done = {});
    double time_s() const { return time_s_; }

    // Rest shape, no grab, no tool, no drug, no tear; time goes on.
    void reset();

    // What the vessels touch besides tools, see DeformPart::set_contact: each other, and the
    // obstacles of their case, which are made when first needed (seconds). False where obstacles
    // are wanted and the case has none. Requires a body that deforms.
    bool use_contact(bool self, bool obstacles, double friction);

    // Updates vertices and triangles after the body was torn or made whole; step() and restore() do
    // so themselves. Costs nothing where nothing has changed.
    void follow_tear();
    // Where vessels are torn through or open at their side now. O(tetrahedra) once something is
    // split.
    std::vector<ThroughTear> torn_now();
    // Null where nothing can tear.
    const Bleeding* bleeding() const { return bleeding_.get(); }

    // Fills in everything but the statistics and the step's number.
    void fill(Frame& frame) const;

    // Everything that determines the next steps, apart from case and spec: a world with the same
    // two continues from it with the same bits. Taking it costs a copy of a few arrays, restoring a
    // factorisation. restore() throws InputError where the checkpoint is of another case or scene;
    // the world must then be restored to another checkpoint or reset.
    WorldCheckpoint checkpoint() const;
    void restore(const WorldCheckpoint& checkpoint);
    // Hash of everything that determines the next steps and of nothing else; the time that has
    // passed is not included.
    std::uint64_t state_hash() const;

  private:
    PartCost* part(const std::string& name);
    void list_contact();
    std::shared_ptr<const Obstacles> known_obstacles();
    void part_out(const std::string& name, const PartCost& before, const SelfCost& cost);
    std::vector<ThroughTear> open_now(const TornPlaces& torn) const;
    TubeWall wall() const;
    bool bleed();  // whether other vessels are torn than before
    void press();
    void find_pools();
    DrugLeak drug_leak_now() const;
    void show_leaks(TearView& tear, const std::vector<float>& positions_mm) const;

    std::shared_ptr<const PatientCase> patient_;
    SceneSpec spec_;
    std::optional<BodyTopology> topology_;
    TearView tear_view_;              // origins as of torn_version_, rims as of the last step
    std::uint64_t torn_version_ = 1;  // of the body's topology, as topology_ has it
    std::unique_ptr<DeformPart> deform_;
    std::unique_ptr<FlowPart> flow_;
    std::unique_ptr<Bleeding> bleeding_;  // where the body can tear
    std::vector<int> leaking_;            // a vertex at each of its pools, or -1
    TornSoFar searched_;                  // when torn vessels were last searched for
    TornPlaces torn_;                     // what was found then
    std::vector<PartCost> parts_;
    std::shared_ptr<const Obstacles> obstacles_;  // once needed; null where none is known
    PartCost surfaces_of_obstacles_;              // without the cost of finding contacts
    double time_s_ = 0.0;
};

}  // namespace hepatica
