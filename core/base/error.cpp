// SPDX-License-Identifier: GPL-3.0-or-later
// The sentence that what() returns: "place: problem. remedy".
#include "core/base/error.h"

namespace hepatica {

namespace {

std::string sentence(const std::string& problem, const std::string& place,
                     const std::string& remedy) {
    std::string text = place.empty() ? problem : place + ": " + problem;
    if (!remedy.empty()) text += ". " + remedy;
    return text;
}

}  // namespace

Error::Error(std::string problem, std::string place, std::string remedy)
    : std::runtime_error(sentence(problem, place, remedy)),
      problem_(std::move(problem)),
      place_(std::move(place)),
      remedy_(std::move(remedy)) {}

}  // namespace hepatica
