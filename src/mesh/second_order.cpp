// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/second_order.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>

#include "mesh/side_table.h"

namespace featuremesh {
namespace {

/// Exponents of the 20 cubic Bernstein polynomials in the four barycentric coordinates.
using Exponents = std::array<int, 4>;

constexpr std::array<Exponents, 20> make_exponents() {
    std::array<Exponents, 20> all{};
    int n = 0;
    for (int i = 3; i >= 0; --i)
        for (int j = 3 - i; j >= 0; --j)
            for (int k = 3 - i - j; k >= 0; --k) all[n++] = {i, j, k, 3 - i - j - k};
    return all;
}
constexpr std::array<Exponents, 20> exponents = make_exponents();

constexpr std::array<int, 64> make_index_of() {
    std::array<int, 64> index{};
    for (int n = 0; n < 20; ++n) index[16 * exponents[n][0] + 4 * exponents[n][1] + exponents[n][2]] = n;
    return index;
}
constexpr std::array<int, 64> index_table = make_index_of();
constexpr int index_of(const Exponents& e) { return index_table[16 * e[0] + 4 * e[1] + e[2]]; }

/// Bernstein coefficients of det J over one sub-tet of an element.
using Coefficients = std::array<double, 20>;

constexpr std::array<int, 4> corner_coefficients{index_of({3, 0, 0, 0}), index_of({0, 3, 0, 0}), index_of({0, 0, 3, 0}),
                                                 index_of({0, 0, 0, 3})};

double smallest_corner(const Coefficients& c) {
    return std::min(
        {c[corner_coefficients[0]], c[corner_coefficients[1]], c[corner_coefficients[2]], c[corner_coefficients[3]]});
}

/// The coefficients over the half in which corner `to` is moved to the middle of (keep, to) (de Casteljau).
Coefficients half(const Coefficients& c, int keep, int to) {
    constexpr std::array<std::array<double, 4>, 4> share{
        {{1, 0, 0, 0}, {0.5, 0.5, 0, 0}, {0.25, 0.5, 0.25, 0}, {0.125, 0.375, 0.375, 0.125}}};
    Coefficients out{};
    for (int n = 0; n < 20; ++n) {
        const int power = exponents[n][to];
        for (int moved = 0; moved <= power; ++moved) {
            Exponents e = exponents[n];
            e[to] -= moved;
            e[keep] += moved;
            out[n] += share[power][moved] * c[index_of(e)];
        }
    }
    return out;
}

struct Piece {
    Coefficients coefficients;
    double bound;
    int depth;
    bool operator<(const Piece& other) const { return bound > other.bound; }
};

Piece piece_of(const Coefficients& c, int depth) { return {c, *std::min_element(c.begin(), c.end()), depth}; }

/// dx/d(lambda_k - lambda_0) = 2 sum over a of lambda_a direction[a][k]
using Directions = std::array<std::array<Vec3, 3>, 4>;

Directions directions_of(const std::array<Vec3, 10>& nodes) {
    // quadratic control points by pair of corners; the middle one so that the curve passes through the mid-side node
    Vec3 control[4][4];
    for (int i = 0; i < 4; ++i) control[i][i] = nodes[i];
    for (int s = 0; s < 6; ++s) {
        const auto [a, b] = tet_sides[s];
        control[a][b] = control[b][a] = 2.0 * nodes[4 + s] - 0.5 * (nodes[a] + nodes[b]);
    }
    Directions direction;
    for (int a = 0; a < 4; ++a)
        for (int k = 0; k < 3; ++k) direction[a][k] = 2.0 * (control[a][k + 1] - control[a][0]);
    return direction;
}

constexpr std::array<std::uint8_t, 64> make_coefficient_table() {
    std::array<std::uint8_t, 64> table{};
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b)
            for (int c = 0; c < 4; ++c) {
                Exponents e{};
                ++e[a], ++e[b], ++e[c];
                table[16 * a + 4 * b + c] = static_cast<std::uint8_t>(index_of(e));
            }
    return table;
}
constexpr std::array<std::uint8_t, 64> coefficient_table = make_coefficient_table();
constexpr int coefficient_of(int a, int b, int c) { return coefficient_table[16 * a + 4 * b + c]; }

/// How many products of directions each coefficient is the mean of.
constexpr std::array<int, 20> make_term_counts() {
    std::array<int, 20> terms{};
    for (const std::uint8_t coefficient : coefficient_table) ++terms[coefficient];
    return terms;
}
constexpr std::array<int, 20> term_counts = make_term_counts();

Coefficients coefficients_of(const Directions& direction) {
    Coefficients sum{};
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
            const Vec3 normal = cross(direction[a][0], direction[b][1]);
            for (int c = 0; c < 4; ++c) sum[coefficient_of(a, b, c)] += dot(normal, direction[c][2]);
        }
    for (int n = 0; n < 20; ++n) sum[n] /= term_counts[n];
    return sum;
}

}  // namespace

