// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_gaps.h"

#include <algorithm>

namespace hepatica {

namespace {

// The first words of a text, on one line.
std::string beginning_of(std::string text) {
    constexpr std::size_t most = 48;  // bytes
    for (char& letter : text)
        if (letter == '\n' || letter == '\t') letter = ' ';
    if (text.size() <= most) return text;
    std::size_t end = text.rfind(' ', most);
    if (end == std::string::npos || end == 0) {
        end = most;
        const auto continues = [&] { return (static_cast<unsigned char>(text[end]) >> 6) == 2; };
        while (end > 0 && continues()) --end;  // keeps UTF-8 sequences whole
    }
    return text.substr(0, end) + "…";
}

class Finder {
  public:
    explicit Finder(const Lesson& lesson) : lesson_(lesson), marks_(lesson.mark_names()) {}

    std::vector<std::string> all() {
        if (lesson_.name.empty()) gaps_.push_back("The lesson has no name: give it one.");
        if (!lesson_.scene.deform && !lesson_.scene.flow)
            gaps_.push_back(
                "The scene is of nothing: let the vessels move, a drug be injected, or both.");
        for (std::size_t i = 0; i < lesson_.steps.size(); ++i) look_at_step(i);
        look_at(lesson_.limits, "Limits all the time");
        look_at(lesson_.pass, "Pass marks");
        return std::move(gaps_);
    }

  private:
    void look_at_step(std::size_t index) {
        const LessonStep& step = lesson_.steps[index];
        const std::string where = step_in_words(lesson_, index);
        if (step.text.empty())
            gaps_.push_back(where + " says nothing: write what the trainee is to do.");
        if (step.goal.empty()) gaps_.push_back(where + " has no goal: add what is to be reached.");
        const auto& allowed = lesson_.tools;
        if (step.tool && std::ranges::find(allowed, *step.tool) == allowed.end())
            gaps_.push_back(where + " asks for the tool " + std::string(name_of(*step.tool)) +
                            ", which the lesson does not allow: allow it, or ask for none.");
        look_at(step.goal, where + ", goal");
        look_at(step.limits, where + ", limits");
    }

    void look_at(const std::vector<Predicate>& bounds, const std::string& where) {
        for (const Predicate& bound : bounds)
            if (words_of(bound.quantity).of_mark &&
                static_cast<std::size_t>(bound.mark) >= marks_.size())  // -1 is beyond the end
                gaps_.push_back(where + ": \"" + to_words(bound, marks_) +
                                "\" has lost its mark. Choose another one, or remove the bound.");
    }

    const Lesson& lesson_;
    std::vector<std::string> marks_;
    std::vector<std::string> gaps_;
};

}  // namespace

std::string step_in_words(const Lesson& lesson, std::size_t step) {
    const std::string number = "Step " + std::to_string(step + 1);
    const std::string title = beginning_of(lesson.steps.at(step).text);
    return title.empty() ? number : number + " \"" + title + "\"";
}

std::vector<std::string> gaps_in(const Lesson& lesson) {
    return Finder(lesson).all();
}

}  // namespace hepatica
