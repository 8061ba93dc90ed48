// SPDX-License-Identifier: GPL-3.0-or-later
// Directional sub-iterations over the border voxels.
#include "core/skeleton/queue_thinning.h"

#include <algorithm>

#include "core/skeleton/simple_point.h"

namespace hepatica {

namespace {

struct Candidate {
    std::size_t voxel;
    int degree;  // at the time the voxel was chosen
};

class Queue {
  public:
    explicit Queue(PaddedObject& object, Job& job)
        : object_(object), job_(job), faces_(object.face_steps()), border_(object.border_voxels()) {
        for (const std::size_t p : border_) object_.mark(p);
    }

    // One sub-iteration per direction; returns how many voxels were deleted.
    std::size_t iterate() {
        std::size_t deleted = 0;
        // Opposite directions alternate, so that the skeleton stays in the middle.
        for (const std::ptrdiff_t direction : faces_) {
            choose_candidates(direction);
            deleted += delete_candidates();
        }
        std::erase_if(border_, [&](std::size_t p) { return !object_.contains(p); });
        return deleted;
    }

    std::size_t border_size() const { return border_.size(); }

  private:
    void choose_candidates(std::ptrdiff_t direction) {
        job_.throw_if_cancelled();
        candidates_.clear();
        for (const std::size_t p : border_) {
            if (!object_.contains(p) || object_.contains(p + direction)) continue;
            const std::uint32_t neighbourhood = object_.neighbourhood(p);
            if (is_deletable(neighbourhood)) candidates_.push_back({p, degree(neighbourhood)});
        }
    }

    std::size_t delete_candidates() {
        std::size_t deleted = 0;
        for (const Candidate& candidate : candidates_) {
            const std::size_t p = candidate.voxel;
            const std::uint32_t neighbourhood = object_.neighbourhood(p);
            if (!is_deletable(neighbourhood)) continue;
            // A voxel that has just lost neighbours and is almost a line end waits for the next
            // sub-iteration; otherwise a line two voxels wide would be removed from its end.
            if (degree(neighbourhood) <= 2 && degree(neighbourhood) < candidate.degree) continue;
            object_.remove(p);
            ++deleted;
            for (const std::ptrdiff_t step : faces_) {
                const std::size_t q = p + step;
                if (!object_.contains(q) || object_.marked(q)) continue;
                object_.mark(q);
                border_.push_back(q);
            }
        }
        return deleted;
    }

    PaddedObject& object_;
    Job& job_;
    std::array<std::ptrdiff_t, 6> faces_;
    std::vector<std::size_t> border_;
    std::vector<Candidate> candidates_;
};

}  // namespace

void thin_by_queue(PaddedObject& object, Job& job) {
    if (object.empty()) return;
    Queue queue(object, job);
    const std::size_t before = queue.border_size();
    while (queue.iterate() > 0) {
        // An estimate: the border shrinks towards the skeleton, whose size is known only at the
        // end.
        job.advance(1.0 - static_cast<double>(queue.border_size()) /
                              static_cast<double>(std::max(before, queue.border_size()) + 1));
    }
    job.advance(1.0);
}

}  // namespace hepatica