std::array<double, 20> jacobian_coefficients(const std::array<Vec3, 10>& nodes) {
    return coefficients_of(directions_of(nodes));
}

// Those at the corners cost least and are the smallest most often: there a bent side leaves its chord most.
double smallest_coefficient(const std::array<Vec3, 10>& nodes, double limit) {
    const Directions direction = directions_of(nodes);
    for (const auto& [x, y, z] : direction)
        if (dot(cross(x, y), z) <= limit) return -std::numeric_limits<double>::infinity();
    const Coefficients all = coefficients_of(direction);
    return *std::min_element(all.begin(), all.end());
}

std::array<Vec3, 10> jacobian_gradient(const std::array<Vec3, 10>& nodes, const std::array<double, 20>& weights) {
    const Directions direction = directions_of(nodes);
    Directions by_direction{};
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
            const Vec3 third = cross(direction[a][0], direction[b][1]);
            for (int c = 0; c < 4; ++c) {
                const int n = coefficient_of(a, b, c);
                const double weight = weights[n] / term_counts[n];
                if (weight == 0) continue;
                by_direction[c][2] += weight * third;
                by_direction[a][0] += weight * cross(direction[b][1], direction[c][2]);
                by_direction[b][1] += weight * cross(direction[c][2], direction[a][0]);
            }
        }
    Vec3 by_control[4][4];
    for (int a = 0; a < 4; ++a)
        for (int k = 0; k < 3; ++k) {
            by_control[a][k + 1] += 2.0 * by_direction[a][k];
            by_control[a][0] -= 2.0 * by_direction[a][k];
        }
    std::array<Vec3, 10> gradient;
    for (int i = 0; i < 4; ++i) gradient[i] = by_control[i][i];
    for (int s = 0; s < 6; ++s) {
        const auto [a, b] = tet_sides[s];
        const Vec3 both = by_control[a][b] + by_control[b][a];
        gradient[4 + s] = 2.0 * both;
        gradient[a] -= 0.5 * both;
        gradient[b] -= 0.5 * both;
    }
    return gradient;
}

double min_scaled_jacobian(const std::array<Vec3, 10>& nodes) {
    constexpr double agreement = 1e-3;
    constexpr int most_pieces = 400;
    const double straight = 6 * signed_volume(nodes[0], nodes[1], nodes[2], nodes[3]);
    if (!(straight > 0)) return -1;
    Coefficients c = jacobian_coefficients(nodes);
    for (double& value : c) value /= straight;
    double sampled = smallest_corner(c);
    std::priority_queue<Piece> open;
    open.push(piece_of(c, 0));
    for (int pieces = 0; pieces < most_pieces; ++pieces) {
        if (sampled <= 0 || open.top().bound >= sampled - agreement) break;
        const Piece worst = open.top();
        open.pop();
        constexpr std::array<std::array<int, 2>, 6> order{{{0, 1}, {2, 3}, {0, 2}, {1, 3}, {0, 3}, {1, 2}}};
        const auto [a, b] = order[worst.depth % 6];
        for (const Coefficients& part : {half(worst.coefficients, a, b), half(worst.coefficients, b, a)}) {
            sampled = std::min(sampled, smallest_corner(part));
            open.push(piece_of(part, worst.depth + 1));
        }
    }
    return std::min(sampled, open.top().bound);
}

