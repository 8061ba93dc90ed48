// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deform/solvers/coupled_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/deform/solvers/coupled_solve.h"
#include "core/deform/solvers/dissection_order.h"

namespace hepatica {
namespace {

// The constants below were measured on the bodies of `bench contacts` and on patients' vessels.
// Ordering, analysis and new memory take as long as this many iterations of conjugate gradients.
constexpr int iterations_of_analysis = 12;
// Up to this many couplings, a solver without them needs few iterations.
constexpr std::size_t few_couplings = 5;
// One iteration of such a solver takes as long as this many multiplications of a factorisation per
// block of the matrix; `n` couplings take about iterations_of_root * sqrt(n) iterations.
constexpr double multiplications_of_iteration = 250.0, iterations_of_root = 16.0;
// Blocks of the factor per block of the matrix: bounds its memory.
constexpr std::size_t most_factor_blocks = 24;
// Multiplications per block by minimum degree above which the body is thick and nested dissection
// is tried too.
constexpr double thick = 8000.0;
constexpr std::size_t rows_per_block = 256;

using NodePair = std::array<int, 2>;

NodePair nodes_of(const CouplingBlock& c) {
    return {std::min(c.first, c.second), std::max(c.first, c.second)};
}

// The coupled pairs of nodes that have no block in the pattern, flattened, ascending.
std::vector<int> pairs_beside(const BlockMatrix& pattern, const CouplingBlocks& coupling) {
    std::vector<NodePair> pairs;
    for (const PairCoupling& pair : coupling)
        for (const CouplingBlock& c : pair.all())
            if (pattern.find(c.first, c.second) < 0) pairs.push_back(nodes_of(c));
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<int> all;
    for (const NodePair& pair : pairs) all.insert(all.end(), pair.begin(), pair.end());
    return all;
}

bool are_pairs_beside(const BlockMatrix& pattern, std::span<const int> pairs) {
    if (pairs.size() % 2 != 0) return false;
    NodePair last{-1, -1};
    for (std::size_t k = 0; k < pairs.size(); k += 2) {
        const NodePair pair{pairs[k], pairs[k + 1]};
        if (pair[0] < 0 || pair[0] >= pair[1] || pair[1] >= pattern.rows() || pair <= last ||
            pattern.find(pair[0], pair[1]) >= 0)
            return false;
        last = pair;
    }
    return true;
}

}  // namespace

void CoupledFactor::heed(const std::stop_token& stop) {
    stop_ = stop;
    factor_.heed(stop);
}

// The union of A's pattern and the pairs.
void CoupledFactor::plan(const BlockMatrix& pattern) {
    const int nodes = pattern.rows();
    std::vector<std::vector<int>> partners(static_cast<std::size_t>(nodes));
    for (std::size_t k = 0; k < pairs_.size(); k += 2) {
        partners[pairs_[k]].push_back(pairs_[k + 1]);
        partners[pairs_[k + 1]].push_back(pairs_[k]);
    }
    rows_ = pattern.row_begin;
    columns_ = pattern.column;
    united_ = {};
    place_.resize(columns_.size());
    for (int i = 0; i < nodes; ++i) {
        std::vector<int>& row = partners[i];
        row.insert(row.end(), columns_.begin() + rows_[i], columns_.begin() + rows_[i + 1]);
        std::ranges::sort(row);
        united_.column.insert(united_.column.end(), row.begin(), row.end());
        united_.row_begin.push_back(static_cast<int>(united_.column.size()));
        united_.diagonal.push_back(united_.find(i, i));
        for (int k = rows_[i]; k < rows_[i + 1]; ++k) place_[k] = united_.find(i, columns_[k]);
    }
    united_.block.assign(united_.column.size(), Mat3::Zero());
    stale_ = true;
    coupled_rows_.clear();
    analyse_pattern();
}

// Splits the coupling into feature pairs with all their blocks in the pattern and others. Pairs
// stay together: without some of their blocks the matrix might not be positive definite.
void CoupledFactor::part(const CouplingBlocks& coupling) {
    inside_.clear();
    outside_.clear();
    for (const PairCoupling& pair : coupling) {
        const bool whole = std::ranges::all_of(pair.all(), [&](const CouplingBlock& c) {
            return united_.find(c.first, c.second) >= 0;
        });
        (whole ? inside_ : outside_).push_back(pair);
    }
}

void CoupledFactor::analyse_pattern() {
    EliminationTree tree = CholeskySolver::analyse(united_);
    const auto blocks = static_cast<double>(united_.column.size());
    if (tree.multiplications > thick * blocks) {
        EliminationTree dissected = hepatica::analyse(united_, dissection_order(united_));
        if (dissected.multiplications < tree.multiplications) tree = std::move(dissected);
    }
    multiplications_ = tree.multiplications;
    factor_blocks_ = tree.factor_blocks;
    factor_.plan(united_, std::move(tree));
    ++analyses_;
}

bool CoupledFactor::pays(const BlockMatrix& matrix, const CouplingBlocks& coupling) {
    if (coupling.size() <= few_couplings) return false;
    // Where the last pattern does not pay, one with as many pairs or more hardly will: an analysis
    // in every step for nothing would cost more than all its iterations.
    if (of_pattern(matrix) && !worth(coupling.size()) &&
        pairs_beside(matrix, coupling).size() >= pairs_.size())
        return false;
    analyse_if_worn(matrix, coupling);
    return worth(coupling.size());
}

// By the last analysis, for that many couplings.
bool CoupledFactor::worth(std::size_t couplings) const {
    const double iterations = iterations_of_root * std::sqrt(static_cast<double>(couplings));
    return factor_blocks_ <= most_factor_blocks * united_.column.size() &&
           multiplications_ <= iterations * multiplications_of_iteration *
                                   static_cast<double>(united_.column.size());
}

void CoupledFactor::analyse_if_worn(const BlockMatrix& matrix, const CouplingBlocks& coupling) {
    if (of_pattern(matrix)) {
        part(coupling);
        const int lacking = static_cast<int>(outside_.size());
        if (spent_ + lacking <= iterations_of_analysis) return;
    }
    pairs_ = pairs_beside(matrix, coupling);
    plan(matrix);
    spent_ = 0;
    part(coupling);
}

// The rows that differ from those of the last solve.
void CoupledFactor::find_changed(const BlockMatrix& matrix, std::span<const int> changed_rows) {
    changed_.assign(changed_rows.begin(), changed_rows.end());
    if (std::exchange(stale_, false)) {
        changed_.resize(static_cast<std::size_t>(matrix.rows()));
        std::iota(changed_.begin(), changed_.end(), 0);
    }
    changed_.insert(changed_.end(), coupled_rows_.begin(), coupled_rows_.end());
    coupled_rows_.clear();
    for (const PairCoupling& pair : inside_)
        for (const CouplingBlock& c : pair.all())
            coupled_rows_.insert(coupled_rows_.end(), {c.first, c.second});
    changed_.insert(changed_.end(), coupled_rows_.begin(), coupled_rows_.end());
    std::ranges::sort(changed_);
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
}

// Writes A and the part of C that is in the pattern.
void CoupledFactor::fill(const BlockMatrix& matrix) {
    parallel_blocks(changed_.size(), rows_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            const int i = changed_[c];
            std::fill(united_.block.begin() + united_.row_begin[i],
                      united_.block.begin() + united_.row_begin[i + 1], Mat3::Zero());
            for (int k = rows_[i]; k < rows_[i + 1]; ++k)
                united_.block[place_[k]] = matrix.block[k];
        }
    });
    united_.alone = matrix.alone;
    for (const PairCoupling& pair : inside_)
        for (const CouplingBlock& c : pair.all()) {
            united_.block[united_.find(c.first, c.second)] += c.block;
            united_.block[united_.find(c.second, c.first)] += c.block;
            if (!united_.alone.empty()) united_.alone[c.first] = united_.alone[c.second] = 0;
        }
}

