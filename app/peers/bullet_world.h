// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies in Bullet's deformable world with its implicit corotational force, as a peer for
// benchmarks. btDeformableCorotatedForce has no force differential in Bullet 3 and is therefore
// explicit; btDeformableLinearElasticityForce is the corotational force that Bullet can step
// implicitly.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/deform/body/material.h"
#include "core/mesh/tet_mesh.h"

namespace hepatica {

class BulletWorld {
  public:
    explicit BulletWorld(const Vec3& gravity_mm_s2);
    ~BulletWorld();

    // Masses are lumped. Fixed vertices (nonzero) have mass 0, by which Bullet holds them; `fixed`
    // may be empty.
    void add_body(const TetMesh& mesh, const std::vector<std::uint8_t>& fixed,
                  const Material& material);

    void step(double dt_s);
    std::vector<Vec3> positions_mm(std::size_t body) const;

  private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace hepatica
