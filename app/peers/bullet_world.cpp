// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/peers/bullet_world.h"

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

// Bullet uses metres, kilograms and seconds.
constexpr double metre_mm = 1000.0;
constexpr double kilogram_g = 1000.0;

btScalar metres(double mm) {
    return static_cast<btScalar>(mm / metre_mm);
}

btVector3 to_bullet(const Vec3& x_mm) {
    return {metres(x_mm.x()), metres(x_mm.y()), metres(x_mm.z())};
}

}  // namespace

struct BulletWorld::World {
    struct Soft {
        std::unique_ptr<btSoftBody> body;
        std::unique_ptr<btDeformableLagrangianForce> elasticity, weight;
    };

    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btDeformableBodySolver body_solver;
    btDeformableMultiBodyConstraintSolver constraint_solver;
    btDeformableMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &constraint_solver,
                                             &configuration, &body_solver};
    std::vector<Soft> bodies;
    btVector3 gravity;

    World() { constraint_solver.setDeformableSolver(&body_solver); }
    ~World() {
        for (Soft& soft : bodies) world.removeSoftBody(soft.body.get());
    }
};

BulletWorld::BulletWorld(const Vec3& gravity_mm_s2) : world_(std::make_unique<World>()) {
    World& w = *world_;
    w.gravity = to_bullet(gravity_mm_s2);
    w.world.setGravity(w.gravity);
    w.world.getWorldInfo().m_gravity = w.gravity;
    w.world.setImplicit(true);
    w.world.setLineSearch(false);
    w.world.setUseProjection(true);  // conjugate gradients with fixed vertices projected out
}

BulletWorld::~BulletWorld() = default;

void BulletWorld::add_body(const TetMesh& mesh, const std::vector<std::uint8_t>& fixed,
                           const Material& material) {
    World& w = *world_;
    World::Soft soft;
    std::vector<btVector3> positions;
    for (const Vec3& x : mesh.vertices_mm) positions.push_back(to_bullet(x));
    std::vector<double> mass_g(positions.size(), 0.0);
    soft.body = std::make_unique<btSoftBody>(
        &w.world.getWorldInfo(), static_cast<int>(positions.size()), positions.data(), nullptr);
    btSoftBody& body = *soft.body;
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
        body.appendTetra(a, b, c, d);
        const double volume = signed_volume_mm3(mesh.vertices_mm[a], mesh.vertices_mm[b],
                                                mesh.vertices_mm[c], mesh.vertices_mm[d]);
        for (const int v : {a, b, c, d}) mass_g[v] += 0.25 * material.density_g_mm3 * volume;
    }
    btSoftBodyHelpers::generateBoundaryFaces(&body);
    body.initializeDmInverse();
    body.m_tetraScratches.resize(body.m_tetras.size());
    body.m_tetraScratchesTn.resize(body.m_tetras.size());
    for (std::size_t v = 0; v < mass_g.size(); ++v)
        body.setMass(static_cast<int>(v), !fixed.empty() && fixed[v]
                                              ? btScalar(0)
                                              : static_cast<btScalar>(mass_g[v] / kilogram_g));
    body.m_sleepingThreshold = 0;
    body.setActivationState(DISABLE_DEACTIVATION);
    w.world.addSoftBody(&body);
    const Lame lame = lame_of(material);
    soft.elasticity = std::make_unique<btDeformableLinearElasticityForce>(
        static_cast<btScalar>(lame.mu_pa), static_cast<btScalar>(lame.lambda_pa), btScalar(0),
        btScalar(0));
    soft.weight = std::make_unique<btDeformableGravityForce>(w.gravity);
    w.world.addForce(&body, soft.elasticity.get());
    w.world.addForce(&body, soft.weight.get());
    w.bodies.push_back(std::move(soft));
}

void BulletWorld::step(double dt_s) {
    const btScalar dt = static_cast<btScalar>(dt_s);
    world_->world.stepSimulation(dt, 1, dt);
}

std::vector<Vec3> BulletWorld::positions_mm(std::size_t body) const {
    const btSoftBody& soft = *world_->bodies[body].body;
    std::vector<Vec3> positions;
    for (int v = 0; v < soft.m_nodes.size(); ++v) {
        const btVector3& x = soft.m_nodes[v].m_x;
        positions.emplace_back(metre_mm * x.x(), metre_mm * x.y(), metre_mm * x.z());
    }
    return positions;
}

}  // namespace hepatica
