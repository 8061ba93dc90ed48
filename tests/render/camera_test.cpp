// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <Eigen/Geometry>

namespace hepatica {
namespace {

TEST(Camera, anterior_shows_the_patients_left_on_the_right_and_the_head_above) {
    vtkNew<vtkCamera> camera;
    look_from(*camera, ViewDirection::anterior, Vec3(-1, -2, -3), Vec3(1, 2, 3), 1.5);
    const Vec3 forward(camera->GetDirectionOfProjection());
    const Vec3 up(camera->GetViewUp());
    EXPECT_NEAR((forward - Vec3(0, 1, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((forward.cross(up) - Vec3(1, 0, 0)).norm(), 0, 1e-12);
}

TEST(Camera, every_view_holds_the_whole_box) {
    const Vec3 lower(-10, 20, -3);
    const Vec3 upper(50, 31, 170);
    for (const ViewDirection direction : all_view_directions()) {
        for (const double aspect : {0.5, 1.0, 2.5}) {
            vtkNew<vtkCamera> camera;
            look_from(*camera, direction, lower, upper, aspect);
            vtkMatrix4x4* to_clip = camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
            for (int corner = 0; corner < 8; ++corner) {
                const double in[4] = {corner & 1 ? lower.x() : upper.x(),
                                      corner & 2 ? lower.y() : upper.y(),
                                      corner & 4 ? lower.z() : upper.z(), 1.0};
                double out[4];
                to_clip->MultiplyPoint(in, out);
                EXPECT_LT(std::abs(out[0] / out[3]), 1.0) << name_of(direction);
                EXPECT_LT(std::abs(out[1] / out[3]), 1.0) << name_of(direction);
            }
        }
    }
}

TEST(Camera, names_are_unique_and_read_back) {
    for (const ViewDirection direction : all_view_directions()) {
        EXPECT_EQ(view_direction_named(name_of(direction)), direction);
    }
    EXPECT_FALSE(view_direction_named("sideways"));
}

TEST(Camera, orbit_keeps_the_distance_and_survives_the_poles) {
    vtkNew<vtkCamera> camera;
    look_from(*camera, ViewDirection::anterior, Vec3(-1, -1, -1), Vec3(1, 1, 1), 1.0);
    const double distance = camera->GetDistance();
    for (int i = 0; i < 100; ++i) orbit(*camera, 3.0, 7.0);
    EXPECT_NEAR(camera->GetDistance(), distance, 1e-9 * distance);
    const Vec3 up(camera->GetViewUp());
    EXPECT_NEAR(up.norm(), 1.0, 1e-9);
    EXPECT_NEAR(up.dot(Vec3(camera->GetDirectionOfProjection())), 0.0, 1e-9);
}

}  // namespace
}  // namespace hepatica
