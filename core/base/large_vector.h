// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors in large memory pages. What every step of a simulation reads, tens of megabytes, lies in
// more small pages than a processor keeps the addresses of, but in few large ones.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/large_pages.h"

namespace hepatica {

// values.reserve(count); memory that is allocated for it asks for large pages.
template <class T>
void reserve_large(std::vector<T>& values, std::size_t count) {
    if (count <= values.capacity()) return;
    values.reserve(count);
    prefer_large_pages(values.data() + values.size(), (count - values.size()) * sizeof(T));
}

}  // namespace hepatica
