// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/body/body.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/small_matrix_eigen.h"
#include "core/mesh/hex_mesh.h"

namespace hepatica {
namespace {

constexpr int max_nodes = 10;

[[noreturn]] void reject(const std::string& problem, const std::string& place,
                         const std::string& remedy) {
    throw InputError(problem, place, remedy);
}

void check_factors(const std::vector<double>& factor, std::size_t elements, const char* name) {
    if (factor.empty()) return;
    if (factor.size() != elements)
        reject(
            std::to_string(factor.size()) + " values for " + std::to_string(elements) + " elements",
            name, "Give one value per element or none");
    for (std::size_t e = 0; e < elements; ++e)
        if (!(factor[e] > 0.0) || !std::isfinite(factor[e]))
            reject("is " + number_text(factor[e]),
                   std::string(name) + " of element " + std::to_string(e),
                   "Give a finite value greater than 0");
}

void check_hexahedra(const BodyDescription& d) {
    const int vertices = static_cast<int>(d.mesh.vertices_mm.size());
    for (std::size_t e = 0; e < d.hexahedra.size(); ++e) {
        const std::string place = "hexahedron " + std::to_string(e);
        small::Vector3<double> x[8];
        for (int a = 0; a < 8; ++a) {
            const int v = d.hexahedra[e][a];
            if (v < 0 || v >= vertices)
                reject("names vertex " + std::to_string(v) + ", which does not exist", place,
                       "Make the mesh again");
            x[a] = small::from_eigen(d.mesh.vertices_mm[v]);
        }
        if (!(small::least_jacobian(x) > 0.0))
            reject("is flat or folded", place, "Make the mesh again with better shaped cells");
    }
}

void check_every_vertex_is_used(const BodyDescription& d) {
    std::vector<char> used(d.mesh.vertices_mm.size(), false);
    for (const auto& nodes : d.mesh.tetrahedra)
        for (const int v : nodes) used[v] = true;
    for (const auto& nodes : d.hexahedra)
        for (const int v : nodes) used[v] = true;
    const auto lonely = std::ranges::find(used, false);
    if (lonely != used.end())
        reject("belongs to no element", "vertex " + std::to_string(lonely - used.begin()),
               "Remove it from the mesh");
}

void check_pad(const SelfPad& pad) {
    const auto check_size = [](double value, const char* name) {
        if (!(value > 0.0 && std::isfinite(value)))
            reject("is " + number_text(value), name, "Give more than 0");
    };
    check_size(pad.thickness_edges, "thickness");
    check_size(pad.pressure_moduli, "pressure");
    if (!(pad.friction >= 0.0 && std::isfinite(pad.friction)))
        reject("is " + number_text(pad.friction), "friction", "Give 0 or more");
}

}  // namespace

void validate(const BodyDescription& d, ElementModel model, ElementOrder order) {
    validate(d.material);
    validate(d.mesh);
    check_hexahedra(d);
    const std::size_t vertices = d.mesh.vertices_mm.size();
    const std::size_t elements = d.mesh.tetrahedra.size() + d.hexahedra.size();
    if (elements == 0)
        reject("has no element", "the body", "Give it at least one tetrahedron or hexahedron");
    if (!d.hexahedra.empty() && model != ElementModel::corotated)
        reject("hexahedra exist for the corotated model only", "the body",
               "Choose the corotated model or a mesh of tetrahedra");
    if (order == ElementOrder::quadratic && (model == ElementModel::spring || !d.hexahedra.empty()))
        reject("there is no quadratic form of springs or hexahedra", "the body",
               "Choose linear order, or tetrahedra of the corotated or neohookean model");
    if (d.obstacles) validate(*d.obstacles);
    if (d.self) check_pad(*d.self);
    if (d.tear) {
        validate(*d.tear);
        if (order == ElementOrder::quadratic || !d.hexahedra.empty())
            reject("only linear tetrahedra tear", "the body",
                   "Choose linear order, or a scene that does not tear");
    }
    if (!d.fixed.empty() && d.fixed.size() != vertices)
        reject(
            std::to_string(d.fixed.size()) + " flags for " + std::to_string(vertices) + " vertices",
            "fixed", "Give one flag per vertex or none");
    if (!(d.tether_pa_per_mm2 >= 0.0) || !std::isfinite(d.tether_pa_per_mm2))
        reject("is " + number_text(d.tether_pa_per_mm2), "tether [Pa/mm2]",
               "Give a finite value of 0 or more");
    check_factors(d.stiffness_factor, elements, "stiffness factor");
    check_factors(d.density_factor, elements, "density factor");
    check_every_vertex_is_used(d);
}

namespace {

// Middle nodes are sorted by the corners of their edges, so that their numbers do not depend on the
// order of the elements.
void add_middle_nodes(const TetMesh& mesh, Body& body) {
    auto& edges = body.edge_of_middle_node;
    edges.reserve(6 * mesh.tetrahedra.size());
    for (const auto& t : mesh.tetrahedra)
        for (int e = 0; e < 6; ++e) {
            int a = 0, b = 0;
            small::edge_corners(e, a, b);
            edges.push_back({std::min(t[a], t[b]), std::max(t[a], t[b])});
        }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges)
        body.rest_positions_mm.push_back(0.5 *
                                         (body.rest_positions_mm[a] + body.rest_positions_mm[b]));
}

int middle_node(const Body& body, int a, int b) {
    const std::array<int, 2> edge{std::min(a, b), std::max(a, b)};
    const auto& edges = body.edge_of_middle_node;
    return body.vertex_count +
           static_cast<int>(std::ranges::lower_bound(edges, edge) - edges.begin());
}

struct ElementValues {
    double lambda_pa;
    double mu_pa;
    double density_g_mm3;
};

ElementValues values_of(const BodyDescription& d, std::size_t element) {
    const Lame lame = lame_of(d.material);
    const double stiffness = d.stiffness_factor.empty() ? 1.0 : d.stiffness_factor[element];
    const double density = d.density_factor.empty() ? 1.0 : d.density_factor[element];
    return {stiffness * lame.lambda_pa, stiffness * lame.mu_pa, density * d.material.density_g_mm3};
}

// Adds each node's share of an element's volume to its mass and to its tether stiffness.
void add_lumps(const BodyDescription& d, Body& body, const int* nodes, int count, double volume,
               double density, const double* share) {
    for (int a = 0; a < count; ++a) {
        body.mass_g[nodes[a]] += density * volume * share[a];
        body.tether_un_per_mm[nodes[a]] += d.tether_pa_per_mm2 * volume * share[a];
    }
}

void add_tetrahedra(const BodyDescription& d, ElementOrder order, Body& body) {
    if (d.mesh.tetrahedra.empty()) return;
    ElementGroup group;
    const bool quadratic = order == ElementOrder::quadratic;
    group.kind = quadratic                            ? ElementGroup::Kind::quadratic_tetrahedron
                 : body.model == ElementModel::spring ? ElementGroup::Kind::spring
                                                      : ElementGroup::Kind::linear_tetrahedron;
    group.nodes_per_element = quadratic ? 10 : 4;
    group.connectivity.reserve(d.mesh.tetrahedra.size() * group.nodes_per_element);
    if (group.kind == ElementGroup::Kind::spring)
        group.springs.reserve(d.mesh.tetrahedra.size());
    else
        group.tetrahedra.reserve(d.mesh.tetrahedra.size());
    // Quadratic: shares of the consistent mass's diagonal (Hinton, Rock and Zienkiewicz 1976). They
    // are all positive; row sums would be negative at the corners.
    double share[max_nodes];
    for (int a = 0; a < max_nodes; ++a)
        share[a] = quadratic ? (a < 4 ? 1.0 / 36.0 : 4.0 / 27.0) : 0.25;
    for (std::size_t e = 0; e < d.mesh.tetrahedra.size(); ++e) {
        const auto& t = d.mesh.tetrahedra[e];
        int nodes[max_nodes] = {t[0], t[1], t[2], t[3]};
        small::Vector3<double> x[4];
        for (int a = 0; a < 4; ++a) x[a] = small::from_eigen(d.mesh.vertices_mm[t[a]]);
        for (int edge = 0; quadratic && edge < 6; ++edge) {
            int a = 0, b = 0;
            small::edge_corners(edge, a, b);
            nodes[4 + edge] = middle_node(body, t[a], t[b]);
        }
        group.connectivity.insert(group.connectivity.end(), nodes, nodes + group.nodes_per_element);
        const ElementValues v = values_of(d, e);
        const auto rest = small::tetrahedron_rest(x[0], x[1], x[2], x[3], v.lambda_pa, v.mu_pa);
        if (group.kind == ElementGroup::Kind::spring)
            group.springs.push_back(small::spring_rest(x, v.lambda_pa, v.mu_pa));
        else
            group.tetrahedra.push_back(rest);
        add_lumps(d, body, nodes, group.nodes_per_element, rest.volume, v.density_g_mm3, share);
    }
    body.groups.push_back(std::move(group));
}

void add_hexahedra(const BodyDescription& d, Body& body) {
    if (d.hexahedra.empty()) return;
    ElementGroup group;
    group.kind = ElementGroup::Kind::hexahedron;
    group.nodes_per_element = 8;
    group.hexahedra.resize(d.hexahedra.size());
    for (std::size_t e = 0; e < d.hexahedra.size(); ++e) {
        const auto& nodes = d.hexahedra[e];
        group.connectivity.insert(group.connectivity.end(), nodes.begin(), nodes.end());
        small::Vector3<double> x[8];
        for (int a = 0; a < 8; ++a) x[a] = small::from_eigen(d.mesh.vertices_mm[nodes[a]]);
        const ElementValues v = values_of(d, d.mesh.tetrahedra.size() + e);
        auto& rest = group.hexahedra[e];
        small::hexahedron_rest(x, v.lambda_pa, v.mu_pa, rest);
        add_lumps(d, body, nodes.data(), 8, rest.volume, v.density_g_mm3, rest.mass_share);
    }
    body.groups.push_back(std::move(group));
}

std::vector<std::array<int, 3>> surface_of_elements(const BodyDescription& d) {
    TetMesh mesh = d.mesh;
    const auto cut = cut_into_tetrahedra(d.hexahedra);
    mesh.tetrahedra.insert(mesh.tetrahedra.end(), cut.begin(), cut.end());
    return boundary_triangles(mesh);
}

double mean_edge(const Body& body) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const ElementGroup& group : body.groups) {
        const int corners = group.kind == ElementGroup::Kind::hexahedron ? 8 : 4;
        for (int e = 0; e < group.size(); ++e) {
            const int* nodes = group.connectivity.data() + e * group.nodes_per_element;
            for (int a = 1; a < corners; ++a, ++count)
                sum += (body.rest_positions_mm[nodes[a]] - body.rest_positions_mm[nodes[0]]).norm();
        }
    }
    return sum / static_cast<double>(count);
}

}  // namespace

