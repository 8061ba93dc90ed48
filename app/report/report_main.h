// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica --report RECORDING --out DIR: writes the report of a play without a window or a display.
#pragma once

#include <QCommandLineOption>
#include <QList>

namespace hepatica {

QList<QCommandLineOption> report_options();

// To be called before the application is created, because its platform depends on it.
bool asks_for_report(int argc, char** argv);

// Returns the exit code: 0 written, 1 bad input, 2 bad usage, 3 internal error, 130 interrupted.
// Prints the files, or one JSON object with --json.
int report_main(int argc, char** argv);

}  // namespace hepatica
