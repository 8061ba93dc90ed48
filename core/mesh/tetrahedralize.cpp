// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes each connected component in parallel and orders the result along the vessels.
#include "core/mesh/tetrahedralize.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <string>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/mesh/attempt_sizes.h"
#include "core/mesh/manifold_attempts.h"
#include "core/mesh/refinement.h"
#include "core/mesh/tube_field.h"

namespace hepatica {

namespace {

constexpr double calls_per_radius_of_length = 2000.0;
constexpr double longest_in_radii = 1e6;  // about 1e7 tetrahedra; a liver's vessels have 1e4 radii
constexpr int most_counting_passes = 3;   // to find the sizes that give a number of tetrahedra
constexpr double widest_minimum_mm = 50.0;  // of the least radius; wider than any vessel

// Segments connected through nodes, links of loops included; sorted by smallest id.
std::vector<std::vector<int>> connected_components(const VesselTree& tree) {
    DisjointSets nodes(tree.nodes.size());
    for (const VesselSegment& segment : tree.segments)
        nodes.unite(static_cast<std::uint32_t>(segment.proximal_node),
                    static_cast<std::uint32_t>(segment.distal_node));
    std::map<std::uint32_t, std::size_t> number;
    std::vector<std::vector<int>> components;
    for (std::size_t s = 0; s < tree.segments.size(); ++s) {
        const auto [entry, added] = number.try_emplace(
            nodes.root(static_cast<std::uint32_t>(tree.segments[s].proximal_node)),
            components.size());
        if (added) components.emplace_back();
        components[entry->second].push_back(static_cast<int>(s));
    }
    return components;
}

void append(TetMesh& whole, const TetMesh& part) {
    const int first = static_cast<int>(whole.vertices_mm.size());
    whole.vertices_mm.insert(whole.vertices_mm.end(), part.vertices_mm.begin(),
                             part.vertices_mm.end());
    for (const auto& [a, b, c, d] : part.tetrahedra)
        whole.tetrahedra.push_back({first + a, first + b, first + c, first + d});
}

// Each piece of centreline in radii of its thinner end.
double length_in_radii(const VesselTree& tree, const MeshOptions& options) {
    double radii = 0.0;
    for (const VesselSegment& segment : tree.segments)
        for (std::size_t i = 1; i < segment.points_mm.size(); ++i) {
            const double thinner = std::min(segment.radii_mm[i - 1], segment.radii_mm[i]);
            radii += (segment.points_mm[i] - segment.points_mm[i - 1]).norm() /
                     std::max(thinner, options.minimum_radius_mm);
        }
    return radii;
}

void check(const VesselTree& tree, const MeshOptions& options) {
    if (tree.segments.empty())
        throw InputError("the vessel tree has no segments", "",
                         "Lower the window of intensities or give a vessel mask");
    validate(tree);
    if (!(options.minimum_radius_mm >= 0.0 && options.minimum_radius_mm <= widest_minimum_mm))
        throw InputError("a least radius of " + number_text(options.minimum_radius_mm) + " mm",
                         "mesh options", "Choose a least radius from 0 to 50 mm");
    if (!(length_in_radii(tree, options) <= longest_in_radii))
        throw InputError("the vessels are " + number_text(length_in_radii(tree, options)) +
                             " radii long, too thin for tetrahedra",
                         "mesh options",
                         "Check the unit of the radii (millimetres), or set a least radius");
    for (const double size : {options.facet_size_in_radii, options.cell_size_in_radii})
        if (!(size >= finest_in_radii && size <= coarsest_in_radii))
            throw InputError("an element size of " + number_text(size) + " radii", "mesh options",
                             "Choose a size from 0.3 to 1 radius");
}

// A rough estimate of the number of distance evaluations, for the progress.
double expected_calls(const VesselTree& tree, const MeshOptions& options) {
    return calls_per_radius_of_length * length_in_radii(tree, options) /
           (options.facet_size_in_radii * options.facet_size_in_radii);
}

// Sorts vertices along the vessels from the root, so that neighbours in space are neighbours in
// memory.
void sort_along(const TubeField& field, TetMesh& mesh, const std::function<void(int)>& on_calls) {
    std::vector<double> position(mesh.vertices_mm.size());
    for (std::size_t v = 0; v < position.size(); ++v) {
        if (v % 256 == 0) on_calls(0);
        position[v] = field.position_along(mesh.vertices_mm[v]);
    }
    on_calls(0);
    std::vector<int> order(position.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int v) { return position[v]; });
    std::vector<Vec3> vertices(order.size());
    std::vector<int> number(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        vertices[i] = mesh.vertices_mm[order[i]];
        number[order[i]] = static_cast<int>(i);
    }
    mesh.vertices_mm = std::move(vertices);
    for (auto& tetrahedron : mesh.tetrahedra)
        for (int& vertex : tetrahedron) vertex = number[vertex];
    std::ranges::stable_sort(mesh.tetrahedra, {},
                             [](const auto& t) { return *std::ranges::min_element(t); });
}

// Every attempt has a field of its own, widened for its element size.
ManifoldMesh mesh_component(const VesselTree& tree, const std::vector<int>& segments,
                            const MeshOptions& options, const std::function<void(int)>& on_calls) {
    return first_manifold([&](double scale) {
        const AttemptSizes sizes =
            attempt_sizes(options.facet_size_in_radii, options.cell_size_in_radii, scale);
        TubeFieldOptions field_options;
        field_options.radius_factor = sizes.radius_factor;
        field_options.minimum_radius_mm = options.minimum_radius_mm;
        const TubeField field(tree, segments, field_options);
        TetMesh mesh = refine_tetrahedra(
            field, {sizes.facet_in_radii, sizes.cell_in_radii, options.optimise}, on_calls);
        on_calls(0);
        sort_along(field, mesh, on_calls);
        return mesh;
    });
}

struct WholeMesh {
    TetMesh mesh;
    int unclosed = 0;  // components whose boundary is not a closed manifold
};

// Scales the sizes within their range; false where they are at its end and nothing changes.
bool rescale(MeshOptions& options, double scale) {
    bool changed = false;
    for (double* size : {&options.facet_size_in_radii, &options.cell_size_in_radii}) {
        const double before = *size;
        *size = std::clamp(before * scale, finest_in_radii, coarsest_in_radii);
        changed = changed || *size != before;
    }
    return changed;
}

// The progress before and after one of several passes.
struct Part {
    double from = 0.0, to = 1.0;
};

WholeMesh mesh_once(const VesselTree& tree, const std::vector<std::vector<int>>& components,
                    const MeshOptions& options, const Part& part_of_all, Job& job) {
    std::vector<ManifoldMesh> parts(components.size());
    const double all_calls = expected_calls(tree, options);
    std::atomic<double> calls = 0.0;
    const auto on_calls = [&](int more) {
        const double done = std::min(0.99, calls.fetch_add(more) / all_calls);
        job.advance(part_of_all.from + (part_of_all.to - part_of_all.from) * done);
    };
    parallel_blocks(components.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            parts[i] = mesh_component(tree, components[i], options, on_calls);
    });
    WholeMesh whole;
    for (const ManifoldMesh& part : parts) {
        append(whole.mesh, part.mesh);
        whole.unclosed += part.is_manifold ? 0 : 1;
    }
    return whole;
}

}  // namespace

