// SPDX-License-Identifier: GPL-3.0-or-later
// What a trial has to notice: bodies that are inverted, whatever they are made of.
#include "core/study/trial.h"

#include <gtest/gtest.h>

#include "core/deform/stepper/cpu_stepper.h"
#include "core/mesh/brick_mesh.h"

namespace hepatica {
namespace {

struct Kind {
    ElementModel model;
    ElementOrder order;
    bool hexahedra;
};

BodyDescription brick(const Kind& kind) {
    BodyDescription body;
    if (!kind.hexahedra) {
        body.mesh = kuhn_brick(Vec3(20, 10, 10), {2, 1, 1});
        return body;
    }
    const HexMesh mesh = hexahedral_brick(Vec3(20, 10, 10), {2, 1, 1});
    body.mesh.vertices_mm = mesh.vertices_mm;
    body.hexahedra = mesh.hexahedra;
    return body;
}

TEST(Trial, NoticesAnInvertedElementOfEveryKind) {
    for (const Kind& kind : {Kind{ElementModel::corotated, ElementOrder::linear, false},
                             Kind{ElementModel::neohookean, ElementOrder::quadratic, false},
                             Kind{ElementModel::corotated, ElementOrder::linear, true}}) {
        const BodyDescription body = brick(kind);
        const auto stepper = make_cpu_stepper(body, {.model = kind.model, .order = kind.order});
        ExtremeRow row;
        Trial trial(*stepper, row, {});
        EXPECT_TRUE(trial.require_positive_volumes(body, kind.model, kind.order)) << row.note;
        std::vector<Vec3> x = body.mesh.vertices_mm;
        x.back() -= Vec3(18, 0, 0);  // a corner pushed through the middle
        stepper->set_state(x, std::vector<Vec3>(x.size(), Vec3::Zero()));
        EXPECT_FALSE(trial.require_positive_volumes(body, kind.model, kind.order));
        EXPECT_EQ(row.note, "an element is inverted at rest");
    }
}

}  // namespace
}  // namespace hepatica
