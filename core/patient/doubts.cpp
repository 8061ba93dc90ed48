// SPDX-License-Identifier: GPL-3.0-or-later
// Computes doubts from a tree and words them.
#include "core/patient/doubts.h"

#include <cmath>

#include "core/tree/system_summary.h"
#include "core/tree/systems/doubtful_roots.h"
#include "core/tree/territories/segment_name.h"

namespace hepatica {

namespace {

constexpr double notable_share = 0.05;  // share of the length or volume worth a sentence
constexpr double dim_contrast = 3.5;    // in standard deviations of the noise

std::string percent(double share) {
    return std::to_string(std::lround(100.0 * share)) + " %";
}

std::string number_of(int count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string listed(const std::vector<int>& segments) {
    std::string list;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (i > 0) list += i + 1 == segments.size() ? " and " : ", ";
        list += segment_name(segments[i]);
    }
    return list;
}

constexpr const char* found_liver_sentence =
    "The liver was found by the program: on real patients about 6 % of such a liver lay outside of "
    "an expert's, and 10 % of the expert's were missed. A segment beside stomach or pancreas, "
    "mostly III, may lie outside of it by nearly half. Where volumes matter, give a mask of the "
    "liver.";

void add_sentences(const SegmentDoubts& doubts, std::vector<std::string>& list) {
    if (doubts.veins_known < 3)
        list.push_back(
            std::string(doubts.veins_known == 0 ? "No hepatic vein is"
                                                : "Not all three hepatic veins are") +
            " known where the liver's segments part: an adult's usual planes stand in for them. A "
            "seed inside a hepatic vein helps.");
    if (!doubts.without_branch.empty()) {
        const bool one = doubts.without_branch.size() == 1;
        list.push_back(std::string("No portal branch to the liver's ") +
                       (one ? "segment " : "segments ") + listed(doubts.without_branch) +
                       " was found: " + (one ? "its" : "their") +
                       " part of the liver counts to the neighbours.");
    }
    if (doubts.unsure_share > notable_share)
        list.push_back("For " + percent(doubts.unsure_share) +
                       " of the liver it is less than 80 % sure to which of Couinaud's segments it "
                       "belongs: the branches there run across the usual borders.");
}

}  // namespace

Doubts doubts_of(const VesselTree& tree) {
    Doubts doubts;
    double whole = 0.0, uncertain = 0.0, unknown = 0.0;
    for (const VesselSegment& segment : tree.segments) {
        const double length = length_mm(segment);
        whole += length;
        if (segment.system_confidence < sure_confidence) uncertain += length;
        if (segment.system == VascularSystem::unknown) unknown += length;
        if (segment.closes_loop) ++doubts.loops;
    }
    if (whole > 0.0) {
        doubts.uncertain_share = uncertain / whole;
        doubts.unknown_share = unknown / whole;
    }
    return doubts;
}

std::vector<std::string> sentences(const Doubts& doubts) {
    std::vector<std::string> list;
    if (doubts.unknown_share > notable_share)
        list.push_back("For " + percent(doubts.unknown_share) +
                       " of the vessels' length nothing tells which system they belong to. A seed "
                       "inside the portal vein and one inside a hepatic vein would tell them "
                       "apart.");
    if (const double other = doubts.uncertain_share - doubts.unknown_share; other > notable_share)
        list.push_back("For " + percent(other) +
                       " of the vessels' length it is less than 80 % sure whether they belong to "
                       "the portal vein or to the hepatic veins. Look at branches where both "
                       "touch; a seed inside a wrong one, or giving the branch to the other "
                       "system, mends all that hangs on it.");
    if (doubts.noise_hu > 0.0 && doubts.contrast_hu < dim_contrast * doubts.noise_hu)
        list.push_back(
            "The vessels rise only " + std::to_string(std::lround(doubts.contrast_hu)) +
            " HU above the liver, where the noise is " +
            std::to_string(std::lround(doubts.noise_hu)) +
            " HU: most thin branches are missing, and some that are found may be noise. A "
            "scan in the portal venous phase, or a smoother kernel, shows more.");
    if (doubts.segments && doubts.segments->liver_found) list.push_back(found_liver_sentence);
    if (doubts.opened_loops > 0)
        list.push_back(number_of(doubts.opened_loops, "loop") +
                       " within one system, made where branches touch in the image, " +
                       (doubts.opened_loops == 1 ? "was" : "were") +
                       " opened. Thinner slices would part such branches.");
    if (doubts.loops > 0)
        list.push_back(number_of(doubts.loops, "loop") + (doubts.loops == 1 ? " is" : " are") +
                       " left in the vessels. Cut those that are no real connections.");
    if (doubts.segments) add_sentences(*doubts.segments, list);
    return list;
}

std::vector<std::string> sentences(const std::optional<Doubts>& doubts, const VesselTree& tree) {
    std::vector<std::string> list = sentences(doubtful_roots(tree));
    Doubts now = doubts.value_or(Doubts{});
    now.loops = doubts_of(tree).loops;
    for (std::string& sentence : sentences(now)) list.push_back(std::move(sentence));
    return list;
}

}  // namespace hepatica
