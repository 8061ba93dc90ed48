// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels and lines of sight: back and forth, and against VTK's own transform.
#include "render/projection.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <Eigen/Geometry>
#include <random>

namespace hepatica {
namespace {

constexpr int picture_width = 640, picture_height = 480;

class Eye {
  public:
    explicit Eye(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-200.0, 200.0);
        camera_->SetPosition(number(random), number(random), number(random));
        camera_->SetFocalPoint(number(random), number(random), number(random));
        camera_->SetViewUp(number(random), number(random), number(random));
        camera_->SetViewAngle(10.0 + 0.2 * std::abs(number(random)));
    }
    vtkCamera& camera() { return *camera_; }
    // By VTK's own matrix.
    Pixel shown_by_vtk(const Vec3& position_mm) {
        double point[4] = {position_mm.x(), position_mm.y(), position_mm.z(), 1.0}, seen[4];
        camera_
            ->GetCompositeProjectionTransformMatrix(
                static_cast<double>(picture_width) / picture_height, 0, 1)
            ->MultiplyPoint(point, seen);
        return {0.5 * picture_width * (1.0 + seen[0] / seen[3]),
                0.5 * picture_height * (1.0 - seen[1] / seen[3])};
    }

  private:
    vtkNew<vtkCamera> camera_;
};

TEST(Projection, IsThatOfTheCamera) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        Eye eye(seed);
        const Projection projection(eye.camera(), picture_width, picture_height);
        const ViewAxes axes = axes_of(eye.camera());
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-30.0, 30.0);
        for (int i = 0; i < 20; ++i) {
            // In front of the eye.
            const Vec3 place = Vec3(eye.camera().GetPosition()) + 200.0 * axes.forward +
                               number(random) * axes.right + number(random) * axes.up;
            const Pixel pixel = projection.pixel_of(place), by_vtk = eye.shown_by_vtk(place);
            EXPECT_NEAR(pixel.x, by_vtk.x, 1e-6) << seed;
            EXPECT_NEAR(pixel.y, by_vtk.y, 1e-6) << seed;
            // The line of sight through its pixel meets it, at its own depth.
            const ViewRay ray = projection.ray_through(pixel);
            EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-12);
            EXPECT_LT((place - ray.origin_mm).cross(ray.direction).norm(), 1e-9) << seed;
            EXPECT_LT((projection.point_at_depth(pixel, place) - place).norm(), 1e-9) << seed;
        }
    }
}

TEST(Projection, HasAxesAsTheReaderSees) {
    vtkNew<vtkCamera> camera;
    camera->SetPosition(0, -500, 20);  // from the front
    camera->SetFocalPoint(0, 10, 20);
    camera->SetViewUp(0, 0, 1);
    const ViewAxes axes = axes_of(*camera);
    EXPECT_TRUE(axes.forward.isApprox(Vec3(0, 1, 0)));
    EXPECT_TRUE(axes.right.isApprox(Vec3(1, 0, 0))) << "the patient's left";
    EXPECT_TRUE(axes.up.isApprox(Vec3(0, 0, 1)));
    EXPECT_TRUE(axes.focus_mm.isApprox(Vec3(0, 10, 20)));
}

}  // namespace
}  // namespace hepatica
