// SPDX-License-Identifier: GPL-3.0-or-later
// Flow results in files for other programs: CSV for spreadsheets, and the network as a model of
// svZeroDSolver (SimVascular), in its units of centimetre, gram, second.
#pragma once

#include <filesystem>
#include <string>

#include "core/flow/embolization.h"
#include "core/flow/injection.h"

namespace hepatica {

// All writers replace the file as a whole or throw InputError. Numbers are written exactly
// (shortest round-trip form) with a decimal point whatever the locale.

// One row per sample: time, inlet pressure and flow, masses injected, inside and delivered,
// delivered and filled fraction, then one column per territory and per outlet.
void write_series_csv(const std::filesystem::path& file, const InjectionResult& injection);

// The paper's "partial length of each segment filled at each time step": one row per sample, one
// column per segment, in mm. Needs InjectionOptions::record_filled_lengths.
void write_filled_lengths_csv(const std::filesystem::path& file, const InjectionResult& injection);

// One row per batch of beads.
void write_series_csv(const std::filesystem::path& file, const Embolization& embolization);

// The network as svZeroDSolver reads it: BloodVessel with R_poiseuille (and stenosis_coefficient
// for the bifurcation loss), NORMAL_JUNCTION, FLOW, PRESSURE and RESISTANCE boundaries. That solver
// has laminar friction only: turbulent friction is left out, and the file's description says so.
// Segments without any driving boundary are left out.
std::string svzerod_json(const FlowNetwork& network, const FlowConditions& conditions);
void write_svzerod_json(const std::filesystem::path& file, const FlowNetwork& network,
                        const FlowConditions& conditions);

}  // namespace hepatica