std::array<Vec3, 6> triangle_nodes(const Mesh& mesh, TriangleId triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle.index()];
    const auto& [ab, bc, ca] = mesh.triangle_mids[triangle.index()];
    return {mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(ab), mesh.point(bc), mesh.point(ca)};
}

// The normal is quadratic, so its Bernstein coefficients follow from its values at the six nodes.
double min_scaled_jacobian(const std::array<Vec3, 6>& nodes) {
    const auto& [a, b, c, ab, bc, ca] = nodes;
    const Vec3 straight = cross(b - a, c - a);
    const auto along = [&](double la, double lb, double lc) {  // at barycentric coordinates
        const Vec3 to_a = (4 * la - 1) * a + 4 * lb * ab + 4 * lc * ca,
                   to_b = (4 * lb - 1) * b + 4 * la * ab + 4 * lc * bc,
                   to_c = (4 * lc - 1) * c + 4 * lb * bc + 4 * la * ca;
        return dot(cross(to_b - to_a, to_c - to_a), straight) / squared_length(straight);
    };
    const double at_a = along(1, 0, 0), at_b = along(0, 1, 0), at_c = along(0, 0, 1);
    const auto between = [](double middle, double first, double last) { return 2 * middle - (first + last) / 2; };
    return std::min({at_a, at_b, at_c, between(along(0.5, 0.5, 0), at_a, at_b), between(along(0, 0.5, 0.5), at_b, at_c),
                     between(along(0.5, 0, 0.5), at_c, at_a)});
}

std::array<Vec3, 10> tet_nodes(const Mesh& mesh, TetId tet) {
    std::array<Vec3, 10> nodes;
    for (int i = 0; i < 4; ++i) nodes[i] = mesh.point(mesh.tets[tet.index()][i]);
    for (int s = 0; s < 6; ++s) nodes[4 + s] = mesh.point(mesh.tet_mids[tet.index()][s]);
    return nodes;
}

bool has_curved_side(const Mesh& mesh, TetId tet) {
    const auto& corners = mesh.tets[tet.index()];
    const auto& mids = mesh.tet_mids[tet.index()];
    for (int s = 0; s < 6; ++s) {
        const Vec3 &a = mesh.point(corners[tet_sides[s][0]]), &b = mesh.point(corners[tet_sides[s][1]]);
        // a carried straight side is off its middle by rounding only
        if (squared_length(mesh.point(mids[s]) - (a + b) * 0.5) > 1e-20 * squared_length(b - a)) return true;
    }
    return false;
}

