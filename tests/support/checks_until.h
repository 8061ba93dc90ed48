// SPDX-License-Identifier: GPL-3.0-or-later
// How often a piece of work looks whether its job was cancelled.
#pragma once

#include "core/base/error.h"
#include "core/base/job.h"

namespace hepatica::test {

// Runs work(job) and cancels it at its look number `last`. Returns the number of looks, negative
// where the work ended with Cancelled.
template <class Work>
int checks_until(int last, const Work& work) {
    Job job;
    int checks = 0;
    job.observe([&](JobEvent) {
        if (++checks == last) job.cancel();
    });
    try {
        work(job);
    } catch (const Cancelled&) {
        return -checks;
    }
    return checks;
}

}  // namespace hepatica::test
