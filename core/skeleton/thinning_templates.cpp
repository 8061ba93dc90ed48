// SPDX-License-Identifier: GPL-3.0-or-later
// The 62 templates, built by symmetry from one of each class.
#include "core/skeleton/thinning_templates.h"

#include "core/skeleton/simple_point.h"

namespace hepatica {

namespace {

using Offset = std::array<int, 3>;

std::uint32_t bit_of(const Offset& o) {
    return 1u << neighbour_bit(o[0], o[1], o[2]);
}

template <class Predicate>
std::uint32_t offsets_where(Predicate predicate) {
    std::uint32_t bits = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if ((x != 0 || y != 0 || z != 0) && predicate(Offset{x, y, z}))
                    bits |= bit_of({x, y, z});
    return bits;
}

class Builder {
  public:
    explicit Builder(const PaddedObject& object) : object_(object) {}

    // A: one face is background, the voxel opposite is object.
    void add_class_a() {
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                ThinningTemplate t;
                t.background = offsets_where([&](const Offset& o) { return o[axis] == sign; });
                require(t, axis, -sign);
                templates.push_back(t);
            }
    }

    // B: the edge between directions s and t is background, the two voxels opposite are object.
    void add_class_b() {
        for (int a = 0; a < 3; ++a)
            for (int b = a + 1; b < 3; ++b)
                for (const int s : {-1, 1})
                    for (const int t : {-1, 1}) {
                        ThinningTemplate edge;
                        edge.background = offsets_where([&](const Offset& o) {
                            return o[a] != -s && o[b] != -t && (o[a] != 0 || o[b] != 0);
                        });
                        require(edge, a, -s);
                        require(edge, b, -t);
                        templates.push_back(edge);
                    }
    }

    // C: one corner is background, the three voxels opposite are object.
    void add_class_c() {
        for (const int sx : {-1, 1})
            for (const int sy : {-1, 1})
                for (const int sz : {-1, 1}) {
                    ThinningTemplate t;
                    t.background = offsets_where(
                        [&](const Offset& o) { return o[0] != -sx && o[1] != -sy && o[2] != -sz; });
                    require(t, 0, -sx);
                    require(t, 1, -sy);
                    require(t, 2, -sz);
                    templates.push_back(t);
                }
    }

    // D: the voxel is joined to an edge neighbour in the plane normal to an axis; of its two
    // neighbours along that axis at most one is object.
    void add_class_d() {
        for (int axis = 0; axis < 3; ++axis)
            for (const int s : {-1, 1})
                for (const int t : {-1, 1})
                    for (const int along : {0, -1, 1}) add_hanging(axis, s, t, along);
    }

    std::vector<ThinningTemplate> templates;

  private:
    static Offset unit(int axis, int sign) {
        Offset o{0, 0, 0};
        o[axis] = sign;
        return o;
    }
    std::ptrdiff_t step(const Offset& o, int factor = 1) const {
        return object_.step(factor * o[0], factor * o[1], factor * o[2]);
    }

    // Requires the face neighbour in a direction, and the voxel behind it if the direction is W, S
    // or D.
    void require(ThinningTemplate& t, int axis, int sign) const {
        const Offset o = unit(axis, sign);
        t.object |= bit_of(o);
        if (sign < 0) t.followed.push_back(step(o, 2));
    }

    void add_hanging(int axis, int s, int t, int along) {
        const int a = axis == 0 ? 1 : 0;
        const int b = axis == 2 ? 1 : 2;
        Offset hook{0, 0, 0};
        hook[a] = s;
        hook[b] = t;
        ThinningTemplate d;
        d.object = bit_of(hook);
        d.background = offsets_where([&](const Offset& o) { return o[a] == -s || o[b] == -t; }) |
                       bit_of(unit(a, s)) | bit_of(unit(b, t));
        for (const int sign : {-1, 1}) {
            if (sign == along)
                require(d, axis, sign);
            else
                d.background |= bit_of(unit(axis, sign));
        }
        const bool points_south = hook[1] == -1 || (axis == 1 && hook[0] == -1);
        if (points_south)
            for (const auto& [i, j] : {std::pair{0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}}) {
                Offset o{0, 0, 0};
                o[a] = i * s;
                o[b] = j * t;
                d.any_of.push_back(step(o));
            }
        templates.push_back(d);
    }

    const PaddedObject& object_;
};

}  // namespace

std::vector<ThinningTemplate> thinning_templates(const PaddedObject& object) {
    Builder builder(object);
    builder.add_class_a();
    builder.add_class_b();
    builder.add_class_c();
    builder.add_class_d();
    return builder.templates;
}

bool is_protected_end(std::uint32_t neighbourhood) {
    constexpr std::uint32_t w = 1u << neighbour_bit(-1, 0, 0), e = 1u << neighbour_bit(1, 0, 0),
                            s = 1u << neighbour_bit(0, -1, 0), n = 1u << neighbour_bit(0, 1, 0),
                            d = 1u << neighbour_bit(0, 0, -1), u = 1u << neighbour_bit(0, 0, 1);
    if (is_line_end(neighbourhood)) return true;
    const std::uint32_t around = neighbourhood & ~centre_bit;
    return around == (s | e) || around == (s | u) || around == (w | n) || around == (w | u) ||
           around == (d | n) || around == (d | e);
}

}  // namespace hepatica
