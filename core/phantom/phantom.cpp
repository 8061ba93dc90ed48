// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a phantom: validate, fit the anatomy to the field of view, grow the vessels, scan.
#include "core/phantom/phantom.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/memory_limit.h"
#include "core/phantom/phantom_body.h"
#include "core/phantom/phantom_centrelines.h"
#include "core/phantom/phantom_contacts.h"
#include "core/phantom/phantom_growth.h"
#include "core/phantom/phantom_range.h"
#include "core/phantom/phantom_scan.h"

namespace hepatica {

namespace {

void validate(const PhantomOptions& options) {
    require_range("--generations", options.generations, 1, 10);
    require_range("--systems", options.systems, 1, 2);
    for (int axis = 0; axis < 3; ++axis) {
        require_range("--dims", options.dims[axis], 16, 2048);
        require_range("--spacing", options.spacing_mm[axis], 0.1, 10.0);
    }
    require_range("phantom root radius in mm", options.root_radius_mm, 1.0, 12.0);
    require_range("phantom Murray exponent", options.murray_exponent, 2.0, 4.0);
    require_range("phantom parenchyma in HU", options.parenchyma_hu, -100.0, 300.0);
    require_range("--contrast-hu", options.contrast_hu, 0.0, 1000.0);
    require_range("--noise-hu", options.noise_hu, 0.0, 500.0);
    require_range("--touch", options.touching, 0, 20);
    if (options.touching > 0 && options.systems < 2)
        throw InputError("one system has no other to touch", "--touch", "Ask for --systems 2");
    if (options.hepatic_contrast_hu)
        require_range("--hepatic-contrast-hu", *options.hepatic_contrast_hu, 0.0, 1000.0);
    validate(options.disturbances);
    require_range("phantom point spread in mm", options.point_spread_sigma_mm, 0.0, 5.0);
}

// The field of view: its grid, and the scale of the anatomy relative to an adult's.
struct FieldOfView {
    double scale = 1.0;
    Grid grid;
};

FieldOfView frame_liver(const PhantomOptions& options) {
    FieldOfView view;
    view.grid.dims = options.dims;
    view.grid.spacing_mm = options.spacing_mm;
    const Vec3 extent =
        Vec3(options.dims[0], options.dims[1], options.dims[2]).cwiseProduct(options.spacing_mm);
    const Vec3 low = PhantomBody::liver_low();
    const Vec3 high = PhantomBody::liver_high();
    view.scale = std::min(1.0, extent.cwiseQuotient(high - low).minCoeff());
    // Centred as close to the middle of the body as the liver allows.
    const Vec3 half = 0.5 * extent / view.scale;
    const Vec3 centre = (high - half).cwiseMax(Vec3::Zero()).cwiseMin(low + half);
    const Vec3 first_to_centre = 0.5 * (extent - options.spacing_mm);
    view.grid.origin_mm = view.scale * centre - first_to_centre;
    return view;
}

// Grows the systems and draws their centrelines in the adult's frame.
VesselTree grow_systems(const PhantomBody& body, const PhantomOptions& options, double scale,
                        Job& job) {
    job.begin_stage("Growing the vessels");
    PhantomRandom random(scrambled(options.seed));
    std::vector<GrowthRequest> requests(static_cast<std::size_t>(options.systems));
    for (GrowthRequest& request : requests) {
        request.root = requests.data() == &request ? body.portal_entry() : body.hepatic_outlet();
        request.low = PhantomBody::liver_low();
        request.high = PhantomBody::liver_high();
        request.depth_mm = [&](const Vec3& p) { return -body.liver_distance_mm(p); };
        request.ends = 1 << options.generations;
        request.root_radius_mm = options.root_radius_mm;
        request.murray_exponent = options.murray_exponent;
    }
    VesselTree tree;
    CentrelineRequest centrelines;
    centrelines.root_radius_mm = options.root_radius_mm;
    centrelines.murray_exponent = options.murray_exponent;
    centrelines.point_spacing_mm = options.spacing_mm.minCoeff() / scale;
    const std::vector<std::vector<GrownBranch>> grown = grow_trees(requests, random, job);
    for (std::size_t i = 0; i < grown.size(); ++i) {
        centrelines.system = i == 0 ? VascularSystem::portal : VascularSystem::hepatic;
        centrelines.obstacles = straight_vessels_of(tree);
        for (std::size_t later = i + 1; later < grown.size(); ++later)
            append_chords(centrelines.obstacles, grown[later], centrelines);
        append_system(tree, grown[i], centrelines, random);
    }
    return tree;
}

std::vector<Vec3> touch(VesselTree& tree, const PhantomOptions& options) {
    if (options.touching == 0) return {};
    std::vector<Vec3> places = bend_to_touch(tree, options.touching, scrambled(options.seed));
    if (static_cast<int>(places.size()) < options.touching && !options.touch_fewer)
        throw InputError("the systems of this seed can be made to touch in " +
                             std::to_string(places.size()) + " places only",
                         "--touch", "Ask for fewer, or for more --generations");
    return places;
}

void scale_tree(VesselTree& tree, double scale) {
    for (VesselNode& node : tree.nodes) {
        node.position_mm *= scale;
        node.radius_mm *= scale;
    }
    for (VesselSegment& segment : tree.segments) {
        for (Vec3& p : segment.points_mm) p *= scale;
        for (double& r : segment.radii_mm) r *= scale;
    }
}

}  // namespace

Phantom make_phantom(const PhantomOptions& options, Job& job) {
    validate(options);
    constexpr int bytes_per_voxel = 8;  // measured; disturbances take more
    require_memory(bytes_of(options.dims[0], options.dims[1], options.dims[2], bytes_per_voxel),
                   "--dims");
    const FieldOfView view = frame_liver(options);
    const PhantomBody body(options.seed, options.parenchyma_hu);
    Phantom phantom;
    phantom.tree = grow_systems(body, options, view.scale, job);
    phantom.contacts_mm = touch(phantom.tree, options);
    scale_tree(phantom.tree, view.scale);
    for (Vec3& place : phantom.contacts_mm) place *= view.scale;
    phantom.vessels = lumen_share(phantom.tree, view.grid, std::nullopt, job);
    for (std::uint8_t& voxel : phantom.vessels.voxels) voxel = voxel >= 32 ? 1 : 0;
    scan(phantom, body, options, view.scale, job);
    return phantom;
}

}  // namespace hepatica
