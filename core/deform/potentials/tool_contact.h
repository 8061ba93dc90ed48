// SPDX-License-Identifier: GPL-3.0-or-later
// The pad between a tool and the body's surface as a potential: see ToolPad. The stiffness is the
// part along the normal; the rotation of the normal is left out, because it would make the matrix
// indefinite. Each triangle is the face of one element, so that the matrix needs no new blocks. Its
// term of the ledger is `contact`. Obstacles also stop the tool and press on it, but store no
// energy, being rigid.
#pragma once

#include <optional>
#include <vector>

#include "core/deform/body/body.h"
#include "core/deform/potentials/potential.h"
#include "core/deform/potentials/tool_obstacle.h"
#include "core/deform/potentials/tool_pad.h"
#include "core/deform/potentials/tool_path.h"
#include "core/deform/potentials/touch_list.h"

namespace hepatica {

// Keeps a reference to the body's obstacles; its `surface` must not be empty. Costs nothing without
// a tool.
class ToolContact final : public Potential {
  public:
    explicit ToolContact(const Body& body);

    // The tool must satisfy validate_tool.
    void set(const std::optional<Tool>& tool) { tool_ = tool; }
    const std::optional<Tool>& tool() const { return tool_; }

    // Contacts ordered by part, triangle and point: at the tool's present position, and at the one
    // before its last displacement.
    std::vector<PadContact> contacts(std::span<const Vec3> positions_mm) const;
    std::vector<PadContact> contacts_before_led(std::span<const Vec3> positions_mm) const;
    // All points that may be in the pad at either of two positions of the body.
    void list_touches(std::span<const Vec3> positions_mm, std::span<const Vec3> other_positions_mm,
                      TouchList& list) const;
    // The gap between the tool and the nearest triangle of the body: negative inside, the largest
    // double beyond the pad.
    double least_gap_mm(std::span<const Vec3> positions_mm) const;
    // Whether the pad's energy is finite and the tool penetrates nothing.
    bool free(std::span<const Vec3> positions_mm) const;
    // Pads of faces that a tear lays bare, see thin_pads.h: those before it, which are handed over
    // to the contact of the torn body, and their growth. Nothing without a tool.
    std::vector<ThinPad> before_tear(std::span<const Vec3> positions_mm) const;
    void follow_split(std::span<const ThinPad> before, std::span<const int> node_before,
                      std::span<const Vec3> positions_mm);
    void grow_thin_pads(std::span<const Vec3> positions_mm);
    // The vertices of all patches whose boxes meet the box swept by the tool and its pad.
    std::vector<int> vertices_near_way(std::span<const Vec3> positions_mm) const;
    // Moves the tool past the resting body and obstacles until a gap falls to half the pad; see
    // tool_path.h.
    bool lead(std::span<const Vec3> positions_mm, double share, double dt_s);
    // Whether the tool is inside an obstacle that it could not enter. Requires a tool.
    bool in_obstacle() const;
    // Contacts of obstacles in the tool's pad. Where they would exceed the tool's force limit, on
    // it or on its jaws, `share` scales their forces to that limit.
    struct ObstaclePress {
        std::vector<PadContact> contacts;
        double share = 1.0;  // of their forces
        double least_gap_mm = std::numeric_limits<double>::max();
    };
    ObstaclePress pressed_by_obstacles() const;

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
    // Every gap keeps a tenth of itself, or a tenth of the pad where the gap is wider.
    double free_share(std::span<const Vec3> from_mm, std::span<const Vec3> to_mm) const override;
    // The share of the motion after which a triangle that began outside the pad is half into it.
    double share_until_touch(std::span<const Vec3> from_mm,
                             std::span<const Vec3> to_mm) const override;

    const std::array<int, 3>& nodes_of(const PadContact& contact) const {
        return pad_.surface().triangles()[contact.triangle];
    }

  private:
    ToolResistance resistance_at(std::span<const Capsule> shapes,
                                 std::span<const Vec3> positions_mm) const;
    std::vector<const ToolObstacle*> obstacles_that_stop() const;

    ToolPad pad_;
    std::vector<ToolObstacle> obstacles_;
    std::optional<Tool> tool_;
    std::span<const std::uint8_t> held_;
};

}  // namespace hepatica
