// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of scenes as they are today: a small patient who is pulled, held and let go in several
// scenes, his table of branches, and which vessel each vertex belongs to.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/scene/branch_table.h"
#include "core/scene/deform_part.h"
#include "core/scene/scene_spec.h"
#include "core/scene/surface_anatomy.h"
#include "core/scene/world.h"
#include "tests/session/small_patient.h"
#include "tests/support/recorded_figures.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;
using test::middle_of;
using test::small_patient;

std::span<const std::uint8_t> text_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(SceneFigures, OfBranchesAndVertices) {
    const auto patient = small_patient();
    Job job;
    Figures figures;
    std::vector<BranchLabel> labels;
    std::vector<double> shares;
    for (std::size_t s = 0; s < patient->tree.segments.size(); ++s) {
        labels.push_back({static_cast<int>(s % 9), 0.1 * static_cast<double>(s)});
        shares.push_back(1.0 / static_cast<double>(s + 1));
    }
    figures.add("csv", text_of(branch_table_csv(branch_rows(patient->tree, labels, shares))));
    figures.add("bare_csv", text_of(branch_table_csv(branch_rows(patient->tree, {}, {}))));
    const SurfaceAnatomy anatomy(patient->tree, patient->mesh.vertices_mm, job);
    std::vector<double> places;
    for (std::size_t v = 0; v < patient->mesh.vertices_mm.size(); v += 3) {
        const TreePoint point = anatomy.tree_point(static_cast<int>(v));
        places.push_back(point.segment);
        places.push_back(point.arclength_mm);
    }
    figures.add("places", places);
    expect_recorded("scene", "branches", figures);
}

// Pulled, held, let go and put back; what each frame shows.
Figures played(SceneSpec spec) {
    Job job;
    World world(small_patient(), spec, job);
    Figures figures;
    figures.add("spec", text_of(to_json(spec).dump()));
    const Vec3 held = middle_of(small_patient()->tree, 3);
    std::vector<double> shown, ledger;
    for (int k = 0; k < 24; ++k) {
        if (k == 2) world.deform()->grab(held);
        if (k > 2 && k < 14) world.deform()->move_grab(held + k * Vec3(0.5, -0.9, 0.4));
        if (k == 15) world.deform()->release();
        const StepReport report = world.step();
        for (const double value : {report.energy.kinetic, report.energy.elastic, report.energy.grab,
                                   report.energy.tether, double(report.asleep)})
            ledger.push_back(value);
        if (k % 6 != 5) continue;
        Frame frame;
        world.fill(frame);
        shown.insert(shown.end(), frame.positions_mm.begin(), frame.positions_mm.end());
        shown.push_back(static_cast<double>(frame.surface->size()));
        const TreePoint near = world.place_near(held + Vec3(1, 1, 1));
        shown.push_back(near.segment);
        shown.push_back(near.arclength_mm);
    }
    world.reset();
    Frame frame;
    world.fill(frame);
    shown.insert(shown.end(), frame.positions_mm.begin(), frame.positions_mm.end());
    return figures.add("shown", shown).add("ledger", ledger).add("time", world.time_s());
}

TEST(SceneFigures, OfPlays) {
    SceneSpec spec = default_scene();
    expect_recorded("scene", "default", played(spec));
    spec.deform->gravity_mm_per_s2 = Vec3(0, 4000, -2000);
    spec.deform->tether_pa_per_mm2 = 3.0;
    spec.deform->wall_mm = 0.5;
    spec.deform->fixed = FixedEnds::roots;
    expect_recorded("scene", "heavy", played(spec));
    spec = default_scene();
    spec.flow.reset();
    spec.dt_s = 0.008;
    expect_recorded("scene", "without_flow", played(spec));
}

}  // namespace
}  // namespace hepatica
