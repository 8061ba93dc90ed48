// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/case_picture.h"

#ifdef HEPATICA_HAS_RENDER
#include <optional>

#include "core/base/error.h"
#include "core/patient/corrections.h"
#include "core/patient/liver_segments.h"
#include "core/patient/painted_tumours.h"
#include "core/scene/world.h"
#include "core/session/session.h"
#include "core/tree/territories/couinaud_segments.h"
#include "render/offscreen_picture.h"
#include "render/organ_surface.h"
#endif

namespace hepatica {

#ifdef HEPATICA_HAS_RENDER

void colour_vessels(const World& world, const PatientCase& patient, bool by_segment,
                    PictureOptions& picture) {
    std::optional<LabelledPortalVein> portal;
    if (by_segment) {
        portal = label_portal_vein(patient.tree, liver_of(patient.organs));
        if (!portal)
            throw InputError("there are no liver segments to colour", "--segments",
                             "Reconstruct with a liver mask and a seed inside the portal vein");
    }
    for (std::size_t v = 0; v < world.vertex_count(); ++v) {
        const TreePoint place = nearest_point(patient.tree, world.rest_positions_mm()[v]);
        picture.vertex_systems.push_back(patient.tree.segments[place.segment].system);
        if (portal)
            picture.vertex_segments.push_back(
                static_cast<std::uint8_t>(portal->branches[place.segment].segment));
    }
}

bool write_case_picture(const std::shared_ptr<const PatientCase>& patient,
                        const std::filesystem::path& file, Job& job) {
    SceneSpec scene = default_scene();
    scene.deform.reset();
    scene.flow.reset();
    Session session(patient, scene, job);
    session.step(job);
    session.update_frame();
    PictureOptions picture;
    picture.width = 960;
    picture.height = 720;
    colour_vessels(session.world(), *patient, false, picture);
    picture.bridges = views_of(open_gaps(*patient));
    picture.tumours = tumour_surface(tumour_voxels(patient->organs), job);
    picture.caption = patient->source.name;
    write_png(file, draw_frame(session.frame(), picture).picture);
    return true;
}

#else

bool write_case_picture(const std::shared_ptr<const PatientCase>&, const std::filesystem::path&,
                        Job&) {
    return false;
}

#endif

}  // namespace hepatica
