// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/as_published.h"

#include <variant>

#include "core/flow/fluid.h"

namespace hepatica {

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
        for (Command& command : commands)
            if (auto* injection = std::get_if<InjectDrug>(&command)) {
                injection->pressure_model = published_pressure_model;
                injection->void_fraction = published_void_fraction;
                injection->second_phase = "gas";
            }
}

}  // namespace hepatica
