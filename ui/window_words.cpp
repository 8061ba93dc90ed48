// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window_words.h"

#include <array>
#include <regex>
#include <utility>

#include "ui/core_words.h"
#include "ui/patient_place.h"
#include "ui/words.h"

namespace hepatica {
namespace {

// Longer texts first, because they contain shorter ones.
constexpr std::array<std::pair<const char*, const char*>, 38> words{{
    {"--seed-mm X,Y,Z,portal", "Portal vein seeds"},
    {"--seed-mm X,Y,Z,hepatic", "Hepatic vein seeds"},
    {"--seed-mm X,Y,Z,artery", "Hepatic artery seeds"},
    {"(--window LO,HI)", "(Window of File > Reconstruct with options)"},
    {"(--seed-mm)", "(Portal vein seeds or Hepatic vein seeds, beside it)"},
    {"--seed-mm", "Portal vein seeds, Hepatic vein seeds"},
    {"(--vessel-mask)", "(Vessel mask, beside it)"},
    {"--vessel-mask", "Vessel mask"},
    {"--liver-mask", "Liver mask"},
    {"--window", "Window"},
    {"Name those that are vessels: --vessel-label LABEL=SYSTEM,LABEL=SYSTEM, where SYSTEM is "
     "portal, hepatic, artery or unknown; the others are left out",
     "Give the vessels the labels 1 (portal vein), 2 (hepatic veins), 3 (artery) or 255 (unknown) "
     "in the program that drew them, and leave out the others"},
    {"name them: --vessel-label LABEL=SYSTEM,LABEL=SYSTEM",
     "give them these labels in the program that drew them"},
    {", or name those that are vessels (--vessel-label)", " in the program that drew it"},
    {"Measure again: hepatica-cli dial CASE --anew; or remove the file",
     "Remove the file: it is measured again while nobody plays"},
    {"Give a file written by simulate --record", "Give a recording (NAME.hrec) of this program"},
    {"Remove it: hepatica-cli lesson scores its recording again",
     "Remove the file: File > Open recording still shows the play"},
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
    // Files are described by their kind, followed by the JSON key for those who can edit it.
    {"has no \"format\"", "does not say what kind of file it is (\"format\")"},
    {"has no \"version\"", "does not say which version it is of (\"version\")"},
    {"has no \"name\"", "lacks its name (\"name\")"},
    {"has no \"steps\"", "lacks its steps (\"steps\")"},
    {"has no \"goal\"", "lacks a goal (\"goal\")"},
    {"has no \"text\"", "does not say what the trainee is to do (\"text\")"},
    {"has no \"scene\"", "does not say what moves and flows in it (\"scene\")"},
    {"has no \"lessons\"", "lacks its lessons (\"lessons\")"},
    {"See docs/lessons.md, and assets/lessons for lessons that work",
     "Ask who made the file for a whole one, or make a new one (Lesson > Edit lessons)"},
    {"Add it: see docs/lessons.md",
     "Ask who made the file to add it, or make a new one (Lesson > Edit lessons)"},
    {"docs/scenes.md lists the keys of a scene",
     "Ask who made the file: its scene holds what this program does not know"},
    {"docs/scenes.md lists the keys of a script",
     "Ask who made the file: it holds what this program does not know"},
}};

}  // namespace

std::string in_window_words(std::string text) {
    for (const auto& [option, field] : words) {
        const std::string from = option, to = field;
        for (std::size_t at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    }
    // The message of the JSON library for unreadable text.
    static const std::regex parse_error(
        R"(is damaged \(parse error at line (\d+), column (\d+):[^]*)");
    text = std::regex_replace(text, parse_error,
                              "is damaged: it cannot be read from line $1, column $2 on");
    // A seed's place as the field takes it: a comma may stand for the decimal point there.
    static const std::regex seeds(
        R"(^(-?[\d.]+),(-?[\d.]+),(-?[\d.]+) (lies (?:\d+ mm from the liver|outside the image)))");
    static const std::regex corners(
        R"((image, which reaches from )(-?[\d.]+),(-?[\d.]+),(-?[\d.]+))"
        R"(( to )(-?[\d.]+),(-?[\d.]+),(-?[\d.]+)$)");
    text = std::regex_replace(text, seeds, "$1 $2 $3 $4");
    return std::regex_replace(text, corners, "$1$2 $3 $4$5$6 $7 $8");
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

bool names_its_place(const Failure& failure) {
    return failure.place.find('/') != std::string::npos &&
           failure.problem.find(failure.place) != std::string::npos;
}

QString place_in_words(const Failure& failure) {
    const std::optional<Vec3> position_mm = position_of(failure.place);
    return position_mm ? patient_place_in_words(*position_mm) : translated(failure.place);
}

QString in_one_sentence(const Failure& failure) {
    QString text = QString("%1: %2").arg(translated(failure.problem), translated(failure.remedy));
    text[0] = text[0].toUpper();
    return text;
}

}  // namespace hepatica
