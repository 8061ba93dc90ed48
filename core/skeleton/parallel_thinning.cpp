// SPDX-License-Identifier: GPL-3.0-or-later
// Repeats parallel passes over the border voxels until no template matches.
#include "core/skeleton/parallel_thinning.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/skeleton/thinning_templates.h"

namespace hepatica {

namespace {

constexpr std::size_t block = 1 << 13;

bool matches(const PaddedObject& object, std::size_t p, std::uint32_t neighbourhood,
             const ThinningTemplate& t) {
    if ((neighbourhood & t.object) != t.object || (neighbourhood & t.background) != 0) return false;
    const auto is_object = [&](std::ptrdiff_t step) { return object.contains(p + step); };
    return std::ranges::all_of(t.followed, is_object) &&
           (t.any_of.empty() || std::ranges::any_of(t.any_of, is_object));
}

bool is_deleted(const PaddedObject& object, std::size_t p,
                const std::vector<ThinningTemplate>& templates) {
    const std::uint32_t neighbourhood = object.neighbourhood(p);
    return !is_protected_end(neighbourhood) &&
           std::ranges::any_of(templates, [&](const ThinningTemplate& t) {
               return matches(object, p, neighbourhood, t);
           });
}

// For each border voxel, whether a template matches; all are tested on the same object.
std::vector<std::uint8_t> matching(const PaddedObject& object,
                                   const std::vector<std::size_t>& border,
                                   const std::vector<ThinningTemplate>& templates) {
    std::vector<std::uint8_t> match(border.size());
    parallel_blocks(border.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            match[i] = is_deleted(object, border[i], templates) ? 1 : 0;
    });
    return match;
}

// Deletes the matching voxels of the border, all at once, until none matches; returns their number.
// Voxels that become border in between are not considered.
std::size_t peel(PaddedObject& object, std::vector<std::size_t>& border,
                 const std::vector<ThinningTemplate>& templates, Job& job) {
    std::size_t deleted = 0;
    while (true) {
        job.throw_if_cancelled();
        const std::vector<std::uint8_t> match = matching(object, border, templates);
        std::vector<std::size_t> left;
        for (std::size_t i = 0; i < border.size(); ++i) {
            if (match[i] != 0)
                object.remove(border[i]);
            else
                left.push_back(border[i]);
        }
        const std::size_t went = border.size() - left.size();
        if (went == 0) return deleted;
        deleted += went;
        border = std::move(left);
    }
}

}  // namespace

void thin_by_templates(PaddedObject& object, Job& job) {
    if (object.empty()) return;
    const std::vector<ThinningTemplate> templates = thinning_templates(object);
    std::vector<std::size_t> voxels = object.object_voxels();
    const auto before = static_cast<double>(voxels.size());
    const auto faces = object.face_steps();
    while (true) {
        std::vector<std::size_t> border;
        for (const std::size_t p : voxels)
            if (std::ranges::any_of(faces, [&](auto step) { return !object.contains(p + step); }))
                border.push_back(p);
        if (peel(object, border, templates, job) == 0) return;
        std::erase_if(voxels, [&](std::size_t p) { return !object.contains(p); });
        job.advance(1.0 - static_cast<double>(voxels.size()) / before);
    }
}

}  // namespace hepatica
