// SPDX-License-Identifier: GPL-3.0-or-later
// Connected components by runs along x and union-find, linear in the number of voxels.
#include <algorithm>
#include <functional>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/image/morphology.h"
#include "core/image/voxel_loop.h"

namespace hepatica {

namespace {

// Object voxels in a row: [begin, end).
struct Run {
    int begin;
    int end;
};

constexpr std::size_t rows_between_looks = 1024;

// Runs of every row, numbered in the order of the voxels.
struct RunTable {
    std::vector<Run> runs;
    std::vector<std::size_t> first_of_row;  // one entry more than there are rows

    RunTable(const Mask& mask, bool object, const Job& job) {
        const auto nx = static_cast<std::size_t>(mask.grid.dims[0]);
        const std::size_t rows = nx > 0 ? mask.voxels.size() / nx : 0;
        first_of_row.reserve(rows + 1);
        for (std::size_t row = 0; row < rows; ++row) {
            if (row % rows_between_looks == 0) job.throw_if_cancelled();
            first_of_row.push_back(runs.size());
            const std::uint8_t* voxel = mask.voxels.data() + row * nx;
            for (int x = 0; x < mask.grid.dims[0]; ++x) {
                if ((voxel[x] != 0) != object) continue;
                const int begin = x;
                while (x < mask.grid.dims[0] && (voxel[x] != 0) == object) ++x;
                runs.push_back({begin, x});
            }
        }
        first_of_row.push_back(runs.size());
    }
};

// Unites the touching runs of two rows; with reach 1 diagonal neighbours touch.
void join_rows(const RunTable& table, std::size_t row, std::size_t other, int reach,
               DisjointSets& sets) {
    std::size_t i = table.first_of_row[row];
    std::size_t j = table.first_of_row[other];
    while (i < table.first_of_row[row + 1] && j < table.first_of_row[other + 1]) {
        const Run& a = table.runs[i];
        const Run& b = table.runs[j];
        if (a.begin < b.end + reach && b.begin < a.end + reach)
            sets.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        if (a.end < b.end)
            ++i;
        else
            ++j;
    }
}

DisjointSets joined_runs(const RunTable& table, const Grid& grid, Connectivity connectivity,
                         const Job& job) {
    DisjointSets sets(table.runs.size());
    const bool diagonal = connectivity == Connectivity::all26;
    const int reach = diagonal ? 1 : 0;
    const int ny = grid.dims[1];
    for (int z = 0; z < grid.dims[2]; ++z) {
        job.throw_if_cancelled();
        for (int y = 0; y < ny; ++y) {
            const std::size_t row = static_cast<std::size_t>(z) * ny + y;
            if (y > 0) join_rows(table, row, row - 1, reach, sets);
            if (z == 0) continue;
            join_rows(table, row, row - ny, reach, sets);
            if (diagonal && y > 0) join_rows(table, row, row - ny - 1, reach, sets);
            if (diagonal && y + 1 < ny) join_rows(table, row, row - ny + 1, reach, sets);
        }
    }
    return sets;
}

// Number of voxels of each set, indexed by the set's first run; 0 for other runs.
std::vector<std::size_t> set_sizes(const RunTable& table, DisjointSets& sets) {
    std::vector<std::size_t> sizes(table.runs.size(), 0);
    for (std::size_t i = 0; i < table.runs.size(); ++i)
        sizes[sets.root(static_cast<std::uint32_t>(i))] += table.runs[i].end - table.runs[i].begin;
    return sizes;
}

template <class Visit>
void for_each_run(const RunTable& table, const Grid& grid, const Job& job, const Visit& visit) {
    for (std::size_t row = 0; row + 1 < table.first_of_row.size(); ++row) {
        if (row % rows_between_looks == 0) job.throw_if_cancelled();
        for (std::size_t i = table.first_of_row[row]; i < table.first_of_row[row + 1]; ++i)
            visit(static_cast<std::uint32_t>(i), row * grid.dims[0] + table.runs[i].begin,
                  row * grid.dims[0] + table.runs[i].end);
    }
}

}  // namespace

Components connected_components(const Mask& mask, Connectivity connectivity, const Job& job) {
    const RunTable table(mask, true, job);
    DisjointSets sets = joined_runs(table, mask.grid, connectivity, job);
    const std::vector<std::size_t> sizes = set_sizes(table, sets);
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < sizes.size(); ++i)
        if (sizes[i] > 0) order.push_back(i);
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](auto set) { return sizes[set]; });

    Components components;
    components.labels = filled_image(mask.grid, std::uint32_t{0}, job);
    std::vector<std::uint32_t> label_of(sizes.size(), 0);
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        label_of[order[rank]] = static_cast<std::uint32_t>(rank + 1);
        components.sizes.push_back(sizes[order[rank]]);
    }
    for_each_run(table, mask.grid, job, [&](std::uint32_t run, std::size_t begin, std::size_t end) {
        std::fill(components.labels.voxels.begin() + static_cast<std::ptrdiff_t>(begin),
                  components.labels.voxels.begin() + static_cast<std::ptrdiff_t>(end),
                  label_of[sets.root(run)]);
    });
    return components;
}

Mask largest_components(const Mask& mask, Connectivity connectivity, int count,
                        std::size_t minimum_voxels) {
    const Components components = connected_components(mask, connectivity);
    Mask kept(mask.grid);
    for (std::size_t i = 0; i < kept.voxels.size(); ++i) {
        const std::uint32_t label = components.labels.voxels[i];
        if (label != 0 && label <= static_cast<std::uint32_t>(count) &&
            components.sizes[label - 1] >= minimum_voxels)
            kept.voxels[i] = 1;
    }
    return kept;
}

Mask fill_holes(const Mask& mask, const Job& job) {
    const Grid& grid = mask.grid;
    const RunTable table(mask, false, job);
    DisjointSets sets = joined_runs(table, grid, Connectivity::faces6, job);
    // By first run of a set: whether the set reaches the border.
    std::vector<char> open(table.runs.size(), 0);
    const int ny = grid.dims[1];
    for_each_run(table, grid, job, [&](std::uint32_t run, std::size_t begin, std::size_t) {
        const auto row = static_cast<int>(begin / grid.dims[0] % ny);
        const auto slice = static_cast<int>(begin / grid.dims[0] / ny);
        const Run& r = table.runs[run];
        if (r.begin == 0 || r.end == grid.dims[0] || row == 0 || row == ny - 1 || slice == 0 ||
            slice == grid.dims[2] - 1)
            open[sets.root(run)] = 1;
    });
    Mask filled(grid, 1);
    for_each_run(table, grid, job, [&](std::uint32_t run, std::size_t begin, std::size_t end) {
        if (open[sets.root(run)])
            std::fill(filled.voxels.begin() + static_cast<std::ptrdiff_t>(begin),
                      filled.voxels.begin() + static_cast<std::ptrdiff_t>(end), std::uint8_t{0});
    });
    return filled;
}

}  // namespace hepatica