Body build_body(const BodyDescription& description, ElementModel model, ElementOrder order) {
    validate(description, model, order);
    Body body;
    body.model = model;
    body.rest_positions_mm = description.mesh.vertices_mm;
    body.vertex_count = body.node_count();
    if (order == ElementOrder::quadratic) add_middle_nodes(description.mesh, body);
    body.mass_g.assign(body.node_count(), 0.0);
    body.tether_un_per_mm.assign(body.node_count(), 0.0);
    add_tetrahedra(description, order, body);
    add_hexahedra(description, body);
    body.fixed.assign(body.node_count(), 0);
    for (std::size_t v = 0; v < description.fixed.size(); ++v)
        body.fixed[v] = description.fixed[v] != 0;
    for (std::size_t m = 0; m < body.edge_of_middle_node.size(); ++m) {
        const auto& [a, b] = body.edge_of_middle_node[m];
        body.fixed[body.vertex_count + m] = body.fixed[a] && body.fixed[b];
    }
    body.damping = rayleigh_of(description.material);
    body.mean_edge_mm = mean_edge(body);
    body.tears = description.tear.has_value();
    if (description.touchable) body.surface = surface_of_elements(description);
    const auto pad_of = [&](const SelfPad& pad) {
        return Body::Pad{pad.thickness_edges * body.mean_edge_mm,
                         pad.pressure_moduli * description.material.young_modulus_pa, pad.friction};
    };
    if (description.self) body.self_pad = pad_of(*description.self);
    body.obstacles = description.obstacles;
    if (body.obstacles) body.obstacle_pad = pad_of(description.self.value_or(SelfPad{}));
    if (body.self_pad || body.obstacles) body.touching_surface = surface_of_elements(description);
    return body;
}

