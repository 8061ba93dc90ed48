// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window_words.h"

#include <array>
#include <utility>

#include "ui/core_words.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// The longer ones first: they hold the shorter ones.
constexpr std::array<std::pair<const char*, const char*>, 22> words{{
    {"--seed-mm X,Y,Z,1 and --seed-mm X,Y,Z,2",
     "written into Portal vein seeds and Hepatic vein seeds of File > Reconstruct with options"},
    {"--seed-mm X,Y,Z,portal and --seed-mm X,Y,Z,hepatic",
     "written into Portal vein seeds and Hepatic vein seeds of File > Reconstruct with options"},
    {"(--window LO,HI)", "(Window of File > Reconstruct with options)"},
    {"(--seed-mm)", "(Portal vein seeds or Hepatic vein seeds, beside it)"},
    {"--seed-mm", "Portal vein seeds, Hepatic vein seeds"},
    {"(--vessel-mask)", "(Vessel mask, beside it)"},
    {"--vessel-mask", "Vessel mask"},
    {"--liver-mask", "Liver mask"},
    {"--window", "Window"},
    {"--vessel-label LABEL=SYSTEM,LABEL=SYSTEM",
     "hepatica-cli reconstruct takes LABEL=SYSTEM for each of them"},
    {"--vessel-label A,B", "hepatica-cli reconstruct takes their labels"},
    {"(--vessel-label)", "(hepatica-cli reconstruct takes their labels)"},
    {"hepatica-cli reconstruct CT --out CASE.hep", "File > Open CT folder or Open CT file"},
    {"(hepatica-cli edit)", "(Edit in the tool bar)"},
    {"hepatica-cli edit", "Edit in the tool bar, then Cut the vessel"},
    {"Give --out another name", "Choose another name"},
    {"Leave --tree-space out", "Leave the tree's space out"},
    {"Leave --radius-mm out", "Leave the radius out"},
    {"Leave --series out", "Leave the series out"},
    {"On the command line --series ", "In File > Reconstruct with options, Series "},
    {"--tree-space lps or --tree-space ras", "on the command line"},
    {"--radius-mm", "on the command line"},
}};

}  // namespace

std::string in_window_words(std::string text) {
    for (const auto& [option, field] : words) {
        const std::string from = option, to = field;
        for (std::size_t at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    }
    return text;
}

QString in_short(const std::vector<std::string>& warnings) {
    constexpr std::size_t shown = 2;
    QString text;
    for (std::size_t i = 0; i < warnings.size() && i < shown; ++i)
        text += (i == 0 ? "" : "\n") + translated(warnings[i]);
    if (warnings.size() > shown)
        text += "\n" + Words::tr("%n more under All messages.", nullptr,
                                 static_cast<int>(warnings.size() - shown));
    return text;
}

QString in_one_sentence(const Failure& failure) {
    QString text = QString("%1: %2").arg(translated(failure.problem), translated(failure.remedy));
    text[0] = text[0].toUpper();
    return text;
}

}  // namespace hepatica
