// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/predicate_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace hepatica {

using Json = nlohmann::ordered_json;

namespace {

Quantity quantity_from(const LessonFields& field) {
    const std::string name = field.text();
    std::string known;
    for (const QuantityWords& words : quantities()) {
        if (name == words.name) return words.quantity;
        known += (known.empty() ? "" : ", ") + std::string(words.name);
    }
    field.refuse("is \"" + name + "\", which is not measured", "Choose from " + known);
}

Predicate predicate_from(const LessonFields& fields, const std::vector<std::string>& marks) {
    fields.know({"what", "mark", "at_least", "at_most"});
    Predicate predicate;
    predicate.quantity = quantity_from(fields.need("what"));
    predicate.at_least = fields.has("at_least");
    if (predicate.at_least == fields.has("at_most"))
        fields.refuse("needs either at_least or at_most", lesson_remedy);
    predicate.bound = fields.need(predicate.at_least ? "at_least" : "at_most").number();
    const bool of_mark = words_of(predicate.quantity).of_mark;
    if (of_mark && !fields.has("mark") && fields.unfinished()) return predicate;
    if (of_mark != fields.has("mark"))
        fields.refuse(fields.has("mark") ? "names a mark that it does not need"
                                         : "does not say which mark is meant",
                      "Of the quantities " + std::string("distance_mm, moved_mm and touch_mm") +
                          " alone name a mark");
    if (!fields.has("mark")) return predicate;
    const LessonFields mark = fields.need("mark");
    const auto found = std::ranges::find(marks, mark.text());
    if (found == marks.end())
        mark.refuse("is \"" + mark.text() + "\", which is no mark of this lesson",
                    "Name it under \"marks\"");
    predicate.mark = static_cast<int>(found - marks.begin());
    return predicate;
}

}  // namespace

std::vector<Predicate> predicates_from(const LessonFields& fields, const char* key,
                                       const std::vector<std::string>& marks) {
    std::vector<Predicate> predicates;
    if (fields.has(key))
        for (const LessonFields& entry : fields.need(key).list())
            predicates.push_back(predicate_from(entry, marks));
    return predicates;
}

nlohmann::ordered_json json_of(const std::vector<Predicate>& bounds,
                               const std::vector<std::string>& marks) {
    Json list = Json::array();
    for (const Predicate& bound : bounds) {
        const QuantityWords& words = words_of(bound.quantity);
        Json json{{"what", words.name}};
        // One that has lost its mark is written without it: see gaps_in().
        if (const auto mark = static_cast<std::size_t>(bound.mark);
            words.of_mark && mark < marks.size())
            json["mark"] = marks[mark];
        json[bound.at_least ? "at_least" : "at_most"] = bound.bound;
        list.push_back(std::move(json));
    }
    return list;
}

}  // namespace hepatica
