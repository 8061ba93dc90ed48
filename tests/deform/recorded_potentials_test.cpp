// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of what acts on a body as they are today: energies, forces, stiffness and products of
// weight, tissue, grabs, a tool with friction and surfaces that touch; how far all may move; and
// where a tool gets to.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/disjoint_sets.h"
#include "core/base/frame_time.h"
#include "core/deform/potentials/potential.h"
#include "core/deform/potentials/potential_list.h"
#include "core/deform/step/assembly.h"
#include "tests/deform/support/random_field.h"
#include "tests/deform/support/step_figures.h"
#include "tests/deform/support/tool_oracles.h"
#include "tests/deform/support/two_bars.h"

namespace hepatica {
namespace {

using test::expect_recorded;
using test::Figures;
using test::flat;
using test::random_field;

void add_list(Figures& figures, const std::string& name, const PotentialList& list,
              const Body& body, std::span<const Vec3> x, const BlockMatrix& pattern) {
    const std::size_t nodes = x.size();
    const auto d = random_field(nodes, 1.0, 101);
    std::vector<Vec3> force(nodes, Vec3::Zero()), product = force, coupling = force;
    BlockMatrix stiffness = pattern;
    std::ranges::fill(stiffness.block, Mat3::Zero());
    figures.add(name + ".energy", list.energy(x, body.rest_positions_mm));
    list.add_forces(x, force);
    list.add_stiffness(x, 0.7, stiffness);
    list.add_product(x, 0.7, d, pattern, product);
    if (list.coupled(x)) list.add_coupling(x, 0.7, d, coupling);
    figures.add(name + ".force", flat(force))
        .add(name + ".stiffness", flat(stiffness))
        .add(name + ".product", flat(product))
        .add(name + ".coupling", flat(coupling));
    std::vector<int> pieces(nodes);
    for (std::size_t i = 0; i < nodes; ++i) pieces[i] = static_cast<int>(i % 3);
    std::vector<double> by_piece(3, 0.0), marks;
    std::vector<char> held(nodes, 0);
    for (const auto& potential : list.all()) {
        potential->add_energy_by_piece(x, body.rest_positions_mm, pieces, by_piece);
        potential->mark_held(x, held);
    }
    EnergyLedger ledger;
    const double sum = list.book(x, body.rest_positions_mm, ledger);
    figures.add(name + ".pieces", by_piece).add(name + ".held", test::as_doubles(held));
    figures.add(name + ".booked", std::vector{sum, ledger.grab, ledger.tether, ledger.contact,
                                              ledger.gravity_work, ledger.friction_loss});
    for (const double size : {0.05, 0.4}) {
        std::vector<Vec3> to = test::copy_of(x);
        const auto motion = random_field(nodes, size, 103);
        for (std::size_t i = 0; i < nodes; ++i) to[i] += motion[i];
        const std::string moved = name + (size < 0.1 ? ".near" : ".far");
        figures.add(moved + ".free", list.free_share(x, to));
        figures.add(moved + ".touch", list.share_until_touch(x, to));
    }
}

BlockMatrix pattern_of(const Body& body) {
    Assembly assembly(body);
    assembly.evaluate(body.rest_positions_mm);
    BlockMatrix pattern;
    assembly.gather_stiffness(1.0, pattern);
    return pattern;
}

Tool pressing_jaws() {
    Tool tool;
    for (const double side : {-0.5, 0.5})
        tool.parts.push_back({.shape = {.centre_mm = Vec3(31, 3.2, 3) + side * 8.5 * Vec3::UnitZ(),
                                        .half_axis_mm = Vec3(0.7, 3, 0.05),
                                        .radius_mm = 1.0 + 0.1 * side},
                              .opens = side * Vec3::UnitZ(),
                              .led_by_mm = Vec3(0.05, 0.02, -0.1 * side),
                              .led_half_axis_mm = Vec3(0.01, 0.0, 0.02)});
    tool.opening_mm = tool.opening_target_mm = 6.5;
    tool.target_mm = tool.centre_mm();
    tool.pad_mm = 0.5;
    tool.pressure_pa = 1e5;
    tool.friction = 0.4;
    tool.led_over_s = frame_s;
    return tool;
}

TEST(PotentialFigures, OfWhatActsFromOutside) {
    BodyDescription description = test::bar();
    description.tether_pa_per_mm2 = 20.0;
    const Body body = build_body(description, ElementModel::corotated, ElementOrder::linear);
    PotentialList list(body);
    list.set_gravity(Vec3(200, -9000, 500));
    list.set_tool(pressing_jaws());
    Grab grabs[2];
    grabs[0] = {{40, 41, 62, 100}, {0.4, 0.3, 0.2, 0.1}, Vec3(33, 8, 1), 500.0, 800.0};
    grabs[1] = {{70, 71, -1, -1}, {0.4, 0.6, 0.0, 0.0}, Vec3(9, 3, 1), 50.0, 8000.0};
    list.set_grabs(grabs);
    BodyState start{body.rest_positions_mm, random_field(body.mass_g.size(), 5.0, 105)};
    std::vector<Vec3> x = start.positions_mm;
    const auto shake = random_field(x.size(), 0.01, 107);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += shake[i];
    const BlockMatrix pattern = pattern_of(body);
    Figures figures;
    add_list(figures, "still", list, body, x, pattern);
    std::vector<std::uint8_t> held(body.fixed);
    held[31] = held[115] = 1;
    list.begin_step(start, frame_s, held);
    add_list(figures, "step", list, body, x, pattern);
    const ToolLoad load = list.tool_load(x);
    figures.add("load", flat(std::vector{load.force_un, load.torque_un_mm, load.at_mm}));
    figures.add("grip", load.grip_un).add("contacts", load.contacts).add("gap", load.least_gap_mm);
    figures.add("touched", test::as_doubles(load.touched));
    list.end_step();
    expect_recorded("deform", "potentials", figures);
}

TEST(PotentialFigures, OfSurfacesAmongEachOther) {
    for (const double gap : {0.05, 0.15}) {
        const Body body =
            build_body(test::crossed_bars(gap, 1.1), ElementModel::corotated, ElementOrder::linear);
        PotentialList list(body);
        const BodyState start{body.rest_positions_mm, random_field(body.mass_g.size(), 5.0, 109)};
        const BlockMatrix pattern = pattern_of(body);
        std::vector<std::uint8_t> held(start.positions_mm.size(), 0);
        held[30] = held[140] = 1;
        list.begin_step(start, frame_s, held);
        Figures figures;
        add_list(figures, "step", list, body, start.positions_mm, pattern);
        list.end_step();
        add_list(figures, "still", list, body, start.positions_mm, pattern);
        expect_recorded("deform", gap < 0.1 ? "surfaces_near" : "surfaces", figures);
    }
}

// Past and into a bar that stands still, in several parts of its way, against a limit of force.
TEST(PotentialFigures, OfAToolThatIsLed) {
    const Body body = build_body(test::bar(), ElementModel::corotated, ElementOrder::linear);
    std::vector<double> places;
    for (const double limit : {1e3, 1e9})
        for (int way = 0; way < 8; ++way) {
            PotentialList list(body);
            Tool tool = pressing_jaws();
            tool.force_limit_un = limit;
            tool.target_mm += 0.7 * Vec3(way % 2 == 0 ? 2 : -1, way % 3 - 1.0, way % 4 - 1.5);
            tool.turn_rad = 0.2 * Vec3(way % 3 - 1.0, 0.5 * (way % 2), way % 4 - 1.0);
            tool.opening_target_mm = 5.0 + 0.5 * way;
            list.set_tool(tool);
            for (const double share : {0.3, 1.0}) {
                places.push_back(list.lead_tool(body.rest_positions_mm, share, frame_s));
                for (const ToolPart& part : list.tool()->parts) {
                    test::append(places, part.shape.centre_mm);
                    test::append(places, part.shape.half_axis_mm);
                    test::append(places, part.opens);
                    test::append(places, part.led_by_mm);
                }
                test::append(places, list.tool()->turn_rad);
                places.push_back(list.tool()->opening_mm);
                places.push_back(list.tool()->speed_mm_per_s());
                places.push_back(list.tool()->reach_mm());
                places.push_back(list.free_of_tool(body.rest_positions_mm));
                const auto near = list.vertices_near_tool(body.rest_positions_mm);
                places.push_back(static_cast<double>(near.size()));
            }
        }
    expect_recorded("deform", "led_tools", Figures().add("places", places));
}

}  // namespace
}  // namespace hepatica
