// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/threshold_history.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

namespace hepatica {
namespace {

std::size_t fingerprint_of(const Mask& vessels) {
    return std::hash<std::string_view>()(
        {reinterpret_cast<const char*>(vessels.voxels.data()), vessels.voxels.size()});
}

// Number of voxels that are vessel in one mask only.
std::ptrdiff_t differences(const Mask& a, const Mask& b) {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < a.voxels.size(); ++i)
        count += (a.voxels[i] != 0) != (b.voxels[i] != 0) ? 1 : 0;
    return count;
}

}  // namespace

void ThresholdHistory::begin(const Mask& vessels) {
    forget();
    auto present = std::make_shared<const Mask>(vessels);
    stand({fingerprint_of(vessels), {}, present}, present);
}

bool ThresholdHistory::follow(const Mask& vessels) {
    const std::size_t fingerprint = fingerprint_of(vessels);
    if (empty() || vessels.voxels.size() != vessels_->voxels.size()) {
        begin(vessels);
        return false;
    }
    if (fingerprint == now_.fingerprint) return false;
    auto present = std::make_shared<const Mask>(vessels);
    const auto known = std::ranges::find(before_, fingerprint, &State::fingerprint);
    if (known != before_.end()) {
        stand(State(*known), present);
        return false;
    }
    if (is_rebuilt(vessels)) {
        wanted_vessels_.reset();
        stand({fingerprint, wanted_, now_.usual}, present);
        return false;
    }
    stand({fingerprint, now_.choice, usual_with_changes(present)}, present);
    return true;
}

void ThresholdHistory::rebuild(const ThresholdChoice& choice, Mask vessels) {
    wanted_ = choice;
    wanted_vessels_ = std::make_shared<const Mask>(std::move(vessels));
}

// Tolerates strokes painted while the vessels were rebuilt: nearer to the rebuilt mask than to the
// old one.
bool ThresholdHistory::is_rebuilt(const Mask& vessels) const {
    return wanted_vessels_ && wanted_vessels_->voxels.size() == vessels.voxels.size() &&
           differences(vessels, *wanted_vessels_) < differences(vessels, *vessels_);
}

std::shared_ptr<const Mask> ThresholdHistory::usual_with_changes(
    std::shared_ptr<const Mask> vessels) const {
    if (now_.usual == vessels_) return vessels;
    auto usual = std::make_shared<Mask>(*now_.usual);
    for (std::size_t i = 0; i < usual->voxels.size(); ++i)
        if (vessels->voxels[i] != vessels_->voxels[i]) usual->voxels[i] = vessels->voxels[i];
    return usual;
}

void ThresholdHistory::stand(State state, std::shared_ptr<const Mask> vessels) {
    std::erase_if(before_, [&](const State& one) { return one.fingerprint == state.fingerprint; });
    if (before_.size() == most_states) before_.erase(before_.begin());
    before_.push_back(state);
    now_ = std::move(state);
    vessels_ = std::move(vessels);
}

}  // namespace hepatica