SolveReport CoupledFactor::solve(const BlockMatrix& matrix, std::span<const int> changed_rows,
                                 const CouplingBlocks& coupling, std::span<const std::uint8_t> held,
                                 std::span<const Vec3> rhs, std::span<Vec3> x,
                                 const SolveLimits& limits) {
    analyse_if_worn(matrix, coupling);
    find_changed(matrix, changed_rows);
    fill(matrix);
    factor_.update(united_, {}, changed_);
    SolveReport report;
    if (outside_.empty()) {
        report = factor_.solve(rhs, x, limits);
        keep_sum_of_residual(united_, {}, held, rhs, x);
    } else {
        const Coupling apply = [&](std::span<const Vec3> d, std::span<Vec3> product) {
            add_product(outside_, d, product);
        };
        report = solve_coupled(factor_, united_, apply, held, rhs, x, limits, stop_);
        spent_ += report.iterations;
    }
    report.method = "coupled factor";
    return report;
}

CoupledMemory CoupledFactor::memory() const {
    if (rows_.empty()) return {};
    CoupledMemory memory{.pairs = pairs_, .numbers = factor_.memory()};
    memory.numbers.push_back(spent_);
    return memory;
}

void CoupledFactor::restore(const BlockMatrix& pattern, const CoupledMemory& memory) {
    CoupledFactor made;
    if (!memory.numbers.empty()) {
        const double spent = memory.numbers.back();
        require_memory(are_pairs_beside(pattern, memory.pairs) && spent >= 0.0 && spent <= 1e9 &&
                       spent == std::floor(spent));
        made.pairs_ = memory.pairs;
        made.spent_ = static_cast<int>(spent);
        made.plan(pattern);
        made.factor_.restore(made.united_, false, {},
                             std::span(memory.numbers).first(memory.numbers.size() - 1));
    } else {
        require_memory(memory.pairs.empty());
    }
    *this = std::move(made);
}

std::size_t CoupledFactor::bytes() const {
    return factor_.bytes() + united_.block.capacity() * sizeof(Mat3) +
           (united_.column.capacity() + united_.row_begin.capacity() + place_.capacity() +
            columns_.capacity()) *
               sizeof(int);
}

}  // namespace hepatica
