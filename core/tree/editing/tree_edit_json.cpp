// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of edits (tree_edit.h). Each object has "edit", "at_mm" and the values that its kind needs.
#include "core/base/error.h"
#include "core/base/json_number.h"
#include "core/base/json_problem.h"
#include "core/base/number_text.h"
#include "core/base/patient_space.h"
#include "core/base/written_json.h"
#include "core/image/brush.h"
#include "core/tree/editing/tree_edit.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace {

constexpr std::pair<TreeEditKind, const char*> names[] = {
    {TreeEditKind::cut_link, "cut_link"},
    {TreeEditKind::add_link, "add_link"},
    {TreeEditKind::delete_branch, "delete_branch"},
    {TreeEditKind::delete_tree, "delete_tree"},
    {TreeEditKind::set_root, "set_root"},
    {TreeEditKind::reassign_system, "reassign_system"},
    {TreeEditKind::seed_system, "seed_system"},
    {TreeEditKind::draw_vessel, "draw_vessel"},
    {TreeEditKind::paint_tumour, "paint_tumour"},
    {TreeEditKind::erase_tumour, "erase_tumour"},
    {TreeEditKind::refuse_gap, "refuse_gap"},
};

const char* name_of(TreeEditKind kind) {
    for (const auto& [known, name] : names)
        if (known == kind) return name;
    return "";
}

TreeEditKind kind_named(const std::string& wanted, const std::string& place) {
    for (const auto& [kind, name] : names)
        if (wanted == name) return kind;
    throw InputError("there is no edit named " + wanted, place, "Take the edit out of the file");
}

// Edits of these kinds go from one place to another.
bool joins_places(TreeEditKind kind) {
    return kind == TreeEditKind::add_link || kind == TreeEditKind::refuse_gap;
}

// Edits of these kinds have "system" in their JSON, even where it is unknown.
bool needs_system(TreeEditKind kind) {
    return kind == TreeEditKind::reassign_system || kind == TreeEditKind::seed_system;
}

// A name or a number.
VascularSystem system_from(const nlohmann::json& value, const std::string& place) {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (const auto system = system_named(text)) return *system;
    throw InputError("there is no vascular system " + text, place,
                     "Name one of these: " + list_of_systems());
}

void read_drawing(const nlohmann::json& value, const std::string& place, TreeEdit& edit) {
    edit.path_mm = path_from(value.at("path_mm"));
    edit.radii_mm = value.at("radii_mm").get<std::vector<double>>();
    if (edit.path_mm.size() < 2 || edit.radii_mm.size() != edit.path_mm.size())
        throw InputError("a vessel is drawn by " + std::to_string(edit.path_mm.size()) +
                             " points with " + std::to_string(edit.radii_mm.size()) + " radii",
                         place, "Give two points or more in path_mm, and one of radii_mm for each");
    for (const double radius : edit.radii_mm)
        if (!(radius >= thinnest_drawn_mm && radius <= widest_drawn_mm))
            throw InputError("a vessel is drawn with a radius of " + number_text(radius) + " mm",
                             place, "Give radii from 0.001 to 50 mm");
    edit.at_mm = edit.path_mm.front();
    if (value.contains("system")) edit.system = system_from(value.at("system"), place);
}

// A stroke of one point needs no path.
void read_stroke(const nlohmann::json& value, const std::string& place, TreeEdit& edit) {
    edit.path_mm = value.contains("path_mm") ? path_from(value.at("path_mm"))
                                             : std::vector{vec3_from(value.at("at_mm"))};
    if (edit.path_mm.empty())
        throw InputError("a brush is led nowhere", place, "Give one point or more in path_mm");
    edit.at_mm = edit.path_mm.front();
    const auto radius_mm = value.at("radius_mm").get<double>();
    if (!(radius_mm > 0.0 && radius_mm <= widest_brush_mm))
        throw InputError("a brush has a radius of " + number_text(radius_mm) + " mm", place,
                         "Give a radius above 0 and up to 50 mm");
    edit.radii_mm = {radius_mm};
    const bool of_all = edit.kind == TreeEditKind::erase_tumour && !value.contains("tumour");
    if (of_all) return;
    edit.tumour = whole_number<int>(value.at("tumour"));
    if (edit.tumour < 1 || edit.tumour > most_tumours)
        throw InputError("there can be no tumour " + std::to_string(edit.tumour), place,
                         "Number tumours from 1 to " + std::to_string(most_tumours));
}