void make_hollow(BodyDescription& body, double wall_thickness_mm) {
    if (!(wall_thickness_mm > 0.0) || !std::isfinite(wall_thickness_mm))
        reject("is " + number_text(wall_thickness_mm), "wall thickness [mm]",
               "Give a finite value greater than 0");
    const CoarseSkeleton& skeleton = body.skeleton;
    if (skeleton.positions_mm.empty())
        reject("has no skeleton", "the body", "A hollow wall needs the radii along the centreline");
    body.stiffness_factor.resize(body.mesh.tetrahedra.size() + body.hexahedra.size(), 1.0);
    for (std::size_t e = 0; e < body.mesh.tetrahedra.size(); ++e) {
        Vec3 centre = Vec3::Zero();
        for (const int v : body.mesh.tetrahedra[e]) centre += 0.25 * body.mesh.vertices_mm[v];
        const auto nearest = std::ranges::min_element(
            skeleton.positions_mm, {}, [&](const Vec3& p) { return (p - centre).squaredNorm(); });
        const double radius = skeleton.radii_mm[nearest - skeleton.positions_mm.begin()];
        const double lumen = std::max(0.0, 1.0 - wall_thickness_mm / radius);
        body.stiffness_factor[e] *= 1.0 - lumen * lumen * lumen * lumen;
    }
}

}  // namespace hepatica
