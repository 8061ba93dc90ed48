// SPDX-License-Identifier: GPL-3.0-or-later
// Entry point of hepatica-cli.
#include "app/command_line.h"
#include "app/verbs/verbs.h"

int main(int argc, char** argv) {
    hepatica::CommandLine line;
    hepatica::add_all_verbs(line);
    return line.run(argc, argv);
}
