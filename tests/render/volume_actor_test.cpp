// SPDX-License-Identifier: GPL-3.0-or-later
// A CT around a vessel: what stands in front of the other hides it, the plane that opens the view
// opens both, and nothing is left where it is not shown any more.
#include "render/volume_actor.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolumeCollection.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "core/image/filters.h"
#include "render/osmesa_context.h"
#include "render/picture.h"
#include "render/scene_view.h"
#include "tests/render/fake_frame.h"
#include "tests/render/screenshot.h"

namespace hepatica {
namespace {

constexpr int across_px = 320, down_px = 240;
constexpr std::int16_t air = -1000, liver = 110, blood = 170, bone = 700;

// Cubes of 2 mm about the origin, filled by what lies at each place, and as blurred as a CT is.
template <class Tissue>
std::shared_ptr<const Volume> ct_of(const Tissue& tissue_at) {
    Grid grid;
    grid.dims = {80, 60, 80};
    grid.spacing_mm = Vec3::Constant(2.0);
    grid.origin_mm = Vec3(-79, -59, -79);
    FloatVolume sharp(grid);
    for (std::size_t i = 0; i < sharp.voxels.size(); ++i) {
        const Index3 at = grid.index_of(i);
        sharp.voxels[i] = tissue_at(grid.to_mm(at[0], at[1], at[2]));
    }
    Job job;
    gaussian_smooth(sharp, Vec3::Constant(2.0), job);
    auto ct = std::make_shared<Volume>(grid);
    std::transform(sharp.voxels.begin(), sharp.voxels.end(), ct->voxels.begin(),
                   [](float hu) { return static_cast<std::int16_t>(hu); });
    return ct;
}

// A plate across the line of sight from the front, `y_mm` behind the vessel.
std::shared_ptr<const Volume> plate_at(double y_mm, std::int16_t tissue = bone) {
    return ct_of([&](const Vec3& place) {
        return std::abs(place.y() - y_mm) < 5.0 && place.cwiseAbs().maxCoeff() < 60.0 ? tissue
                                                                                      : air;
    });
}

Frame ball(double radius_mm) {
    const TriangleMesh mesh = testing::sphere(Vec3::Zero(), radius_mm);
    Frame frame;
    for (const Vec3& vertex : mesh.vertices_mm)
        for (const double x : vertex) frame.positions_mm.push_back(static_cast<float>(x));
    frame.surface = std::make_shared<const std::vector<std::array<int, 3>>>(mesh.triangles);
    frame.topology_version = 1;
    return frame;
}

class VolumePicture : public ::testing::Test {
  protected:
    VolumePicture() {
        view_.set_annotations_visible(false);
        const Frame vessel = ball(20.0);
        view_.show(vessel);
        view_.set_vertex_systems(
            std::vector(vessel.positions_mm.size() / 3, VascularSystem::hepatic));
        look_from(view_.camera(), ViewDirection::anterior, Vec3::Constant(-70), Vec3::Constant(70),
                  double(across_px) / down_px);
        without_ = picture();
    }
    Picture picture() {
        view_.render();
        return read_picture(context_.window());
    }
    Picture picture_with(std::shared_ptr<const Volume> ct) {
        view_.set_volume(std::move(ct));
        return picture();
    }
    // How far two pictures are apart at a place of the patient, of 255.
    int difference_at(const Vec3& place_mm, const Picture& a, const Picture& b) const {
        const Pixel pixel = view_.pixel_of(place_mm);
        const std::size_t at = 3 * static_cast<std::size_t>(static_cast<int>(pixel.y) * across_px +
                                                            static_cast<int>(pixel.x));
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(int(a.rgb[at + c]) - int(b.rgb[at + c])));
        return most;
    }

