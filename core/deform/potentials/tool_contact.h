// SPDX-License-Identifier: GPL-3.0-or-later
// The pad between a tool and the body's surface as a potential: its pressure p g/(1 - g), with
// g = 1 - d/h for the gap d < h, is integrated over the surface at rest by points on the triangles.
// A point that stands for the area A stores
//   A p h (-g - ln(1 - g)),    whose force is A p g/(1 - g):
// linear at first and without bound where the gap closes, so that every balance of forces is one
// without penetration. Where d <= 0 the energy is infinite. Points lie so close together that
// between them a triangle comes nearer to the tool by an eighth of the pad at most, even where it
// is stretched by a half; gaps are counted from there. The stiffness is that along the normal; what
// turns the normal is left out, since it would make the matrix indefinite. Each triangle is one
// element's face: no block of the matrix is new. Its term of the ledger is `contact`.
#pragma once

#include <optional>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/potentials/potential.h"
#include "core/deform/potentials/tool.h"
#include "core/deform/potentials/tool_path.h"

namespace hepatica {

// A point of the surface in the pad.
struct PadContact {
    int part = 0;        // of the tool
    double along = 0.0;  // that part's axis, from 0 to 1
    int triangle = 0;
    std::array<double, 3> weights{};  // of its corners
    Vec3 normal = Vec3::Zero();       // from the tool to the body, of length 1
    Vec3 at_mm = Vec3::Zero();
    double force_un = 0.0;  // along the normal on the body, > 0
    double stiffness_un_per_mm = 0.0;
    double energy_nj = 0.0;
};

// Keeps a reference to the body, whose `surface` is not empty. Costs nothing without a tool.
class ToolContact final : public Potential {
  public:
    explicit ToolContact(const Body& body);

    // As validate_tool demands.
    void set(const std::optional<Tool>& tool) { tool_ = tool; }
    const std::optional<Tool>& tool() const { return tool_; }
    const SurfacePatches& surface() const { return surface_; }

    // Part by part, by the number of the triangle, from corner to corner: as the tool stands, and
    // as it stood before it was led last.
    std::vector<PadContact> contacts(std::span<const Vec3> positions_mm) const;
    std::vector<PadContact> contacts_before_led(std::span<const Vec3> positions_mm) const;
    // The gap between tool and nearest triangle: < 0 inside, infinite beyond the pad.
    double least_gap_mm(std::span<const Vec3> positions_mm) const;
    // Whether the pad's energy is finite and nothing is in the tool.
    bool free(std::span<const Vec3> positions_mm) const;
    // The vertices of all patches whose boxes meet the box swept by the tool and its pad.
    std::vector<int> vertices_near_way(std::span<const Vec3> positions_mm) const;
    // Moves the tool past the body at rest until a gap falls to half of the pad: tool_path.h.
    bool lead(std::span<const Vec3> positions_mm, double share, double dt_s);

    double energy(std::span<const Vec3> positions_mm,
                  std::span<const Vec3> reference_mm) const override;
    void add_energy_by_piece(std::span<const Vec3> positions_mm, std::span<const Vec3> reference_mm,
                             std::span<const int> piece_of_node,
                             std::span<double> energy_nj) const override;
    void add_forces(std::span<const Vec3> positions_mm, std::span<Vec3> forces_un) const override;
    void add_stiffness(std::span<const Vec3> positions_mm, double factor,
                       BlockMatrix& matrix) const override;
    void add_product(std::span<const Vec3> positions_mm, double factor, std::span<const Vec3> d,
                     const BlockMatrix& pattern, std::span<Vec3> product) const override;
    void begin_step(const BodyState&, double, std::span<const std::uint8_t> held) override {
        held_ = held;
    }
    void end_step() override { held_ = {}; }
    void mark_held(std::span<const Vec3> positions_mm, std::span<char> held) const override;
    void book(double energy_nj, EnergyLedger& ledger) const override {
        ledger.contact += energy_nj;
    }
    // Every gap keeps a tenth of itself, or of the pad where it is wider.
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const override;
    // The share of the motion after which a triangle that was farther away is half into the pad.
    double share_until_touch(std::span<const Vec3> from_mm,
                             std::span<const Vec3> to_mm) const override;

    const std::array<int, 3>& nodes_of(const PadContact& contact) const {
        return surface_.triangles()[contact.triangle];
    }

  private:
    std::vector<PadContact> contacts_at(std::span<const Capsule> shapes,
                                        std::span<const Vec3> positions_mm) const;
    void add_points_of(int triangle, const Capsule& shape, int part,
                       std::span<const Vec3> positions_mm, std::vector<PadContact>& found) const;
    ToolResistance resistance_at(std::span<const Capsule> shapes,
                                 std::span<const Vec3> positions_mm) const;

    SurfacePatches surface_;
    std::vector<double> area_mm2_, longest_edge_mm_;  // of each triangle at rest
    std::optional<Tool> tool_;
    std::span<const std::uint8_t> held_;
};

}  // namespace hepatica
