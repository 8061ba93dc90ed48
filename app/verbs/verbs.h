// SPDX-License-Identifier: GPL-3.0-or-later
// The verbs of hepatica-cli: one function and one file (verb_NAME.cpp) each.
#pragma once

#include "app/command_line.h"

namespace hepatica {

void add_phantom(CommandLine& line);
void add_reconstruct(CommandLine& line);
void add_copy(CommandLine& line);
void add_export(CommandLine& line);
void add_edit(CommandLine& line);
void add_remake(CommandLine& line);
void add_feeders(CommandLine& line);
void add_compare(CommandLine& line);
void add_pressure_drop(CommandLine& line);
void add_inject(CommandLine& line);
void add_embolize(CommandLine& line);
void add_flow_curves(CommandLine& line);
void add_simulate(CommandLine& line);
void add_replay(CommandLine& line);
void add_review(CommandLine& line);
void add_lesson(CommandLine& line);
void add_play(CommandLine& line);    // only where the window is built
void add_render(CommandLine& line);  // only where the window is built
void add_paper(CommandLine& line);   // only where the window is built
void add_scene(CommandLine& line);
void add_skeleton(CommandLine& line);  // only where the window is built
void add_bench_gpu(CommandLine& line);
void add_bench_haptics(CommandLine& line);
void add_bench_drag(CommandLine& line);
void add_bench_iterations(CommandLine& line);
void add_bench_keyframe(CommandLine& line);
void add_bench_peers(CommandLine& line);
void add_bench_contacts(CommandLine& line);
void add_bench_region(CommandLine& line);
void add_bench_refinement(CommandLine& line);
void add_bench_reconstruct(CommandLine& line);
void add_bench_step(CommandLine& line);
void add_bench_tear(CommandLine& line);
void add_diagnose(CommandLine& line);
void add_extremes(CommandLine& line);
void add_tradeoff(CommandLine& line);
void add_dial(CommandLine& line);
void add_train(CommandLine& line);

// Adds all verbs, in the order in which --help lists them.
void add_all_verbs(CommandLine& line);

}  // namespace hepatica