namespace {

/// Places of a segment, of a triangle and of a tet.
using Places = std::array<std::size_t, 3>;

/// Segments, triangles and tets by their dimension, from those at `first` on.
template <class Visit>
void for_each_element(const Mesh& mesh, const Places& first, const RunContext& context, Visit visit) {
    RoundWatch watch(context);
    const Places counts{mesh.segments.size(), mesh.triangles.size(), mesh.tets.size()};
    for (int dim = 1; dim <= 3; ++dim)
        for (std::size_t i = first[dim - 1]; i < counts[dim - 1]; ++i) {
            watch();
            visit(dim, i);
        }
}

template <class Visit>
void for_each_side(const Mesh& mesh, const Places& first, const RunContext& context, Visit visit) {
    for_each_element(mesh, first, context, [&](int dim, std::size_t element) {
        const int sides = dim == 1 ? 1 : 3 * (dim - 1);
        for (int side = 0; side < sides; ++side) visit(dim, element, side);
    });
}

std::array<NodeId, 2> side_of(const Mesh& mesh, int dim, std::size_t element, int side) {
    if (dim == 1) return mesh.segments[element];
    if (dim == 2) return {mesh.triangles[element][side], mesh.triangles[element][(side + 1) % 3]};
    return {mesh.tets[element][tet_sides[side][0]], mesh.tets[element][tet_sides[side][1]]};
}

NodeId& mid_of(Mesh& mesh, int dim, std::size_t element, int side) {
    if (dim == 1) return mesh.segment_mids[element];
    if (dim == 2) return mesh.triangle_mids[element][side];
    return mesh.tet_mids[element][side];
}
NodeId mid_of(const Mesh& mesh, int dim, std::size_t element, int side) {
    return mid_of(const_cast<Mesh&>(mesh), dim, element, side);
}

Entity entity_of_element(const Mesh& mesh, int dim, std::size_t element) {
    if (dim == 1) return entity_of(mesh.segment_edges[element]);
    return dim == 2 ? entity_of(mesh.triangle_faces[element]) : entity_of(mesh.tet_solids[element]);
}

Number number_of(const Mesh& mesh, int dim, std::size_t element) {
    const auto& numbers = dim == 1 ? mesh.segment_numbers : dim == 2 ? mesh.triangle_numbers : mesh.tet_numbers;
    return numbers[element];
}

/// Where kept elements were in the arrays of the kept 10-node mesh, found by their numbers: in a table from the first
/// number to the last, or, where that would be far longer than there are elements, in a sorted list.
class KeptPlaces {
  public:
    KeptPlaces(const Mesh& kept, const RunContext& context) {
        std::size_t count = 0;
        for (const auto* numbers : {&kept.segment_numbers, &kept.triangle_numbers, &kept.tet_numbers}) {
            count += numbers->size();
            for (const Number n : *numbers) first_ = std::min(first_, n), last_ = std::max(last_, n);
        }
        if (count == 0) return;
        constexpr std::uint64_t sparse = 8;
        const auto reach = static_cast<std::uint64_t>(last_) - static_cast<std::uint64_t>(first_);
        if (reach < sparse * count) table_.assign(reach + 1, -1);
        for_each_element(kept, {}, context, [&](int dim, std::size_t element) {
            const Number number = number_of(kept, dim, element);
            if (table_.empty())
                list_.emplace_back(number, static_cast<std::int32_t>(element));
            else
                table_[static_cast<std::size_t>(number - first_)] = static_cast<std::int32_t>(element);
        });
        std::sort(list_.begin(), list_.end());
    }
    /// -1 for a new element, of which a corner may be a kept one that was moved.
    std::int32_t of(const Mesh& mesh, int dim, std::size_t element) const {
        const Number number = number_of(mesh, dim, element);
        if (number < first_ || number > last_) return -1;
        if (!table_.empty()) return table_[static_cast<std::size_t>(number - first_)];
        const auto at = std::lower_bound(list_.begin(), list_.end(), std::pair{number, std::int32_t{0}});
        return at->first == number ? at->second : -1;
    }

