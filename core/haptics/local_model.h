// SPDX-License-Identifier: GPL-3.0-or-later
// What the force loop knows of the touched patch between two steps of the simulation: contacts and
// their common compliance. Let a be the displacement of the tool into the body at each contact,
// since the tool's last pose. The contact forces f >= 0 are those of
//   E(a) = max over f >= 0 of  a.f - (f - f0)^T C (f - f0) / 2,
// with the forces f0 of the last step and the compliance C of pads and body. E is convex and the
// force on the tool is its negative gradient, so that no more work is given back than was put in.
// At the last pose the forces are those of the simulation.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vector.h"
#include "core/haptics/haptic_device.h"

namespace hepatica {

// One more is possible for each further part of a tool, because contacts of different parts are not
// joined.
inline constexpr int most_local_contacts = 64;

struct LocalContact {
    Vec3 at_mm = Vec3::Zero();
    Vec3 normal = Vec3::Zero();  // from the tool to the body, of length 1
    double force_un = 0.0;       // f0, >= 0
};

// The model of one step, passed to the loop. Vectors keep their memory from step to step.
struct LocalModel {
    bool tool = false;              // a tool is in hand; otherwise the rest is empty
    std::uint64_t tool_number = 0;  // another number: another tool
    Vec3 centre_mm = Vec3::Zero();  // position of the tool
    Vec3 left_rad = Vec3::Zero();   // its remaining rotation
    // Number of the newest command that is in the model; later ones are under way to the next.
    std::uint64_t commands_taken = 0;
    std::vector<LocalContact> contacts;
    // Compliance of pads and body [mm/uN], symmetric positive definite; one row per contact.
    Eigen::MatrixXd compliance;
};

// A model in series with the coupling of a device: a spring and a torsion spring, because the patch
// may be stiffer than the device can display. The stiffness that is felt is at most that of the
// coupling. Not thread-safe; allocates only in take().
class LocalForce {
  public:
    // Stiffness > 0 [uN/mm], and for rotations [uN mm/rad].
    LocalForce(double coupling_un_per_mm, double turn_coupling_un_mm);

    void take(const LocalModel& model);
    // Force on a tool displaced from the model's pose: mm, then a rotation vector about its centre.
    HapticForce at(const Vec6& way);
    double energy_nj() const {
        return energy_nj_;
    }  // E of the last at(); 0 where it touches nothing
    int contacts() const { return static_cast<int>(f0_.size()); }

  private:
    void solve(const Eigen::VectorXd& wanted);
    void solve_pressed();

    Vec6 give_;                            // of the coupling: 1/stiffness
    Eigen::Matrix<double, -1, 6> motion_;  // per contact: motion into the body
    Eigen::MatrixXd compliance_;
    Eigen::VectorXd f0_, f_, apart_, bent_, wanted_, right_;
    Eigen::MatrixXd pressed_matrix_;  // memory for all contacts
    std::vector<char> pressed_;       // contacts with f > 0 in the last solution
    std::vector<int> index_;
    double energy_nj_ = 0.0;
};

}  // namespace hepatica
