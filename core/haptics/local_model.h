// SPDX-License-Identifier: GPL-3.0-or-later
// What the force loop knows of the touched patch between two steps of the simulation: contacts, and
// how they give way together. With the motion a of the tool into the body at each contact, from the
// tool's last pose, the contact forces f >= 0 are those of
//   E(a) = max over f >= 0 of  a.f - (f - f0)^T C (f - f0) / 2,
// f0 of the last step and C the compliance of pads and body. E is convex and the force on the tool
// is its negative gradient: what is pressed in is given back and not more. A tool that is where it
// was feels what the simulation says.
#pragma once

#include <vector>

#include "core/base/vector.h"
#include "core/haptics/haptic_device.h"

namespace hepatica {

// And one more for each part of a tool beyond its first, whose contacts are not joined to the
// others.
inline constexpr int most_local_contacts = 64;

struct LocalContact {
    Vec3 at_mm = Vec3::Zero();
    Vec3 normal = Vec3::Zero();  // from the tool to the body, of length 1
    double force_un = 0.0;       // f0, >= 0
};

// Of one step. What is handed to the loop; vectors keep their memory from step to step.
struct LocalModel {
    bool tool = false;              // one is in hand; otherwise the rest is empty
    Vec3 centre_mm = Vec3::Zero();  // where the tool is
    Vec3 left_rad = Vec3::Zero();   // how far it is still to turn
    std::vector<LocalContact> contacts;
    // Of pads and body [mm/uN], symmetric positive definite; a row for each contact.
    Eigen::MatrixXd compliance;
};

// A model in series with the coupling of a device: a spring and a torsion spring, without which the
// patch may be stiffer than the device can show. By it no force grows faster with the pose than by
// the coupling's stiffness. Not thread-safe; allocates in take() alone.
class LocalForce {
  public:
    // Stiffness > 0 [uN/mm], and of turns [uN mm/rad].
    LocalForce(double coupling_un_per_mm, double turn_coupling_un_mm);

    void take(const LocalModel& model);
    // On a tool that is that far from the model's pose: mm, then rad about its centre.
    HapticForce at(const Vec6& way);
    double energy_nj() const {
        return energy_nj_;
    }  // E of the last at(); 0 where it touches nothing
    int contacts() const { return static_cast<int>(f0_.size()); }

  private:
    void solve(const Eigen::VectorXd& wanted);

    Vec6 give_;                            // of the coupling: 1/stiffness
    Eigen::Matrix<double, -1, 6> motion_;  // of each contact, into the body, by the way
    Eigen::MatrixXd compliance_;
    Eigen::VectorXd f0_, f_, apart_, wanted_, right_;
    Eigen::MatrixXd pressed_matrix_;
    std::vector<char> pressed_;  // contacts with f > 0, of the last solution
    std::vector<int> index_;
    double energy_nj_ = 0.0;
};

}  // namespace hepatica
