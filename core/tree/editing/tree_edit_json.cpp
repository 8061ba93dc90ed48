// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/json_problem.h"
#include "core/base/patient_space.h"
#include "core/tree/editing/tree_edit.h"
#include "core/tree/files/tree_json.h"

namespace hepatica {

namespace {

constexpr std::pair<TreeEditKind, const char*> names[] = {
    {TreeEditKind::cut_link, "cut_link"},
    {TreeEditKind::add_link, "add_link"},
    {TreeEditKind::delete_branch, "delete_branch"},
    {TreeEditKind::set_root, "set_root"},
    {TreeEditKind::reassign_system, "reassign_system"},
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

// A name or a number.
VascularSystem system_from(const nlohmann::json& value, const std::string& place) {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (const auto system = system_named(text)) return *system;
    throw InputError("there is no vascular system " + text, place,
                     "Name one of these: " + list_of_systems());
}

TreeEdit edit_from(const nlohmann::json& value, const std::string& place) {
    TreeEdit edit;
    edit.kind = kind_named(value.at("edit").get<std::string>(), place);
    edit.at_mm = vec3_from(value.at("at_mm"));
    if (edit.kind == TreeEditKind::add_link) {
        edit.to_mm = vec3_from(value.at("to_mm"));
        if (value.contains("path_mm")) edit.path_mm = path_from(value.at("path_mm"));
    }
    require_in_patient_space(edit.at_mm, "an edit", place);
    require_in_patient_space(edit.to_mm, "the end of a link", place);
    for (const Vec3& point : edit.path_mm) require_in_patient_space(point, "a link", place);
    if (edit.kind == TreeEditKind::reassign_system)
        edit.system = system_from(value.at("system"), place);
    return edit;
}

}  // namespace

std::string edits_to_json(const std::vector<TreeEdit>& edits) {
    nlohmann::json list = nlohmann::json::array();
    for (const TreeEdit& edit : edits) {
        nlohmann::json value{{"edit", name_of(edit.kind)}, {"at_mm", json_of(edit.at_mm)}};
        if (edit.kind == TreeEditKind::add_link) {
            value["to_mm"] = json_of(edit.to_mm);
            if (!edit.path_mm.empty()) value["path_mm"] = json_of(edit.path_mm);
        }
        if (edit.kind == TreeEditKind::reassign_system) value["system"] = name_of(edit.system);
        list.push_back(std::move(value));
    }
    return list.dump(1);
}

std::vector<TreeEdit> edits_from_json(const std::string& text, const std::string& place) {
    try {
        const nlohmann::json list = nlohmann::json::parse(text);
        if (!list.is_array())
            throw InputError("is not a list of edits", place, "Give a JSON array of edits");
        std::vector<TreeEdit> edits;
        for (const nlohmann::json& value : list) edits.push_back(edit_from(value, place));
        return edits;
    } catch (const nlohmann::json::exception& error) {
        throw InputError(json_problem(error), place, "Give a JSON array of edits");
    }
}

}  // namespace hepatica
