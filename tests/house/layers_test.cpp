// SPDX-License-Identifier: GPL-3.0-or-later
// Reads every include of the tree and fails on an arrow that runs against the layers:
// app -> ui -> render -> core, gpu -> core; and within core along the flow of data.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source_root = HEPATICA_SOURCE_DIR;

// What a room's headers and sources may include, besides themselves.
const std::map<std::string, std::set<std::string>> allowed_rooms{
    {"core/base", {}},
    {"core/image", {"core/base"}},
    {"core/skeleton", {"core/base", "core/image"}},
    {"core/segmentation", {"core/base", "core/image", "core/skeleton"}},
    {"core/tree", {"core/base", "core/image", "core/skeleton"}},
    {"core/links", {"core/base", "core/image", "core/segmentation", "core/tree"}},
    {"core/phantom", {"core/base", "core/image", "core/tree"}},
    {"core/accuracy",
     {"core/base", "core/image", "core/skeleton", "core/segmentation", "core/tree"}},
    {"core/mesh", {"core/base", "core/tree"}},
    {"core/flow", {"core/base", "core/tree"}},
    {"core/contact", {"core/base", "core/mesh"}},
    {"core/tear", {"core/base", "core/mesh"}},
    {"core/deform", {"core/base", "core/mesh", "core/contact", "core/tear"}},
    {"core/patient", {"core/base", "core/image", "core/tree", "core/mesh"}},
    {"core/reconstruction",
     {"core/base", "core/image", "core/skeleton", "core/segmentation", "core/tree", "core/links",
      "core/phantom", "core/mesh", "core/patient"}},
    {"core/training",
     {"core/base", "core/image", "core/segmentation", "core/tree", "core/links", "core/phantom",
      "core/reconstruction"}},
    {"core/opening",
     {"core/base", "core/image", "core/tree", "core/mesh", "core/patient", "core/reconstruction"}},
    {"core/scene",
     {"core/base", "core/image", "core/tree", "core/mesh", "core/flow", "core/contact", "core/tear",
      "core/deform", "core/patient"}},
    {"core/session",
     {"core/base", "core/image", "core/tree", "core/mesh", "core/flow", "core/deform",
      "core/patient", "core/scene"}},
    {"core/haptics", {"core/base", "core/contact", "core/deform", "core/scene", "core/session"}},
    {"core/lesson",
     {"core/base", "core/tree", "core/mesh", "core/flow", "core/patient", "core/scene",
      "core/session"}},
    {"core/study",
     {"core/base", "core/tree", "core/mesh", "core/tear", "core/deform", "core/patient",
      "core/scene", "core/session", "core/haptics"}},
};

// Libraries that a layer must not name at all.
const std::map<std::string, std::regex> forbidden_libraries{
    {"core", std::regex("^(Q[A-Z]|vtkRender|vtkOpenGL|vtkActor|vtkQt|GL/|cuda|itk)")},
    {"gpu", std::regex("^(Q[A-Z]|vtk|GL/|itk|opencv|CGAL|bt[A-Z]|bullet)")},
    {"render", std::regex("^(Q[A-Z]|cuda|itk|opencv|CGAL|bt[A-Z])")},
    {"ui", std::regex("^(cuda|itk|opencv|CGAL|bt[A-Z]|bullet)")},
    {"app", std::regex("^(itk)")},
};

// Libraries that compile slowly or leak their types: only inside .cpp files of core.
const std::regex source_only_libraries("^(opencv|CGAL|vtk|bt[A-Z]|bullet|gdcm|minizip)");

// The one file that knows CUDA's runtime; without it the kernels run emulated.
const std::string file_of_cuda = "gpu/machine/device_machine.cu";

std::string layer_of(const std::string& path) {
    return path.substr(0, path.find('/'));
}

std::string room_of(const std::string& path) {
    const std::size_t first = path.find('/');
    const std::size_t second = path.find('/', first + 1);
    return layer_of(path) == "core" && second != std::string::npos ? path.substr(0, second)
                                                                   : layer_of(path);
}

bool layer_may_include(const std::string& from, const std::string& to) {
    static const std::map<std::string, std::set<std::string>> allowed{
        {"core", {}},
        {"gpu", {"core"}},
        {"render", {"core"}},
        {"ui", {"render", "core"}},
        {"app", {"ui", "render", "gpu", "core"}},
        {"bench", {"app", "ui", "render", "gpu", "core"}},
    };
    return from == to || allowed.at(from).contains(to);
}