  private:
    Number first_ = std::numeric_limits<Number>::max(), last_ = std::numeric_limits<Number>::min();
    std::vector<std::int32_t> table_;
    std::vector<std::pair<Number, std::int32_t>> list_;
};

void take_over_node(Mesh& mesh, const Mesh& kept, std::size_t old) {
    mesh.points.push_back(kept.points[old]);
    mesh.entities.push_back(kept.entities[old]);
    mesh.parameters.push_back(kept.parameters[old]);
    mesh.node_numbers.push_back(kept.node_numbers[old]);
}

template <class T>
bool begins_with(const std::vector<T>& list, const std::vector<T>& begin) {
    return list.size() >= begin.size() && std::equal(begin.begin(), begin.end(), list.begin());
}

/// Every side of every element has its mid-side node, and there are no others.
bool has_its_mids(const Mesh& mesh) {
    std::vector<char> is_used(mesh.points.size(), 0);
    const auto use = [&](NodeId mid) {
        if (mid.is_valid()) is_used[mid.index()] = 1;
        return mid.is_valid();
    };
    const auto use_all = [&](const auto& mids) { return std::all_of(mids.begin(), mids.end(), use); };
    return std::all_of(mesh.tet_mids.begin(), mesh.tet_mids.end(), use_all) &&
           std::all_of(mesh.triangle_mids.begin(), mesh.triangle_mids.end(), use_all) && use_all(mesh.segment_mids) &&
           std::all_of(is_used.begin() + static_cast<std::ptrdiff_t>(mesh.corner_count), is_used.end(),
                       [](char used) { return used != 0; });
}

/// All kept elements are there, in front, as they are where none was released, and lack no mid-side node.
bool has_all_in_front(const Mesh& mesh, const Mesh& kept) {
    return begins_with(mesh.tet_numbers, kept.tet_numbers) &&
           begins_with(mesh.triangle_numbers, kept.triangle_numbers) &&
           begins_with(mesh.segment_numbers, kept.segment_numbers) && has_its_mids(kept);
}

/// By corner: an element from `first` on has it.
std::vector<char> corners_of_new(const Mesh& mesh, const Places& first, const RunContext& context) {
    std::vector<char> is_corner(mesh.corner_count, 0);
    const auto mark = [&](const auto& nodes) {
        for (const NodeId n : nodes) is_corner[n.index()] = 1;
    };
    for_each_element(mesh, first, context, [&](int dim, std::size_t element) {
        if (dim == 1)
            mark(mesh.segments[element]);
        else if (dim == 2)
            mark(mesh.triangles[element]);
        else
            mark(mesh.tets[element]);
    });
    return is_corner;
}

template <class T>
void append_from(std::size_t first, const std::vector<T>& list, std::vector<T>& end) {
    end.insert(end.end(), list.begin() + static_cast<std::ptrdiff_t>(first), list.end());
}

/// Then the mid-side nodes of the kept elements follow the corners as they did, and each element is where it was.
/// Returns the places of the first new ones.
Places take_over_all_mids(Mesh& mesh, const Mesh& kept, const RunContext& context, SideTable& sides) {
    const Places first_new{kept.segments.size(), kept.triangles.size(), kept.tets.size()};
    const std::vector<char> lacks_mid = corners_of_new(mesh, first_new, context);
    const auto shift = static_cast<std::int32_t>(mesh.corner_count) - static_cast<std::int32_t>(kept.corner_count);
    append_from(kept.corner_count, kept.points, mesh.points);
    append_from(kept.corner_count, kept.entities, mesh.entities);
    append_from(kept.corner_count, kept.parameters, mesh.parameters);
    append_from(kept.corner_count, kept.node_numbers, mesh.node_numbers);
    context.check_cancelled();
    const auto shifted = [&](NodeId mid) { return NodeId(mid.value + shift); };
    const auto note = [&](NodeId a, NodeId b, NodeId mid) {
        if (lacks_mid[a.index()] && lacks_mid[b.index()]) sides.value(a, b) = mid.value;
    };
    for (std::size_t i = 0; i < kept.segments.size(); ++i) {
        mesh.segment_mids[i] = shifted(kept.segment_mids[i]);
        note(mesh.segments[i][0], mesh.segments[i][1], mesh.segment_mids[i]);
    }
    for (std::size_t i = 0; i < kept.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        auto& mids = mesh.triangle_mids[i];
        std::transform(kept.triangle_mids[i].begin(), kept.triangle_mids[i].end(), mids.begin(), shifted);
        note(a, b, mids[0]), note(b, c, mids[1]), note(c, a, mids[2]);
    }
    RoundWatch watch(context);
    for (std::size_t i = 0; i < kept.tets.size(); ++i) {
        watch();
        const auto& n = mesh.tets[i];
        auto& mids = mesh.tet_mids[i];
        std::transform(kept.tet_mids[i].begin(), kept.tet_mids[i].end(), mids.begin(), shifted);
        if (lacks_mid[n[0].index()] + lacks_mid[n[1].index()] + lacks_mid[n[2].index()] + lacks_mid[n[3].index()] < 2)
            continue;
        for (std::size_t s = 0; s < 6; ++s)
            note(n[static_cast<std::size_t>(tet_sides[s][0])], n[static_cast<std::size_t>(tet_sides[s][1])], mids[s]);
    }
    mesh.next_node_number = std::max(mesh.next_node_number, kept.next_node_number);
    return first_new;
}

/// Takes over the mid-side nodes of kept elements, in their old order. The table gets those at sides that elements
/// which lack one may share. Returns the places of the first elements that may lack one.
Places take_over_kept_mids(Mesh& mesh, const Mesh& kept, const RunContext& context, SideTable& sides) {
    if (has_all_in_front(mesh, kept)) return take_over_all_mids(mesh, kept, context, sides);
    const KeptPlaces places(kept, context);
    const auto old_mid = [&](int dim, std::size_t element, int side) {
        const std::int32_t old = places.of(mesh, dim, element);
        return old >= 0 ? mid_of(kept, dim, static_cast<std::size_t>(old), side) : NodeId();
    };
    std::vector<char> lacks_mid(mesh.corner_count, 0), is_used(kept.points.size(), 0);
    for_each_side(mesh, {}, context, [&](int dim, std::size_t element, int side) {
        if (const NodeId mid = old_mid(dim, element, side); mid.is_valid())
            is_used[mid.index()] = 1;
        else
            for (const NodeId corner : side_of(mesh, dim, element, side)) lacks_mid[corner.index()] = 1;
    });
    std::vector<NodeId> now(kept.points.size());
    RoundWatch watch(context);
    for (std::size_t old = kept.corner_count; old < is_used.size(); ++old) {
        watch();
        if (!is_used[old]) continue;
        now[old] = NodeId(mesh.points.size());
        take_over_node(mesh, kept, old);
    }
    for_each_side(mesh, {}, context, [&](int dim, std::size_t element, int side) {
        const NodeId old = old_mid(dim, element, side);
        if (!old.is_valid()) return;
        mid_of(mesh, dim, element, side) = now[old.index()];
        const auto [a, b] = side_of(mesh, dim, element, side);
        if (lacks_mid[a.index()] && lacks_mid[b.index()]) sides.value(a, b) = now[old.index()].value;
    });
    mesh.next_node_number = std::max(mesh.next_node_number, kept.next_node_number);
    return {};
}

}  // namespace

