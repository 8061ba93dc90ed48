// SPDX-License-Identifier: GPL-3.0-or-later
// Doses of the drug in a play: injected, and delivered through the outlets of the vessels. What is
// lost out of torn vessels is not delivered. Delivered = target + elsewhere. Reflux is what left
// through outlets that do not lie downstream of the catheter's tip.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/base/job.h"
#include "core/flow/injection.h"
#include "core/lesson/target_region.h"
#include "core/scene/frame.h"
#include "core/tree/vessel_tree.h"

namespace hepatica {

// In g.
struct Dose {
    double injected_g = 0.0;
    double delivered_g = 0.0;
    double target_g = 0.0;
    double reflux_g = 0.0;
    double elsewhere_g() const { return delivered_g - target_g; }
};

// One injection over time, computed by core/flow on the tree at rest, as for the window's curves,
// and interpolated linearly. Computed on a thread of its own, ahead of the times that are asked
// for: 0.1 s of work for a drug with the viscosity of blood, seconds for others.
class DoseCurve {
  public:
    // Begins to compute and does not wait. `options.tip` is set; `end_s` >= 0: end of the run. The
    // tree must outlive the curve. `observer`: see Job::observe(). Throws std::system_error where
    // no thread can be created.
    DoseCurve(const VesselTree& tree, const InjectionOptions& options, double end_s,
              const std::optional<TargetRegion>& target,
              std::function<void(JobEvent)> observer = {});
    ~DoseCurve();  // cancels and joins, which waits for at most one step of the front
    DoseCurve(const DoseCurve&) = delete;
    DoseCurve& operator=(const DoseCurve&) = delete;

    // `time_s` is clamped to the run. Waits until the run has come to that time; the result does
    // not depend on how far it has come. Throws InputError where nothing can flow, and Cancelled
    // where it would have to wait and a stop is requested.
    Dose at(double time_s, const std::stop_token& stop = {}) const;

  private:
    void compute(const VesselTree& tree, const InjectionOptions& run,
                 const std::optional<TargetRegion>& target);

    Job job_;
    mutable std::mutex mutex_;  // for what follows
    mutable std::condition_variable_any more_;
    std::vector<double> time_s_;
    std::vector<Dose> dose_;
    bool ended_ = false;
    std::exception_ptr error_;  // where it ended by one
    std::jthread thread_;
};

// Sum over all injections of a play; one that is replaced or removed counts up to that moment.
// Where the play goes back to an earlier state, what was injected since does not count. Keeps a
// reference to the tree. Not thread-safe.
class DoseAccount {
  public:
    DoseAccount(const VesselTree& tree, const std::optional<TargetRegion>& target)
        : tree_(tree), target_(target) {}

    // Call with every frame. Takes no time, unless the drug's clock has leapt ahead or vessels have
    // torn since, when the curve is computed anew up to now: then it waits for it, or throws
    // Cancelled soon after a stop is requested. Throws InputError where an injection cannot flow.
    void see(const DrugView& drug, const std::stop_token& stop = {});
    Dose total() const;

  private:
    struct Part {        // one injection
        int number = 0;  // DrugView::injections
        std::shared_ptr<const InjectionOptions> injection;
        std::unique_ptr<const DoseCurve> curve;  // null while another is shown
        Dose dose;                               // up to the last frame that showed it
    };
    const VesselTree& tree_;
    std::optional<TargetRegion> target_;
    std::vector<Part> parts_;
};

}  // namespace hepatica
