// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/haptics/local_model.h"

#include <Eigen/Cholesky>

namespace hepatica {

LocalForce::LocalForce(double coupling_un_per_mm, double turn_coupling_un_mm) {
    give_ << Vec3::Constant(1.0 / coupling_un_per_mm), Vec3::Constant(1.0 / turn_coupling_un_mm);
}

void LocalForce::take(const LocalModel& model) {
    const auto count = static_cast<Eigen::Index>(model.contacts.size());
    motion_.resize(count, 6);
    f0_.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const LocalContact& contact = model.contacts[static_cast<std::size_t>(i)];
        const Vec3 arm = contact.at_mm - model.centre_mm;
        motion_.row(i) << contact.normal.transpose(), arm.cross(contact.normal).transpose();
        f0_[i] = contact.force_un;
    }
    compliance_ = model.compliance + motion_ * give_.asDiagonal() * motion_.transpose();
    pressed_matrix_.resize(count, count);
    for (Eigen::VectorXd* vector : {&apart_, &bent_, &wanted_, &right_}) vector->resize(count);
    f_ = f0_;
    pressed_.assign(static_cast<std::size_t>(count), 1);
    index_.reserve(pressed_.size());
    energy_nj_ = 0.0;
}

// Forces of the pressed contacts, the others having none, in memory that take() has made: Eigen's
// indexed views would copy their indices.
void LocalForce::solve_pressed() {
    const auto pressed = static_cast<Eigen::Index>(index_.size());
    Eigen::Map<Eigen::MatrixXd> matrix(pressed_matrix_.data(), pressed, pressed);
    Eigen::Map<Eigen::VectorXd> forces(apart_.data(), pressed);
    for (Eigen::Index k = 0; k < pressed; ++k) {
        const int of_column = index_[static_cast<std::size_t>(k)];
        for (Eigen::Index i = 0; i < pressed; ++i)
            matrix(i, k) = compliance_(index_[static_cast<std::size_t>(i)], of_column);
        forces[k] = right_[of_column];
    }
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(matrix);
    factor.solveInPlace(forces);
    f_.setZero();
    for (Eigen::Index k = 0; k < pressed; ++k) f_[index_[static_cast<std::size_t>(k)]] = forces[k];
}

// Linear complementarity: f >= 0, C (f - f0) >= wanted, one of the two with equality per contact.
// Principal pivoting from the last solution: all wrong contacts are exchanged at once while they
// become fewer, then the last one alone, which terminates for every positive definite matrix
// (Judice and Pires 1994).
void LocalForce::solve(const Eigen::VectorXd& wanted) {
    const auto count = f0_.size();
    right_ = wanted;
    right_.noalias() += compliance_ * f0_;
    Eigen::Index fewest = count + 1;
    constexpr int patience = 8, most_rounds = 40;
    for (int round = 0, tries = patience; round < most_rounds; ++round) {
        index_.clear();
        for (int i = 0; i < count; ++i)
            if (pressed_[static_cast<std::size_t>(i)]) index_.push_back(i);
        solve_pressed();
        apart_.noalias() = compliance_ * f_;
        apart_ -= right_;
        const double slack = 1e-12 * right_.lpNorm<Eigen::Infinity>();
        const auto wrong = [&](Eigen::Index i) {
            return pressed_[static_cast<std::size_t>(i)] ? f_[i] < 0.0 : apart_[i] < -slack;
        };
        Eigen::Index many = 0, last = -1;
        for (Eigen::Index i = 0; i < count; ++i)
            if (wrong(i)) ++many, last = i;
        if (many == 0) return;
        if (many < fewest)
            fewest = many, tries = patience;
        else
            --tries;
        for (Eigen::Index i = tries > 0 ? 0 : last; i <= last; ++i)
            if (wrong(i)) pressed_[static_cast<std::size_t>(i)] ^= 1;
    }
    f_ = f_.cwiseMax(0.0);
}

HapticForce LocalForce::at(const Vec6& way) {
    if (f0_.size() == 0) return {};
    wanted_.noalias() = motion_ * way;
    solve(wanted_);
    apart_ = f_ - f0_;
    bent_.noalias() = compliance_ * apart_;
    energy_nj_ = wanted_.dot(f_) - 0.5 * apart_.dot(bent_);
    const Vec6 load = -(motion_.transpose() * f_);
    return {load.head<3>(), load.tail<3>()};
}

}  // namespace hepatica