int step_from(const nlohmann::json& value, const std::string& place) {
    const int step = whole_number<int>(value);
    if (step >= 1 && step <= most_steps) return step;
    throw InputError("an edit belongs to step " + std::to_string(step), place,
                     "Number steps from 1 to 1000000, or leave them out");
}

TreeEdit edit_from(const nlohmann::json& value, const std::string& place) {
    TreeEdit edit;
    edit.kind = kind_named(value.at("edit").get<std::string>(), place);
    if (edit.kind == TreeEditKind::draw_vessel)
        read_drawing(value, place, edit);
    else if (is_tumour_stroke(edit.kind))
        read_stroke(value, place, edit);
    else
        edit.at_mm = vec3_from(value.at("at_mm"));
    if (joins_places(edit.kind)) edit.to_mm = vec3_from(value.at("to_mm"));
    if (edit.kind == TreeEditKind::add_link && value.contains("path_mm"))
        edit.path_mm = path_from(value.at("path_mm"));
    require_in_patient_space(edit.at_mm, "an edit", place);
    require_in_patient_space(edit.to_mm, "the other end of an edit", place);
    for (const Vec3& point : edit.path_mm)
        require_in_patient_space(point, is_tumour_stroke(edit.kind) ? "a brush" : "a vessel",
                                 place);
    if (needs_system(edit.kind)) edit.system = system_from(value.at("system"), place);
    if (value.contains("step")) edit.step = step_from(value.at("step"), place);
    return edit;
}

TreeEdit read_edit(const nlohmann::json& value, const std::string& place) {
    try {
        return edit_from(value, place);
    } catch (const nlohmann::json::exception& error) {
        throw InputError(json_problem(error), place,
                         "Give the edit all of its values, each of its kind");
    }
}

// Edits come from people, too, as lists for the command line.
nlohmann::json list_of_edits(const std::string& text, const std::string& place) {
    try {
        return parse_written<nlohmann::json>(text);
    } catch (const InputError& error) {
        throw InputError(error.place() + " " + error.problem(), place, error.remedy());
    }
}

}  // namespace

std::string edits_to_json(const std::vector<TreeEdit>& edits) {
    nlohmann::json list = nlohmann::json::array();
    for (const TreeEdit& edit : edits) {
        nlohmann::json value{{"edit", name_of(edit.kind)}, {"at_mm", json_of(edit.at_mm)}};
        if (joins_places(edit.kind)) value["to_mm"] = json_of(edit.to_mm);
        if (edit.kind == TreeEditKind::add_link && !edit.path_mm.empty())
            value["path_mm"] = json_of(edit.path_mm);
        if (edit.kind == TreeEditKind::draw_vessel) {
            value["path_mm"] = json_of(edit.path_mm);
            value["radii_mm"] = edit.radii_mm;
        }
        if (is_tumour_stroke(edit.kind)) {
            if (edit.path_mm.size() > 1) value["path_mm"] = json_of(edit.path_mm);
            value["radius_mm"] = edit.radii_mm.front();
            if (edit.tumour != 0) value["tumour"] = edit.tumour;
        }
        if (needs_system(edit.kind) || edit.system != VascularSystem::unknown)
            value["system"] = name_of(edit.system);
        if (edit.step != 0) value["step"] = edit.step;
        list.push_back(std::move(value));
    }
    return list.dump(1);
}

std::vector<TreeEdit> edits_from_json(const std::string& text, const std::string& place) {
    try {
        const nlohmann::json list = list_of_edits(text, place);
        if (!list.is_array())
            throw InputError("is not a list of edits", place, "Give a JSON array of edits");
        std::vector<TreeEdit> edits;
        for (const nlohmann::json& value : list)
            edits.push_back(read_edit(value, place + ", edit " + std::to_string(edits.size() + 1)));
        return edits;
    } catch (const nlohmann::json::exception& error) {
        throw InputError(json_problem(error), place, "Give a JSON array of edits");
    }
}

}  // namespace hepatica
