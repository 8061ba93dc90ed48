// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of results, compared with those recorded in tests/ROOM/recorded_figures.txt, so that no
// change of the code changes a result unseen. They do not say that a result is right: closed forms,
// ground truth and second methods do. Who changes one on purpose records it anew and says why in
// the commit.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hepatica::test {

class Figures {
  public:
    // One number, compared to a part in a million of itself.
    Figures& add(const std::string& name, double value);

    // Many numbers as three: how many, their Euclidean norm, and a sum with a weight in [-1, 1] for
    // each place, which notices values that trade places. The sum is compared to a part in a
    // million of the norm.
    Figures& add(const std::string& name, std::span<const double> values);
    Figures& add(const std::string& name, std::span<const std::uint8_t> values);

    struct Figure {
        std::string name;
        double value;
        double scale;  // differences are relative to the larger of this and the recorded value
    };
    const std::vector<Figure>& all() const { return figures_; }

  private:
    std::vector<Figure> figures_;
};

// Fails, naming both values, for each figure that differs from the one recorded for this room and
// result, and for figures that only one of them has. With HEPATICA_UPDATE_BASELINES in the
// environment it records them instead (run the test program itself then: ctest runs several at
// once). Names have no blanks.
void expect_recorded(const std::string& room, const std::string& result, const Figures& figures);

}  // namespace hepatica::test
