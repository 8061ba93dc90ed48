// SPDX-License-Identifier: GPL-3.0-or-later
// The median of a list: the middle value, or the upper of the two middle values.
#pragma once

#include <algorithm>
#include <cassert>
#include <iterator>
#include <vector>

namespace hepatica {

// `values` must not be empty. Takes linear time.
template <class T>
T median(std::vector<T> values) {
    assert(!values.empty());
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace hepatica
