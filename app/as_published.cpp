// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/as_published.h"

#include <string>
#include <variant>

#include "core/base/error.h"
#include "core/flow/fluid.h"

namespace hepatica {
namespace {

// The name of an action that would change the published body or step; otherwise empty.
std::string other_setting(const Command& command) {
    if (std::holds_alternative<SetQuality>(command)) return "set_quality";
    if (std::holds_alternative<SetAutomaticQuality>(command)) return "set_automatic_quality";
    if (std::holds_alternative<UseSetting>(command)) return "use_setting";
    // It would tear with a fracture energy, which the paper does not have.
    if (std::holds_alternative<UseTear>(command)) return "use_tear";
    return {};
}

}  // namespace

void use_as_published(ReconstructOptions& options) {
    options.method = SegmentationMethod::multi_layer;
    options.refinement_recursions = 1;
    options.thinning = ThinningMethod::parallel;
}

void use_as_published(SceneSpec& scene) {
    if (!scene.deform) return;
    StepperOptions setting;
    setting.model = ElementModel::spring;
    setting.published = true;
    scene.deform->setting = setting;
    if (scene.tear) scene.tear->bare_limit = true;
}

void use_as_published(std::vector<std::vector<Command>>& commands_of_steps) {
    for (std::vector<Command>& commands : commands_of_steps)
        for (Command& command : commands) {
            if (const std::string name = other_setting(command); !name.empty())
                throw InputError("does by " + name + " what --as-published excludes", "the script",
                                 "Leave that action out, or the option");
            if (auto* injection = std::get_if<InjectDrug>(&command)) {
                injection->pressure_model = published_pressure_model;
                injection->void_fraction = published_void_fraction;
                injection->second_phase = "gas";
            }
        }
}

}  // namespace hepatica