std::vector<std::array<NodeId, 2>> ends_of_mids(const Mesh& mesh) {
    std::vector<std::array<NodeId, 2>> ends(mesh.node_count() - mesh.corner_count);
    if (ends.empty()) return ends;
    for_each_side(mesh, {}, {}, [&](int dim, std::size_t element, int side) {
        ends[mid_of(mesh, dim, element, side).index() - mesh.corner_count] = side_of(mesh, dim, element, side);
    });
    return ends;
}

std::vector<NodeId> add_mid_side_nodes(Mesh& mesh, const Mesh* kept, const RunContext& context) {
    mesh.order = 2;
    mesh.corner_count = mesh.points.size();
    mesh.segment_mids.resize(mesh.segments.size());
    mesh.triangle_mids.resize(mesh.triangles.size());
    mesh.tet_mids.resize(mesh.tets.size());
    if (kept) {
        const std::size_t nodes = mesh.points.size() + kept->points.size();
        mesh.points.reserve(nodes), mesh.entities.reserve(nodes);
        mesh.parameters.reserve(nodes), mesh.node_numbers.reserve(nodes);
    }
    SideTable sides(mesh.corner_count);
    Places first{};
    if (kept && kept->order == 2) first = take_over_kept_mids(mesh, *kept, context, sides);
    std::vector<NodeId> added;
    for_each_side(mesh, first, context, [&](int dim, std::size_t element, int side) {
        NodeId& own = mid_of(mesh, dim, element, side);
        if (own.is_valid()) return;
        const auto [a, b] = side_of(mesh, dim, element, side);
        std::int32_t& mid = sides.value(a, b);
        if (mid < 0) {
            added.push_back(
                mesh.add_node((mesh.point(a) + mesh.point(b)) * 0.5, entity_of_element(mesh, dim, element)));
            mid = added.back().value;
        }
        own = NodeId(mid);
    });
    return added;
}

}  // namespace featuremesh
