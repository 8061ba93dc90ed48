// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest known key by prefix or edit distance.
#include "core/base/unknown_key.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace hepatica {
namespace {

// Levenshtein distance, with one row of the table of prefix distances at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string unknown_key(std::string_view key, std::span<const std::string> known) {
    if (known.empty()) return "is not known, and no key is";
    constexpr std::size_t least_beginning = 3;
    auto meant = std::ranges::find_if(known, [&](const std::string& name) {
        return key.size() >= least_beginning && name.starts_with(key);
    });
    if (meant == known.end()) {
        meant = std::ranges::min_element(
            known, {}, [&](const std::string& name) { return edit_distance(key, name); });
        if (2 * edit_distance(key, *meant) > std::max(key.size(), meant->size()))
            meant = known.end();
    }
    if (meant != known.end()) return "is not known; the nearest key is \"" + *meant + "\"";
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    return "is not known; choose from " + list;
}

}  // namespace hepatica