// Each helper is a program of its own, so that DCMTK's parser never runs in another one.
std::string helper_of(const std::string& file) {
    for (const char* folder : {"app/dicom_frames/", "app/dicom_segmentation/"})
        if (file.starts_with(folder)) return folder;
    return {};
}

// What kernels are compiled without, by nvcc as well; also where a file of core brings it along.
bool is_of_eigen(const std::string& include) {
    return include.starts_with("Eigen/") || include == "core/base/small_matrix_eigen.h" ||
           include == "core/base/vector.h";
}

// Why `file` may not include `include`; empty where it may.
std::string objection(const std::string& file, const std::string& include) {
    const std::string layer = layer_of(file);
    const std::string helper = helper_of(file);
    if (include.starts_with("dcmtk/") && helper.empty()) return "is a library for helpers alone";
    if (include.starts_with("cuda") && file != file_of_cuda) return "is for one file of gpu alone";
    if (file.starts_with("gpu/kernels/") && is_of_eigen(include)) return "is not for kernels";
    static const std::set<std::string> layers{"core", "gpu", "render", "ui", "app", "bench"};
    if (layers.contains(layer_of(include)) && include.find('/') != std::string::npos) {
        if (helper != helper_of(include)) return "joins a helper to the rest";
        if (!layer_may_include(layer, layer_of(include))) return "runs against the layers";
        const std::string from = room_of(file);
        const std::string to = room_of(include);
        if (layer == "core" && from != to) {
            if (!allowed_rooms.contains(from)) return "room " + from + " is not in the plan";
            if (!allowed_rooms.at(from).contains(to)) return "runs against the flow of data";
        }
        return "";
    }
    const auto library = forbidden_libraries.find(layer);
    if (library != forbidden_libraries.end() && std::regex_search(include, library->second))
        return "is a library this layer must not know";
    if (layer == "core" && file.ends_with(".h") &&
        std::regex_search(include, source_only_libraries))
        return "is a library for .cpp files only";
    return "";
}

std::vector<std::string> includes_of(const fs::path& file) {
    static const std::regex line_pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    std::vector<std::string> includes;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (std::regex_search(line, match, line_pattern)) includes.push_back(match[1]);
    }
    return includes;
}

