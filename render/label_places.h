// SPDX-License-Identifier: GPL-3.0-or-later
// Places the labels of one picture side by side: within the picture, and none on another.
#pragma once

#include <optional>
#include <vector>

namespace hepatica {

struct LabelBox {
    double left = 0.0, top = 0.0;  // the smaller numbers
    double width = 0.0, height = 0.0;
};

struct PlacedLabel {
    LabelBox box;
    bool evades = false;  // it was shifted because of another label
};

// Of one picture, whichever way its y runs.
class LabelPlaces {
  public:
    // Labels stay within this part of the picture.
    explicit LabelPlaces(const LabelBox& room) : room_(room) {}

    // Something else lies there, which no label may cover.
    void keep_off(const LabelBox& box) { placed_.push_back(box); }

    // The free place nearest to the wanted one; nothing where there is none, as for a label that is
    // larger than the room. Costs the cube of the number of labels placed before, where the wanted
    // place is taken.
    std::optional<PlacedLabel> place(const LabelBox& wanted);

  private:
    bool is_free(const LabelBox& box) const;
    // The nearest free place.
    std::optional<LabelBox> beside_others(const LabelBox& wanted) const;

    LabelBox room_;
    std::vector<LabelBox> placed_;
};

}  // namespace hepatica