    const Vec3 vessel_ = Vec3(0, -20, 0), beside_ = Vec3(40, 0, 10);
    OsmesaContext context_{across_px, down_px};
    SceneView view_{context_.window()};
    Picture without_;
};

TEST_F(VolumePicture, HidesTheVesselBehindBone) {
    const Picture with = picture_with(plate_at(-40.0));
    EXPECT_GT(difference_at(vessel_, with, without_), 60);
    EXPECT_GT(difference_at(beside_, with, without_), 60);
    EXPECT_LT(difference_at(vessel_, with, picture_with(plate_at(-40.0))), 3) << "once more";
}

TEST_F(VolumePicture, IsHiddenBehindTheVessel) {
    const Picture with = picture_with(plate_at(40.0));
    EXPECT_LE(difference_at(vessel_, with, without_), 2);
    EXPECT_GT(difference_at(beside_, with, without_), 60);
}

TEST_F(VolumePicture, LeavesTheVesselToBeSeenThroughTheLiver) {
    const Picture with =
        picture_with(ct_of([](const Vec3& place) { return place.norm() < 55.0 ? liver : air; }));
    EXPECT_GT(difference_at(vessel_, with, without_), 2) << "a haze";
    EXPECT_LT(difference_at(vessel_, with, without_), 60);
}

TEST_F(VolumePicture, StopsAtTheVesselWithAMaximumToo) {
    view_.set_volume_look({VolumePreset::maximum_intensity, 0.5, {}});
    EXPECT_LE(difference_at(vessel_, picture_with(plate_at(40.0)), without_), 2);
    EXPECT_GT(difference_at(vessel_, picture_with(plate_at(-40.0)), without_), 40);
}

TEST_F(VolumePicture, IsCutByThePlaneThatOpensTheView) {
    const Picture whole = picture_with(plate_at(-40.0));
    view_.set_clip(ClipPlane{Vec3(0, -30, 0), Vec3::UnitY()});
    const Picture open = picture();
    EXPECT_LE(difference_at(vessel_, open, without_), 2);
    EXPECT_LE(difference_at(beside_, open, without_), 2);
    view_.set_clip(std::nullopt);
    EXPECT_LE(difference_at(vessel_, picture(), whole), 2);
}

TEST_F(VolumePicture, FollowsWindowDensityAndPreset) {
    const Picture first = picture_with(plate_at(-40.0, blood));
    EXPECT_FALSE(view_.set_volume_look({VolumePreset::vessels_and_bones, 0.5, {}}) &&
                 difference_at(beside_, picture(), first) > 2)
        << "the same look";
    view_.set_volume_look({VolumePreset::vessels_and_bones, 1.0, {}});
    const Picture dense = picture();
    EXPECT_GT(difference_at(beside_, dense, first), 10);
    view_.set_volume_look({VolumePreset::vessels_and_bones, 1.0, {400.0, 300.0}});
    EXPECT_LE(difference_at(beside_, picture(), without_), 2) << "black in that window";
    view_.set_volume_look({VolumePreset::maximum_intensity, 1.0, {}});
    EXPECT_GT(difference_at(beside_, picture(), dense), 10);
}

// Where nothing is shown, a change of look changes no picture.
TEST_F(VolumePicture, TellsWhetherItsLookIsSeen) {
    EXPECT_FALSE(view_.set_volume_look({VolumePreset::maximum_intensity, 0.5, {}}));
    picture_with(plate_at(40.0));
    EXPECT_TRUE(view_.set_volume_look({VolumePreset::vessels_and_bones, 0.5, {}}));
}

TEST_F(VolumePicture, IsGoneWithItsMemory) {
    auto ct = plate_at(-40.0);
    const std::weak_ptr<const Volume> kept = ct;
    picture_with(std::move(ct));
    EXPECT_FALSE(kept.expired());
    EXPECT_EQ(picture_with(nullptr).rgb, without_.rgb);
    EXPECT_TRUE(kept.expired());
}

// While anything moves there are fewer rays; saved pictures have one a pixel.
TEST_F(VolumePicture, IsCoarseWhileItMoves) {
    // Vessels and lights are fewer then, too.
    view_.show(Frame{});
    view_.set_volume_look({VolumePreset::maximum_intensity, 0.5, {}});
    const auto slanted = ct_of([](const Vec3& place) {
        return std::abs(place.x() + 2.0 * place.z()) < 10.0 ? bone : air;
    });
    const Picture best = picture_with(slanted);
    view_.set_smoothing(Smoothing::none);
    const Picture coarse = picture();
    view_.set_smoothing(Smoothing::best);
    EXPECT_EQ(picture().rgb, best.rgb);
    int otherwise = 0;
    for (std::size_t i = 0; i < best.rgb.size(); ++i)
        otherwise += std::abs(int(coarse.rgb[i]) - int(best.rgb[i])) > 8;
    EXPECT_GT(otherwise, 1000);
    EXPECT_LT(testing::worst_tile_difference(coarse, best), 60.0) << "but of the same thing";
}

TEST_F(VolumePicture, LooksAsItDidInEveryRoom) {
    const Frame tree = testing::fake_frame();
    view_.show(tree);
    view_.set_vertex_systems(std::vector(tree.positions_mm.size() / 3, VascularSystem::portal));
    view_.look_from(ViewDirection::anterior);
    orbit(view_.camera(), 30.0, 10.0);
    view_.zoom_by(0.9);
    // A liver around the tree, a spine behind it, an aorta before that and a rib in front.
    view_.set_volume(ct_of([](const Vec3& place) {
        const auto along_z = [&](double x, double y) {
            return std::hypot(place.x() - x, place.y() - y);
        };
        if (along_z(0, 45) < 12.0 && std::fmod(place.z() + 100.0, 25.0) > 4.0) return bone;
        if (along_z(25, 35) < 7.0) return blood;
        if (std::hypot(place.y() + 45.0, place.z() + 0.4 * place.x() + 10.0) < 5.0) return bone;
        return place.cwiseQuotient(Vec3(60, 40, 70)).norm() < 1.0 ? liver : air;
    }));
    testing::expect_matches_baseline(picture(), "ct_volume_dark");
    view_.set_look(light_look);
    testing::expect_matches_baseline(picture(), "ct_volume_light");
    view_.set_look(high_contrast_look);
    view_.set_volume_look({VolumePreset::maximum_intensity, 0.5, {}});
    testing::expect_matches_baseline(picture(), "ct_volume_maximum");
}

// The two mappers, without a vessel: the processor's and the card's, which Mesa plays here.
class VolumeMappers : public ::testing::Test {
  protected:
    VolumeMappers() {
        context_.window().AddRenderer(renderer_);
        vtkNew<vtkLight> light;
        light->SetLightTypeToHeadlight();
        light->SetIntensity(0.6);
        renderer_->AddLight(light);
        look_from(*renderer_->GetActiveCamera(), ViewDirection::anterior, Vec3::Constant(-70),
                  Vec3::Constant(70), double(across_px) / down_px);
    }
    Picture picture(bool by_card, const std::shared_ptr<const Volume>& ct) {
        VolumeActor actor(*renderer_);
        actor.show(ct);
        actor.prepare(by_card);
        EXPECT_EQ(renderer_->GetVolumes()->GetNumberOfItems(), 1);
        renderer_->ResetCameraClippingRange();
        context_.window().Render();
        const Picture drawn = read_picture(context_.window());
        actor.show(nullptr);
        EXPECT_EQ(renderer_->GetVolumes()->GetNumberOfItems(), 1) << "until the next picture";
        actor.prepare(by_card);
        EXPECT_EQ(renderer_->GetVolumes()->GetNumberOfItems(), 0);
        return drawn;
    }

    OsmesaContext context_{across_px, down_px};
    vtkNew<vtkRenderer> renderer_;
};

TEST_F(VolumeMappers, DrawMuchTheSame) {
    const auto ct = plate_at(0.0);
    const Picture processor = picture(false, ct), card = picture(true, ct);
    const std::size_t middle =
        3 * static_cast<std::size_t>(down_px / 2 * across_px + across_px / 2);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_GT(processor.rgb[middle + c], 60);
        EXPECT_NEAR(processor.rgb[middle + c], card.rgb[middle + c], 45);
    }
}

TEST_F(VolumeMappers, AreMadeOnlyOfWhatIsShown) {
    VolumeActor actor(*renderer_);
    actor.prepare(false);
    EXPECT_EQ(renderer_->GetVolumes()->GetNumberOfItems(), 0);
    EXPECT_FALSE(actor.set_look({}));
}

}  // namespace
}  // namespace hepatica
