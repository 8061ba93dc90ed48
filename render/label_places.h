// SPDX-License-Identifier: GPL-3.0-or-later
// Labels that would lie on each other stand one above or below another.
#pragma once

#include <vector>

namespace hepatica {

struct LabelBox {
    double left = 0.0, top = 0.0;  // the smaller numbers
    double width = 0.0, height = 0.0;
};

// Of one picture, whichever way its y runs.
class LabelPlaces {
  public:
    // Labels stay between these, the whole height of the picture, where they can.
    LabelPlaces(double least, double most) : least_(least), most_(most) {}

    // By how much a label is shifted in y so that it lies on none placed before: by the least there
    // is, up or down; 0 where there is no such place. It counts as placed.
    double place(const LabelBox& box);

  private:
    bool is_free(const LabelBox& box) const;

    double least_, most_;
    std::vector<LabelBox> placed_;
};

}  // namespace hepatica
