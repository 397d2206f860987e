// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/triangle_patch.h"

#include <algorithm>

namespace featuremesh {

namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool is_counterclockwise(Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 u = b - a, v = c - a;
    return cross(u, v) > 1e-10 * (dot(u, u) + dot(v, v));
}

bool TrianglePatch::can_flip(int t, int i) const {
    const int n = neighbour(t, i);
    if (n < 0) return false;
    const auto& c = corners(t);
    const int a = c[at(i)], b = c[at((i + 1) % 3)], d = c[at((i + 2) % 3)];
    const int e = corners(n)[at(opposite_index(n, t))];
    return !are_one_node(a, e) && is_counterclockwise(point(a), point(b), point(e)) &&
           is_counterclockwise(point(a), point(e), point(d));
}

void TrianglePatch::replace_neighbour(int t, int from, int to) {
    if (t >= 0) neighbours[at(t)][at(opposite_index(t, from))] = to;
}

void TrianglePatch::flip(int t, int i) {
    const int n = neighbour(t, i), j = opposite_index(n, t);
    const int a = corners(t)[at(i)], b = corners(t)[at((i + 1) % 3)], d = corners(t)[at((i + 2) % 3)],
              e = corners(n)[at(j)];
    const int beyond_ab = neighbour(t, (i + 2) % 3), beyond_da = neighbour(t, (i + 1) % 3);
    // In n the corners are e, d, b: opposite d lies the side (b, e), opposite b the side (e, d).
    const int beyond_be = neighbour(n, (j + 1) % 3), beyond_ed = neighbour(n, (j + 2) % 3);
    triangles[at(t)] = {a, b, e}, neighbours[at(t)] = {beyond_be, n, beyond_ab};
    triangles[at(n)] = {a, e, d}, neighbours[at(n)] = {beyond_ed, beyond_da, t};
    replace_neighbour(beyond_be, n, t);
    replace_neighbour(beyond_da, t, n);
    triangle_of[at(a)] = triangle_of[at(b)] = triangle_of[at(e)] = t;
    triangle_of[at(d)] = n;
}

void TrianglePatch::star(int p, std::vector<int>& around) const {
    around.clear();
    const int start = triangle_of[at(p)];
    if (start < 0) return;
    std::size_t steps = 0;
    const auto step = [&] {
        if (++steps > 2 * triangles.size()) throw BrokenPatch();
    };
    // Clockwise to the boundary first, so that the list is counterclockwise without gaps.
    int first = start;
    for (int t = start;;) {
        step();
        const int next = neighbour(t, (corner_index(t, p) + 2) % 3);
        if (next < 0 || next == start) {
            first = next < 0 ? t : start;
            break;
        }
        t = next;
    }
    for (int t = first; t >= 0;) {
        step();
        around.push_back(t);
        t = neighbour(t, (corner_index(t, p) + 1) % 3);
        if (t == first) break;
    }
}

int TrianglePatch::add_triangle(std::array<int, 3> c, std::array<int, 3> around) {
    triangles.push_back(c);
    neighbours.push_back(around);
    return static_cast<int>(triangles.size()) - 1;
}

int TrianglePatch::split_triangle(int t, Vec2 point, Vec3 place) {
    const int p = static_cast<int>(points.size());
    points.push_back(point), places.push_back(place), is_fixed.push_back(0), nodes.push_back(-1),
        triangle_of.push_back(t);
    const auto [a, b, c] = corners(t);
    const auto [na, nb, nc] = neighbours[at(t)];
    wanted.push_back((wanted[at(a)] + wanted[at(b)] + wanted[at(c)]) / 3);
    const int u = static_cast<int>(triangles.size()), v = u + 1;
    triangles[at(t)] = {a, b, p}, neighbours[at(t)] = {u, v, nc};
    add_triangle({b, c, p}, {v, t, na});
    add_triangle({c, a, p}, {t, u, nb});
    replace_neighbour(na, t, u);
    replace_neighbour(nb, t, v);
    triangle_of[at(a)] = triangle_of[at(b)] = t;
    triangle_of[at(c)] = u;
    return p;
}

int TrianglePatch::split_side(int t, int i, Vec2 point, Vec3 place) {
    const int p = static_cast<int>(points.size());
    points.push_back(point), places.push_back(place), is_fixed.push_back(0), nodes.push_back(-1),
        triangle_of.push_back(t);
    const int n = neighbour(t, i), j = opposite_index(n, t);
    const int a = corners(t)[at(i)], b = corners(t)[at((i + 1) % 3)], d = corners(t)[at((i + 2) % 3)],
              e = corners(n)[at(j)];
    const int beyond_ab = neighbour(t, (i + 2) % 3), beyond_da = neighbour(t, (i + 1) % 3);
    const int beyond_be = neighbour(n, (j + 1) % 3), beyond_ed = neighbour(n, (j + 2) % 3);
    wanted.push_back(0.5 * (wanted[at(b)] + wanted[at(d)]));
    const int u = static_cast<int>(triangles.size()), v = u + 1;
    triangles[at(t)] = {a, b, p}, neighbours[at(t)] = {v, u, beyond_ab};
    triangles[at(n)] = {e, d, p}, neighbours[at(n)] = {u, v, beyond_ed};
    add_triangle({a, p, d}, {n, beyond_da, t});
    add_triangle({e, p, b}, {t, beyond_be, n});
    replace_neighbour(beyond_da, t, u);
    replace_neighbour(beyond_be, n, v);
    triangle_of[at(a)] = triangle_of[at(b)] = t;
    triangle_of[at(d)] = triangle_of[at(e)] = n;
    return p;
}

void TrianglePatch::remove_of_three(int p) {
    std::vector<int> around;
    star(p, around);
    const int t = around[0], u = around[1], v = around[2];
    const int i = corner_index(t, p), j = corner_index(u, p), k = corner_index(v, p);
    const int a = corners(t)[at((i + 1) % 3)], b = corners(t)[at((i + 2) % 3)], c = corners(u)[at((j + 2) % 3)];
    const int beyond_ab = neighbour(t, i), beyond_bc = neighbour(u, j), beyond_ca = neighbour(v, k);
    triangles[at(t)] = {a, b, c}, neighbours[at(t)] = {beyond_bc, beyond_ca, beyond_ab};
    replace_neighbour(beyond_bc, u, t);
    replace_neighbour(beyond_ca, v, t);
    triangles[at(u)][0] = triangles[at(v)][0] = -1;
    triangle_of[at(a)] = triangle_of[at(b)] = triangle_of[at(c)] = t;
    triangle_of[at(p)] = -1;
}

void TrianglePatch::compact() {
    std::vector<int> new_index(triangles.size(), -1);
    int count = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (triangles[t][0] >= 0) new_index[t] = count++;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (new_index[t] < 0) continue;
        for (int& n : neighbours[t])
            if (n >= 0) n = new_index[at(n)];
        triangles[at(new_index[t])] = triangles[t];
        neighbours[at(new_index[t])] = neighbours[t];
    }
    triangles.resize(at(count)), neighbours.resize(at(count));
    std::fill(triangle_of.begin(), triangle_of.end(), -1);
    for (int t = 0; t < count; ++t)
        for (const int p : corners(t)) triangle_of[at(p)] = t;
}

}  // namespace featuremesh
