// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/flatness_of_four.h"

#include <cstring>

namespace featuremesh {

namespace {

// A vector of GCC and Clang; a machine without such registers does the same by parts. All is inlined and given by
// reference, so that none is handed over in registers that the machine may not have.
typedef double Four __attribute__((vector_size(4 * sizeof(double))));
#define FEATUREMESH_INLINE [[gnu::always_inline]] inline

struct FourVecs {
    Four x, y, z;
};

/// From a point to a corner of each triangle.
FEATUREMESH_INLINE void find_way(const FourTriangles& triangles, std::size_t corner, const Vec3& from, FourVecs& way) {
    const auto* rows = triangles.rows.data() + 3 * corner;
    std::memcpy(&way.x, rows[0].data(), sizeof way.x);
    std::memcpy(&way.y, rows[1].data(), sizeof way.y);
    std::memcpy(&way.z, rows[2].data(), sizeof way.z);
    way.x -= from.x, way.y -= from.y, way.z -= from.z;
}
FEATUREMESH_INLINE void find_cross(const FourVecs& a, const FourVecs& b, FourVecs& product) {
    product.x = a.y * b.z - a.z * b.y, product.y = a.z * b.x - a.x * b.z, product.z = a.x * b.y - a.y * b.x;
}
FEATUREMESH_INLINE void find_dot(const FourVecs& a, const FourVecs& b, Four& product) {
    product = a.x * b.x + a.y * b.y + a.z * b.z;
}
FEATUREMESH_INLINE void raise(Four& most, const Four& to) { most = most < to ? to : most; }
FEATUREMESH_INLINE void lower(Four& least, const Four& to) { least = to < least ? to : least; }

/// Squared lengths of the shortest and of the longest side, given those from the first corner.
struct SideRange {
    Four least, most;
};
FEATUREMESH_INLINE void add_side(const FourVecs& from, const FourVecs& to, SideRange& range) {
    const FourVecs side{to.x - from.x, to.y - from.y, to.z - from.z};
    Four squared;
    find_dot(side, side, squared);
    raise(range.most, squared), lower(range.least, squared);
}

/// The sums of `flatness` and of `Objective::flaw`, in their order.
FEATUREMESH_INLINE void find_flatness(const Vec3& point, const FourTriangles& triangles, const PlainTets& plain,
                                      Four& found) {
    FourVecs u, v, w, n1, n2, n3;
    find_way(triangles, 0, point, u), find_way(triangles, 1, point, v), find_way(triangles, 2, point, w);
    find_cross(v, w, n1), find_cross(w, u, n2), find_cross(u, v, n3);
    Four s1, s2, s3, d12, d13, d23, volume, six_volumes;
    find_dot(n1, n1, s1), find_dot(n2, n2, s2), find_dot(n3, n3, s3);
    find_dot(n1, n2, d12), find_dot(n1, n3, d13), find_dot(n2, n3, d23);
    const Four d01 = s1 + d12 + d13, d02 = d12 + s2 + d23, d03 = d13 + d23 + s3, s0 = d01 + d02 + d03;
    const Four r0 = 1 / s0, r1 = 1 / s1, r2 = 1 / s2, r3 = 1 / s3;
    Four m0 = d01 * d01 * r1, m1 = d12 * d12 * r2;
    raise(m0, d02 * d02 * r2), raise(m0, d03 * d03 * r3);
    raise(m1, d13 * d13 * r3);
    Four flatness = m0 * r0;
    raise(flatness, m1 * r1), raise(flatness, d23 * d23 * r2 * r3);
    find_dot(u, n1, volume), find_dot(n3, w, six_volumes);
    Four uu, vv, ww;
    find_dot(u, u, uu), find_dot(v, v, vv), find_dot(w, w, ww);
    SideRange sides{uu, uu};
    raise(sides.most, vv), raise(sides.most, ww), lower(sides.least, vv), lower(sides.least, ww);
    const Four longest = 4 * sides.most;
    add_side(u, v, sides), add_side(v, w, sides), add_side(w, u, sides);
    constexpr double over = 1 + 1e-9;  // more than rounding does
    const Four shortest = over * plain.shortest_share * plain.shortest_share * sides.most;
    const auto is_plain =
        (volume > 0) & (six_volumes >= 6 * plain.least_volume) &
        (six_volumes * six_volumes >= plain.least_share * plain.least_share * longest * longest * longest) &
        ((flatness < plain.flatness) | (sides.least > shortest));
    found = is_plain ? flatness : -1.0;
}

FEATUREMESH_INLINE void store(const Four& four, std::array<double, 4>& found) {
    std::memcpy(found.data(), &four, sizeof four);
}

FEATUREMESH_INLINE void find_run(const Vec3& point, std::span<const FourTriangles> fours, const PlainTets& plain,
                                 double limit, PlainRun& run) {
    Four most{}, flatness{};
    for (; run.end < fours.size(); ++run.end) {
        find_flatness(point, fours[run.end], plain, flatness);
        const auto ends = (flatness < 0) | (flatness >= limit);
        if ((ends[0] | ends[1] | ends[2] | ends[3]) != 0) break;
        raise(most, flatness);
    }
    store(flatness, run.flatness);
    run.most = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void find_by_avx2(const Vec3& point, const FourTriangles& triangles, const PlainTets& plain,
                                          std::array<double, 4>& found) {
    Four four;
    find_flatness(point, triangles, plain, four);
    store(four, found);
}
[[gnu::target("avx2")]] void find_run_by_avx2(const Vec3& point, std::span<const FourTriangles> fours,
                                              const PlainTets& plain, double limit, PlainRun& run) {
    find_run(point, fours, plain, limit, run);
}
const bool has_avx2 = __builtin_cpu_supports("avx2");
#endif

}  // namespace

std::array<double, 4> flatness_by_parts(const Vec3& point, const FourTriangles& triangles, const PlainTets& plain) {
    Four four;
    find_flatness(point, triangles, plain, four);
    std::array<double, 4> found;
    store(four, found);
    return found;
}

std::array<double, 4> flatness_of_four(const Vec3& point, const FourTriangles& triangles, const PlainTets& plain) {
#if defined(__x86_64__)
    if (has_avx2) {
        std::array<double, 4> found;
        find_by_avx2(point, triangles, plain, found);
        return found;
    }
#endif
    return flatness_by_parts(point, triangles, plain);
}

PlainRun plain_run(const Vec3& point, std::span<const FourTriangles> fours, std::size_t begin, const PlainTets& plain,
                   double limit) {
    PlainRun run{begin, 0, {}};
#if defined(__x86_64__)
    if (has_avx2) {
        find_run_by_avx2(point, fours, plain, limit, run);
        return run;
    }
#endif
    find_run(point, fours, plain, limit, run);
    return run;
}

}  // namespace featuremesh
