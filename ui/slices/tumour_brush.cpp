// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slices/tumour_brush.h"

#include <algorithm>
#include <utility>

#include "ui/words.h"

namespace hepatica {

void TumourBrush::show(std::shared_ptr<const Mask> canvas, Mask organs, std::size_t strokes) {
    canvas_ = std::move(canvas);
    organs_ = std::move(organs);
    tumours_ = tumours_in(organs_);
    why_none_.clear();
    led_.reset();
    strokes_ = strokes;
    strokes_before_ = std::min(strokes_before_, strokes_);
    const auto is_there = [&](int number) {
        return std::ranges::find(tumours_, number, &Tumour::number) != tumours_.end();
    };
    if (chosen_ != 0 && !is_there(chosen_)) gone_ = std::exchange(chosen_, 0);
    if (chosen_ == 0 && gone_ != 0 && is_there(gone_)) chosen_ = std::exchange(gone_, 0);
    watchers_.tell();
}

void TumourBrush::show_none(std::string why_none) {
    canvas_.reset();
    organs_ = {};
    tumours_.clear();
    why_none_ = std::move(why_none);
    led_.reset();
    strokes_ = strokes_before_ = 0;
    chosen_ = gone_ = 0;
    watchers_.tell();
}

int TumourBrush::tumour_at(const Vec3& position_mm) const {
    return organs_.voxels.empty() ? 0 : tumour_of(value_at(organs_, position_mm));
}

void TumourBrush::set_mode(BrushMode mode) {
    lift();
    if (mode_ == BrushMode::away) strokes_before_ = strokes_;
    mode_ = mode;
    watchers_.tell();
}

void TumourBrush::choose(int tumour) {
    chosen_ = tumour;
    gone_ = 0;
    watchers_.tell();
}

std::string TumourBrush::why_not_painted(const Vec3& position_mm) const {
    if (organs_.voxels.empty())
        return why_none_.empty() ? Words::tr("The voxels are being read").toStdString() : why_none_;
    if (!holds(organs_.grid, position_mm))
        return Words::tr("Too far from the liver for a tumour of it").toStdString();
    if (mode_ == BrushMode::paints && chosen_ == 0 && number_for_new(tumours_) == 0)
        return Words::tr("There are %1 tumours, and no more can be told apart")
            .arg(most_tumours)
            .toStdString();
    return {};
}

void TumourBrush::begin(const Vec3& place_mm, double radius_mm) {
    if (mode_ == BrushMode::away || !why_not_painted(place_mm).empty()) return;
    const bool erases = mode_ == BrushMode::erases;
    const int tumour = erases || chosen_ != 0 ? chosen_ : number_for_new(tumours_);
    led_ = tumour_edit({{place_mm}, radius_mm, erases}, tumour);
    changes_ = 0;
    leave({place_mm});
}

void TumourBrush::lead_to(const Vec3& place_mm) {
    if (!led_ || !is_worth_a_step(stroke_of(*led_), place_mm)) return;
    const Vec3 from_mm = led_->path_mm.back();
    led_->path_mm.push_back(place_mm);
    leave({from_mm, place_mm});
}

// Applies the new piece of the stroke to the voxels.
void TumourBrush::leave(const std::vector<Vec3>& path_mm) {
    TreeEdit piece = *led_;
    piece.path_mm = path_mm;
    changes_ += paint_tumour(piece, *canvas_, organs_);
    watchers_.tell();
}

std::string TumourBrush::lift() {
    const std::optional<TreeEdit> stroke = std::exchange(led_, std::nullopt);
    if (!stroke) return {};
    if (changes_ == 0)
        return (mode_ == BrushMode::erases
                    ? Words::tr("Nothing erased: there is no such tumour")
                    : Words::tr("Nothing painted: that is another tumour or the vena cava"))
            .toStdString();
    // The next stroke continues the new tumour.
    if (mode_ == BrushMode::paints) chosen_ = stroke->tumour;
    hand_.add(*stroke);
    return {};
}

bool TumourBrush::drop_led() {
    if (!led_) return false;
    led_.reset();
    hand_.show_again();
    return true;
}

void TumourBrush::remove_last() {
    if (!drop_led()) take_back(1);
}

// Strokes cannot be taken back if another correction was made after them.
void TumourBrush::give_up() {
    if (drop_led()) return;
    const std::size_t before = strokes_made();
    take_back(before);
    if (strokes_made() == before) set_mode(BrushMode::away);
}

void TumourBrush::take_back(std::size_t strokes) {
    if (strokes > 0 && strokes <= strokes_made()) hand_.take_back(strokes);
    watchers_.tell();
}

}  // namespace hepatica
