// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verbs/verbs.h"

namespace hepatica {

void add_all_verbs(CommandLine& line) {
    add_phantom(line);
    add_reconstruct(line);
    add_edit(line);
    add_remake(line);
    add_copy(line);
    add_export(line);
    add_feeders(line);
    add_compare(line);
    add_pressure_drop(line);
    add_inject(line);
    add_embolize(line);
    add_flow_curves(line);
    add_simulate(line);
    add_replay(line);
    add_review(line);
    add_lesson(line);
#ifdef HEPATICA_HAS_RENDER
    add_play(line);
    add_render(line);
    add_skeleton(line);
    add_paper(line);
#endif
    add_scene(line);
    add_bench_drag(line);
    add_bench_gpu(line);
    add_bench_haptics(line);
    add_bench_iterations(line);
    add_bench_keyframe(line);
    add_bench_peers(line);
    add_bench_contacts(line);
    add_bench_region(line);
    add_bench_refinement(line);
    add_bench_reconstruct(line);
    add_bench_step(line);
    add_bench_tear(line);
    add_diagnose(line);
    add_extremes(line);
    add_tradeoff(line);
    add_dial(line);
    add_train(line);
}

}  // namespace hepatica
