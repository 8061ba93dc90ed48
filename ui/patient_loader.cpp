// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/patient_loader.h"

#include <stdlib.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/surface.h"
#include "core/mesh/tetrahedralize.h"
#include "core/reconstruction/built_in_patient.h"
#include "core/session/session.h"
#include "core/tree/files/tree_io.h"
#include "ui/simulation_thread.h"
#include "ui/vessel_flow.h"

namespace hepatica {
namespace {

namespace fs = std::filesystem;

PatientCase patient_of(VesselTree tree, Job& job) {
    PatientCase patient;
    job.begin_stage("Making the mesh");
    patient.mesh = tetrahedralize(tree, MeshOptions{}, job);
    patient.surface = surface_of(patient.mesh).mesh;
    patient.tree = std::move(tree);
    return patient;
}

// Removed with all that is in it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "hepatica-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw InputError("no temporary folder can be made", name, "Free some space there");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

PatientCase built_in_patient(Job& job) {
    const TemporaryFolder scan;
    return reconstruct_built_in(scan.path(), job).reconstruction.patient;
}

bool is_tree_file(const fs::path& path) {
    const std::string extension = path.extension().string();
    return extension == ".vtp" || extension == ".swc" || extension == ".json";
}

// Of all that load_patient() does.
int stages_of_loading(const OpenRequest& request) {
    constexpr int preparing = 1, building_the_scene = 1;
    const fs::path& path = request.reconstruct.ct;
    const int reading_or_making = request.built_in     ? built_in_stage_count()
                                  : is_case(path)      ? 1
                                  : is_tree_file(path) ? 2
                                                       : stage_count(request.reconstruct);
    return reading_or_making + preparing + building_the_scene;
}

}  // namespace

LoadedPatient play(std::shared_ptr<const PatientCase> patient, Job& job) {
    LoadedPatient loaded;
    job.begin_stage("Preparing the play");
    loaded.anatomy = SurfaceAnatomy(patient->tree, patient->mesh.vertices_mm, job);
    loaded.flow_shares = flow_shares(patient->tree);
    auto session = std::make_unique<Session>(patient, default_scene(), job);
    session->post(SetAutomaticQuality{true});
    loaded.simulation = std::make_unique<SimulationThread>(std::move(session));
    loaded.patient = std::move(patient);
    return loaded;
}

LoadedPatient load_patient(const OpenRequest& request, Job& job) {
    job.expect_stages(stages_of_loading(request));
    const fs::path& path = request.reconstruct.ct;
    std::vector<std::string> warnings;
    bool on_disk = false;
    PatientCase patient;
    if (request.built_in) {
        patient = built_in_patient(job);
    } else if (!fs::exists(path)) {
        throw InputError("there is no such file or folder", path.string(),
                         "check the name, and that its disk is connected");
    } else if (is_case(path)) {
        job.begin_stage("Reading the case");
        patient = read_case_without_voxels(path);
        on_disk = true;
    } else if (is_tree_file(path)) {
        job.begin_stage("Reading the tree");
        patient = patient_of(read_tree(path), job);
    } else {
        Reconstruction made = reconstruct(request.reconstruct, job);
        patient = std::move(made.patient);
        warnings = std::move(made.warnings);
    }
    LoadedPatient loaded = play(std::make_shared<const PatientCase>(std::move(patient)), job);
    loaded.title = request.built_in ? "Built-in patient" : path.filename().string();
    loaded.warnings = std::move(warnings);
    loaded.on_disk = on_disk;
    if (on_disk) loaded.folder = path;
    return loaded;
}

}  // namespace hepatica
