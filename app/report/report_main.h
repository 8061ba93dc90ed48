// SPDX-License-Identifier: GPL-3.0-or-later
// hepatica --report RECORDING --out DIR: the report of a play, without a window and a display.
#pragma once

#include <QCommandLineOption>
#include <QList>

namespace hepatica {

// --report, --out, and what belongs to them.
QList<QCommandLineOption> report_options();

// Before there is an application, because its platform depends on it.
bool asks_for_report(int argc, char** argv);

// Exit code: 0 written, 1 bad input, 2 bad usage. Prints the files, or one JSON object with --json.
int report_main(int argc, char** argv);

}  // namespace hepatica