TEST(Layers, NoIncludeRunsBackwards) {
    int checked = 0;
    for (const char* layer : {"core", "gpu", "render", "ui", "app", "bench"}) {
        if (!fs::exists(source_root / layer)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(source_root / layer)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp" && extension != ".cu") continue;
            const std::string file = fs::relative(entry.path(), source_root).generic_string();
            for (const std::string& include : includes_of(entry.path())) {
                EXPECT_EQ(objection(file, include), "") << file << " includes " << include;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 100) << "the tree was not found at " << source_root;
}

TEST(Layers, TheCheckItselfObjects) {
    EXPECT_NE(objection("core/flow/a.cpp", "render/scene_view.h"), "");
    EXPECT_NE(objection("core/image/a.cpp", "core/flow/fluid.h"), "");
    EXPECT_NE(objection("core/segmentation/a.cpp", "core/tree/vessel_tree.h"), "");
    EXPECT_NE(objection("core/deform/a.h", "core/tree/vessel_tree.h"), "");
    EXPECT_NE(objection("render/a.cpp", "ui/main_window.h"), "");
    EXPECT_NE(objection("render/a.cpp", "QWidget"), "");
    EXPECT_NE(objection("core/image/volume_reader.h", "itkImage.h"), "");
    EXPECT_NE(objection("core/session/a.cpp", "vtkRenderWindow.h"), "");
    EXPECT_NE(objection("core/cellar/a.cpp", "core/base/error.h"), "");
    EXPECT_NE(objection("core/image/a.cpp", "dcmtk/dcmdata/dctk.h"), "");
    EXPECT_NE(objection("app/verbs/a.cpp", "dcmtk/dcmdata/dctk.h"), "");
    EXPECT_NE(objection("app/verbs/a.cpp", "app/dicom_frames/refusal.h"), "");
    EXPECT_NE(objection("app/dicom_frames/a.cpp", "core/base/error.h"), "");
    EXPECT_NE(objection("app/dicom_segmentation/a.cpp", "app/dicom_frames/refusal.h"), "");
    EXPECT_EQ(objection("app/dicom_frames/a.cpp", "dcmtk/dcmdata/dctk.h"), "");
    for (const char* file : {"core/image/volume_reader.cpp", "app/verbs/a.cpp", "gpu/study/a.cpp"})
        EXPECT_NE(objection(file, "itkImage.h"), "") << file;
    EXPECT_NE(objection("gpu/study/a.cpp", "QString"), "");
    EXPECT_NE(objection("gpu/step/a.cpp", "vtkActor.h"), "");
    EXPECT_NE(objection("gpu/step/a.cpp", "GL/gl.h"), "");
    EXPECT_NE(objection("gpu/kernels/a.h", "Eigen/Core"), "");
    EXPECT_NE(objection("gpu/kernels/a.h", "core/base/small_matrix_eigen.h"), "");
    EXPECT_NE(objection("gpu/step/a.cpp", "cuda_runtime.h"), "");
    EXPECT_NE(objection("gpu/kernels/a.h", "cuda_runtime.h"), "");
    EXPECT_NE(objection("app/verbs/a.cpp", "cuda_runtime.h"), "");
    EXPECT_EQ(objection("gpu/machine/device_machine.cu", "cuda_runtime.h"), "");
    EXPECT_EQ(objection("gpu/step/a.cpp", "core/base/small_matrix_eigen.h"), "");
    EXPECT_EQ(objection("core/image/volume_reader.cpp", "gdcmReader.h"), "");
    EXPECT_EQ(objection("app/verb_render.cpp", "render/scene_view.h"), "");
    EXPECT_EQ(objection("core/scene/world.cpp", "core/flow/fluid.h"), "");
}

// Folders beside each other (rooms, or within a room core/tree/systems) that files lie in, and
// those that they include. Files at the room's root are left out: the smallest of them are used by
// all folders, the largest use all.
using FolderArrows = std::map<std::string, std::set<std::string>>;

FolderArrows arrows_among_folders(const fs::path& layer) {
    FolderArrows arrows;
    for (const auto& entry : fs::recursive_directory_iterator(layer)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp" && extension != ".cu") continue;
        const fs::path from = fs::relative(entry.path(), source_root).parent_path();
        for (const fs::path include : includes_of(entry.path())) {
            const fs::path to = include.parent_path();
            if (to != from && to.has_parent_path() && to.parent_path() == from.parent_path())
                arrows[from.generic_string()].insert(to.generic_string());
        }
    }
    return arrows;
}

// Takes away folders that include none that is left; what remains lies on or behind a circle.
FolderArrows circles_of(FolderArrows arrows) {
    for (bool changed = true; changed;) {
        changed =
            std::erase_if(arrows, [&](const auto& folder) {
                return std::none_of(folder.second.begin(), folder.second.end(),
                                    [&](const std::string& to) { return arrows.contains(to); });
            }) > 0;
    }
    return arrows;
}

TEST(Layers, FoldersOfARoomDoNotIncludeEachOtherInACircle) {
    for (const char* layer : {"core", "gpu", "render"})
        for (const auto& [folder, includes] : circles_of(arrows_among_folders(source_root / layer)))
            for (const std::string& include : includes)
                ADD_FAILURE() << folder << " and " << include << " include each other in a circle";
    EXPECT_TRUE(arrows_among_folders(source_root / "core").contains("core/tree/systems"));
    EXPECT_EQ(circles_of({{"a", {"b"}}, {"b", {"c"}}}).size(), 0u);
    EXPECT_EQ(circles_of({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}).size(), 3u);
}

TEST(Layers, EveryFileNamesItsLicence) {
    for (const char* layer : {"core", "gpu", "render", "ui", "app", "bench", "tests", "cmake"}) {
        if (!fs::exists(source_root / layer)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(source_root / layer)) {
            const std::string name = entry.path().filename().string();
            if (!(name.ends_with(".h") || name.ends_with(".cpp") || name.ends_with(".cu") ||
                  name.ends_with(".cmake") || name == "CMakeLists.txt"))
                continue;
            std::string first;
            std::ifstream in(entry.path());
            std::getline(in, first);
            EXPECT_NE(first.find("SPDX-License-Identifier: GPL-3.0-or-later"), std::string::npos)
                << entry.path();
        }
    }
}

}  // namespace
