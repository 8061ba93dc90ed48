// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/peers/bullet_beam.h"

#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>

namespace hepatica {

namespace {

// Bullet is in metres, kilograms, seconds.
constexpr double metre_mm = 1000.0;
constexpr double kilogram_g = 1000.0;

btVector3 to_bullet(const Vec3& x_mm) {
    return {static_cast<btScalar>(x_mm.x() / metre_mm), static_cast<btScalar>(x_mm.y() / metre_mm),
            static_cast<btScalar>(x_mm.z() / metre_mm)};
}

}  // namespace

struct BulletBeam::World {
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btDeformableBodySolver body_solver;
    btDeformableMultiBodyConstraintSolver constraint_solver;
    btDeformableMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &constraint_solver,
                                             &configuration, &body_solver};
    std::unique_ptr<btDeformableLagrangianForce> elasticity, weight;
    std::unique_ptr<btSoftBody> body;

    World() { constraint_solver.setDeformableSolver(&body_solver); }
    ~World() {
        if (body) world.removeSoftBody(body.get());
    }
};

BulletBeam::BulletBeam(const TetMesh& mesh, const std::vector<std::uint8_t>& fixed,
                       const Material& material, const Vec3& gravity_mm_s2)
    : world_(std::make_unique<World>()) {
    World& w = *world_;
    const btVector3 gravity = to_bullet(gravity_mm_s2);
    w.world.setGravity(gravity);
    w.world.getWorldInfo().m_gravity = gravity;
    w.world.setImplicit(true);
    w.world.setLineSearch(false);
    w.world.setUseProjection(true);  // conjugate gradients, with held vertices projected out

    std::vector<btVector3> positions;
    for (const Vec3& x : mesh.vertices_mm) positions.push_back(to_bullet(x));
    std::vector<double> mass_g(positions.size(), 0.0);
    w.body = std::make_unique<btSoftBody>(
        &w.world.getWorldInfo(), static_cast<int>(positions.size()), positions.data(), nullptr);
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
        w.body->appendTetra(a, b, c, d);
        const double volume = signed_volume_mm3(mesh.vertices_mm[a], mesh.vertices_mm[b],
                                                mesh.vertices_mm[c], mesh.vertices_mm[d]);
        for (const int v : {a, b, c, d}) mass_g[v] += 0.25 * material.density_g_mm3 * volume;
    }
    btSoftBodyHelpers::generateBoundaryFaces(w.body.get());
    w.body->initializeDmInverse();
    w.body->m_tetraScratches.resize(w.body->m_tetras.size());
    w.body->m_tetraScratchesTn.resize(w.body->m_tetras.size());
    for (std::size_t v = 0; v < mass_g.size(); ++v) {
        w.body->setMass(static_cast<int>(v),
                        fixed[v] ? btScalar(0) : static_cast<btScalar>(mass_g[v] / kilogram_g));
    }
    w.body->m_sleepingThreshold = 0;
    w.body->setActivationState(DISABLE_DEACTIVATION);
    w.world.addSoftBody(w.body.get());

    const Lame lame = lame_of(material);
    w.elasticity = std::make_unique<btDeformableLinearElasticityForce>(
        static_cast<btScalar>(lame.mu_pa), static_cast<btScalar>(lame.lambda_pa), btScalar(0),
        btScalar(0));
    w.weight = std::make_unique<btDeformableGravityForce>(gravity);
    w.world.addForce(w.body.get(), w.elasticity.get());
    w.world.addForce(w.body.get(), w.weight.get());
}

BulletBeam::~BulletBeam() = default;

void BulletBeam::step(double dt_s) {
    const btScalar dt = static_cast<btScalar>(dt_s);
    world_->world.stepSimulation(dt, 1, dt);
}

std::vector<Vec3> BulletBeam::positions_mm() const {
    std::vector<Vec3> positions;
    for (int v = 0; v < world_->body->m_nodes.size(); ++v) {
        const btVector3& x = world_->body->m_nodes[v].m_x;
        positions.emplace_back(metre_mm * x.x(), metre_mm * x.y(), metre_mm * x.z());
    }
    return positions;
}

}  // namespace hepatica
