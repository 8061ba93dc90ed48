// SPDX-License-Identifier: GPL-3.0-or-later
// A deformable body as the scene describes it (BodyDescription) and as the solver sees it (Body):
// nodes with lumped masses and elements with their rest shapes. Linear or quadratic tetrahedra,
// springs, hexahedra.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vector.h"
#include "core/deform/body/material.h"
#include "core/deform/body/obstacles.h"
#include "core/deform/elements/hexahedron_element.h"
#include "core/deform/elements/spring_element.h"
#include "core/deform/elements/tetrahedron_element.h"
#include "core/deform/solvers/coarse_skeleton.h"
#include "core/mesh/tet_mesh.h"
#include "core/tear/tear_law.h"

namespace hepatica {

// The pad between two surfaces of a body, or between the body and obstacles, in units of the body's
// own size and stiffness; see SurfacePairs.
struct SelfPad {
    double thickness_edges = 0.1;  // in mean edge lengths at rest, > 0
    double pressure_moduli = 2.0;  // pressure at half thickness, in Young's moduli, > 0
    double friction = 0.0;         // Coulomb's coefficient between the body's surfaces, >= 0
};

// Everything that a scene says about a body. build_body() refuses sizes that do not fit and values
// out of range with InputError.
struct BodyDescription {
    TetMesh mesh;  // the shape at rest; hexahedra use its vertices too
    std::vector<std::array<int, 8>>
        hexahedra;  // corners as in HexMesh; ElementModel::corotated only
    Material material;
    std::vector<std::uint8_t> fixed;  // per vertex, nonzero: never moves. Empty: none fixed
    // Multiples of the material's modulus and density, per element (tetrahedra, then hexahedra),
    // each > 0. Empty: 1.
    std::vector<double> stiffness_factor;
    std::vector<double> density_factor;
    // Stiffness, per volume, of the surrounding tissue that pulls back to the rest position:
    // Pa/mm2. 0: none.
    double tether_pa_per_mm2 = 0.0;
    CoarseSkeleton skeleton;        // may be empty
    bool touchable = false;         // tools may touch it; where false, no surface is built for them
    std::optional<SelfPad> self{};  // its surfaces touch each other; empty: they do not
    std::optional<TearLaw> tear{};  // it tears; empty: it does not. Linear tetrahedra only
    std::shared_ptr<const Obstacles> obstacles{};  // that it touches; null: none
};

// Order of the shape functions of tetrahedra: linear with 4 nodes, quadratic with 10.
enum class ElementOrder { linear, quadratic };

// Scales each tetrahedron's stiffness so that the solid tube bends like a hollow one with a wall of
// thickness t: by 1 - ((r - t)/r)^4, where r is the radius of the nearest skeleton node (by 1 where
// t >= r). The lumen keeps its mass. Meant for elements that are too coarse for the wall. Throws
// InputError for a thickness that is not finite and greater than 0, or an empty skeleton. Costs
// elements times skeleton nodes.
void make_hollow(BodyDescription& body, double wall_thickness_mm);

// Elements of one kind; connectivity holds nodes_per_element indices each.
struct ElementGroup {
    enum class Kind { linear_tetrahedron, quadratic_tetrahedron, spring, hexahedron };
    Kind kind = Kind::linear_tetrahedron;
    int nodes_per_element = 4;
    std::vector<int> connectivity;
    std::vector<small::TetrahedronRest<double>> tetrahedra;  // one of these three is filled
    std::vector<small::SpringRest<double>> springs;
    std::vector<small::HexahedronRest<double>> hexahedra;

    int size() const { return static_cast<int>(connectivity.size()) / nodes_per_element; }
    int pairs() const { return nodes_per_element * (nodes_per_element - 1) / 2; }
};

// The body as the solver sees it. The first nodes are the vertices of the mesh; the mid-edge nodes
// of quadratic tetrahedra follow.
struct Body {
    ElementModel model = ElementModel::corotated;
    std::vector<Vec3> rest_positions_mm;
    std::vector<std::array<int, 2>> edge_of_middle_node;  // of node vertex_count + i
    int vertex_count = 0;
    std::vector<double> mass_g;  // > 0
    std::vector<std::uint8_t> fixed;
    std::vector<double> tether_un_per_mm;
    std::vector<ElementGroup> groups;
    RayleighDamping damping;
    std::vector<std::array<int, 3>>
        surface;  // counter-clockwise seen from outside; empty: not touchable
    struct Pad {
        double thickness_mm = 0.0, pressure_pa = 0.0, friction = 0.0;
    };
    std::optional<Pad> self_pad;                   // between its own surfaces
    std::shared_ptr<const Obstacles> obstacles{};  // that it touches; null: none
    Pad obstacle_pad{};                            // between it and the obstacles
    std::vector<std::array<int, 3>>
        touching_surface;  // like `surface`; filled if it touches itself or obstacles
    bool tears = false;
    // Ascending pairs of nodes that were one node before the body tore there. Each has a block in
    // the matrix, beside those of the elements.
    std::vector<std::array<int, 2>> parted_pairs;
    double mean_edge_mm = 0.0;  // of the elements at rest; tolerances are relative to it

    int node_count() const { return static_cast<int>(rest_positions_mm.size()); }
};

// Throws InputError: a flat, inverted or folded element, a vertex that belongs to no element, a
// size or value that does not fit, hexahedra or quadratic order with a model that does not have
// them.
void validate(const BodyDescription& description, ElementModel model, ElementOrder order);

// Calls validate() first and throws what it throws.
Body build_body(const BodyDescription& description, ElementModel model, ElementOrder order);

}  // namespace hepatica