TetMesh tetrahedralize(const VesselTree& tree, const MeshOptions& options, Job& job,
                       std::vector<std::string>* warnings) {
    check(tree, options);
    const std::vector<std::vector<int>> components = connected_components(tree);
    MeshOptions sized = options;
    double done = 0.0;
    // Few passes suffice, because the number of tetrahedra is about a power of the size.
    for (int pass = 0; options.target_tetrahedra > 0 && pass < most_counting_passes; ++pass) {
        sized.optimise = false;
        const double next = (pass + 1.0) / (most_counting_passes + 1.0);
        const std::size_t count =
            mesh_once(tree, components, sized, {done, next}, job).mesh.tetrahedra.size();
        done = next;
        const double ratio =
            static_cast<double>(count) / static_cast<double>(options.target_tetrahedra);
        if ((ratio > 0.85 && ratio < 1.15) || !rescale(sized, std::pow(ratio, 1.0 / 3.0))) break;
    }
    sized.optimise = options.optimise;
    WholeMesh whole = mesh_once(tree, components, sized, {done, 1.0}, job);
    job.throw_if_cancelled();
    validate(whole.mesh);
    report_unclosed(whole.unclosed, static_cast<int>(components.size()), warnings);
    return std::move(whole.mesh);
}

}  // namespace hepatica
