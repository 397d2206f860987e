// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/field_transfer.h"

#include <algorithm>
#include <cmath>

#include "core/box_tree.h"
#include "core/distances.h"
#include "core/errors.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/messages.h"
#include "mesh/second_order.h"
#include "mesh/triangle_uses.h"

namespace featuremesh {

namespace {

using Barycentric = std::array<double, 4>;
constexpr double inside_tolerance = 1e-9;  // of barycentric coordinates

Barycentric barycentric(const std::array<Vec3, 4>& c, const Vec3& p) {
    const double whole = signed_volume(c[0], c[1], c[2], c[3]);
    Barycentric l{signed_volume(p, c[1], c[2], c[3]) / whole, signed_volume(c[0], p, c[2], c[3]) / whole,
                  signed_volume(c[0], c[1], p, c[3]) / whole, 0};
    l[3] = 1 - l[0] - l[1] - l[2];
    return l;
}

/// Quadratic shape functions: corners, then sides in the order of Mesh::tet_mids.
std::array<double, 10> quadratic(const Barycentric& l) {
    std::array<double, 10> n;
    for (int i = 0; i < 4; ++i) n[i] = l[i] * (2 * l[i] - 1);
    for (int s = 0; s < 6; ++s) n[4 + s] = 4 * l[tet_sides[s][0]] * l[tet_sides[s][1]];
    return n;
}

/// Their derivatives by l_k, taken as if the four were independent.
std::array<double, 10> quadratic_derivative(const Barycentric& l, int k) {
    std::array<double, 10> d{};
    d[k] = 4 * l[k] - 1;
    for (int s = 0; s < 6; ++s) {
        if (tet_sides[s][0] == k) d[4 + s] = 4 * l[tet_sides[s][1]];
        if (tet_sides[s][1] == k) d[4 + s] = 4 * l[tet_sides[s][0]];
    }
    return d;
}

/// Gradients of l_1, l_2, l_3 in space for the axes d x / d l_k (against l_0), as rows of the inverse.
std::array<Vec3, 3> inverse_rows(const std::array<Vec3, 3>& axes) {
    const double det = dot(axes[0], cross(axes[1], axes[2]));
    return {cross(axes[1], axes[2]) / det, cross(axes[2], axes[0]) / det, cross(axes[0], axes[1]) / det};
}

/// One element of the old mesh.
class Element {
  public:
    Element(const Mesh& mesh, std::size_t tet) : mesh_(mesh), tet_(tet) {
        for (int k = 0; k < 4; ++k) corners_[k] = mesh.point(mesh.tets[tet][k]);
        if (mesh.order == 2) nodes_ = tet_nodes(mesh, TetId(tet)), is_curved_ = has_curved_side(mesh, TetId(tet));
    }

    std::vector<NodeId> node_ids() const {
        std::vector<NodeId> ids(mesh_.tets[tet_].begin(), mesh_.tets[tet_].end());
        if (mesh_.order == 2) ids.insert(ids.end(), mesh_.tet_mids[tet_].begin(), mesh_.tet_mids[tet_].end());
        return ids;
    }
    const std::array<Vec3, 4>& corners() const { return corners_; }

    /// Where p is, by the element's own mapping.
    Barycentric locate(const Vec3& p) const {
        Barycentric l = barycentric(corners_, p);
        for (int round = 0; is_curved_ && round < 20; ++round) {
            const auto n = quadratic(l);
            Vec3 rest = p;
            for (int i = 0; i < 10; ++i) rest -= nodes_[i] * n[i];
            const auto rows = inverse_rows(axes(l));
            Vec3 step{dot(rows[0], rest), dot(rows[1], rest), dot(rows[2], rest)};
            const double size = std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
            if (!(size < 1))
                step = size < 1e6 ? step / size : Vec3{};  // far outside the mapping need not be one to one
            l[1] += step.x, l[2] += step.y, l[3] += step.z;
            l[0] = 1 - l[1] - l[2] - l[3];
            if (size < 1e-13) break;
        }
        return l;
    }

    std::vector<double> shape(const Barycentric& l) const {
        if (mesh_.order == 1) return {l.begin(), l.end()};
        const auto n = quadratic(l);
        return {n.begin(), n.end()};
    }

    /// Gradients of the shape functions in space.
    std::vector<Vec3> gradients(const Barycentric& l) const {
        const auto rows = inverse_rows(axes(l));
        std::array<std::vector<double>, 4> by;
        for (int k = 0; k < 4; ++k) {
            if (mesh_.order == 1) {
                by[k].assign(4, 0.0);
                by[k][std::size_t(k)] = 1;
            } else {
                const auto d = quadratic_derivative(l, k);
                by[k].assign(d.begin(), d.end());
            }
        }
        std::vector<Vec3> out(by[0].size());
        for (std::size_t i = 0; i < out.size(); ++i)
            for (int k = 0; k < 3; ++k) out[i] += rows[k] * (by[k + 1][i] - by[0][i]);
        return out;
    }

  private:
    std::array<Vec3, 3> axes(const Barycentric& l) const {
        if (!is_curved_) return {corners_[1] - corners_[0], corners_[2] - corners_[0], corners_[3] - corners_[0]};
        std::array<Vec3, 3> a;
        const auto first = quadratic_derivative(l, 0);
        for (int k = 0; k < 3; ++k) {
            const auto d = quadratic_derivative(l, k + 1);
            for (int i = 0; i < 10; ++i) a[k] += nodes_[i] * (d[i] - first[i]);
        }
        return a;
    }

    const Mesh& mesh_;
    std::size_t tet_;
    std::array<Vec3, 4> corners_;
    std::array<Vec3, 10> nodes_{};
    bool is_curved_ = false;
};

Box box_of_element(const Mesh& mesh, std::size_t tet) {
    Box box;
    for (const NodeId n : mesh.tets[tet]) box.add(mesh.point(n));
    if (mesh.order == 1) return box.grown(1e-9 * box.diagonal());
    for (const NodeId n : mesh.tet_mids[tet]) box.add(mesh.point(n));
    // a parabola leaves the box of its three points by at most an eighth of its second difference
    return box.grown(0.15 * box.diagonal());
}

/// A triangle of the old boundary: the tet behind it and its corners there.
struct OuterTriangle {
    std::size_t tet;
    std::array<int, 3> corners;
};

class Transfer {
  public:
    Transfer(const Mesh& old_mesh, const Mesh& new_mesh, std::span<const double> values, RunContext& context)
        : old_(old_mesh),
          new_(new_mesh),
          values_(values),
          width_(values.size() / old_mesh.node_count()),
          context_(context),
          elements_(element_boxes()),
          outer_(outer_triangles()),
          surface_(surface_boxes()) {
        out_.values.assign(new_.node_count() * width_, 0);
        out_.errors.assign(new_.node_count() * width_, 0);
        out_.sources.assign(new_.node_count(), ValueSource::outside);
    }

    TransferredField run(double same_place) {
        if (outer_.empty()) throw InputError(say<Code::no_values>());
        recover_gradients();
        std::vector<std::int32_t> same = same_nodes(same_place);
        if (same_place > 0) add_nodes_in_place(same_place, same);
        parallel_for(context_, new_.node_count(), 1024, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                if (same[n] >= 0)
                    copy(n, std::size_t(same[n]));
                else if (!interpolate(n))
                    take_nearest(n);
            }
        });
        return std::move(out_);
    }

  private:
    std::vector<Box> element_boxes() const {
        std::vector<Box> boxes;
        for (std::size_t t = 0; t < old_.tets.size(); ++t) boxes.push_back(box_of_element(old_, t));
        return boxes;
    }

    std::vector<OuterTriangle> outer_triangles() const {
        std::vector<OuterTriangle> outer;
        TriangleUses uses(old_);
        for (std::size_t b = 0; b < uses.bucket_count(); ++b)
            uses.visit_bucket(b, [&](std::span<const TriangleUse> meeting) {
                const auto is_before = [&](const TriangleUse& use) {
                    return use.is_tet() && use.is_forward() != meeting[0].is_forward();
                };
                if (!meeting[0].is_tet() || std::any_of(meeting.begin(), meeting.end(), is_before)) return;
                OuterTriangle triangle{meeting[0].element(), {}};
                const std::array<std::size_t, 3> nodes{b, meeting[0].middle, meeting[0].largest};
                for (int k = 0; k < 3; ++k)
                    for (int c = 0; c < 4; ++c)
                        if (old_.tets[triangle.tet][c].index() == nodes[std::size_t(k)])
                            triangle.corners[std::size_t(k)] = c;
                outer.push_back(triangle);
            });
        return outer;
    }

    std::array<Vec3, 3> points_of(const OuterTriangle& t) const {
        const auto& tet = old_.tets[t.tet];
        return {old_.point(tet[t.corners[0]]), old_.point(tet[t.corners[1]]), old_.point(tet[t.corners[2]])};
    }

    std::vector<Box> surface_boxes() const {
        std::vector<Box> boxes;
        for (const OuterTriangle& t : outer_) {
            Box& box = boxes.emplace_back();
            for (const Vec3& p : points_of(t)) box.add(p);
        }
        return boxes;
    }

    void recover_gradients() {
        gradients_.assign(old_.corner_count * width_, Vec3{});
        std::vector<double> weights(old_.corner_count, 0);
        for (std::size_t t = 0; t < old_.tets.size(); ++t) {
            const Element element(old_, t);
            const auto nodes = element.node_ids();
            const auto& c = element.corners();
            const double volume = std::abs(signed_volume(c[0], c[1], c[2], c[3]));
            if (volume == 0) continue;  // no gradient either; other makers' meshes may have such tets
            for (int k = 0; k < 4; ++k) {
                Barycentric at{};
                at[k] = 1;
                const auto slopes = element.gradients(at);
                weights[nodes[std::size_t(k)].index()] += volume;
                for (std::size_t w = 0; w < width_; ++w)
                    for (std::size_t i = 0; i < nodes.size(); ++i)
                        gradients_[nodes[std::size_t(k)].index() * width_ + w] +=
                            slopes[i] * (volume * value(nodes[i].index(), w));
            }
        }
        for (std::size_t n = 0; n < weights.size(); ++n)
            for (std::size_t w = 0; w < width_; ++w)
                if (weights[n] > 0) gradients_[n * width_ + w] = gradients_[n * width_ + w] / weights[n];
    }

    double value(std::size_t node, std::size_t w) const { return values_[node * width_ + w]; }

    // By new node: the old one it is, or -1.
    std::vector<std::int32_t> same_nodes(double same_place) const {
        std::vector<std::int32_t> same(new_.node_count(), -1);
        const auto by_number = ordered(old_.node_numbers);
        for (std::size_t n = 0; n < same.size(); ++n) {
            const std::int32_t old = found(by_number, new_.node_numbers[n]);
            if (old >= 0 && distance(old_.points[std::size_t(old)], new_.points[n]) <= same_place) same[n] = old;
        }
        const auto tets = ordered(old_.tet_numbers);
        for (std::size_t t = 0; t < new_.tets.size() && old_.order == new_.order; ++t)
            if (const std::int32_t old = found(tets, new_.tet_numbers[t]); old >= 0)
                take_congruent(std::size_t(old), t, same);
        return same;
    }

    // Places tell where numbers do not: results have meshes that are numbered anew.
    void add_nodes_in_place(double same_place, std::vector<std::int32_t>& same) const {
        std::vector<Box> boxes(old_.node_count());
        for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i].add(old_.points[i]);
        const BoxTree places(boxes);
        parallel_for(context_, same.size(), 1024, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                if (same[n] >= 0) continue;
                const auto squared = [&](std::int32_t i) {
                    const double d = distance(old_.points[std::size_t(i)], new_.points[n]);
                    return d * d;
                };
                const std::int32_t nearest = places.nearest(new_.points[n], squared);
                if (squared(nearest) <= same_place * same_place) same[n] = nearest;
            }
        });
    }

    using Order = std::vector<std::pair<Number, std::int32_t>>;
    static Order ordered(const std::vector<Number>& numbers) {
        Order order;
        for (std::size_t i = 0; i < numbers.size(); ++i) order.emplace_back(numbers[i], std::int32_t(i));
        std::sort(order.begin(), order.end());
        return order;
    }
    static std::int32_t found(const Order& order, Number number) {
        const auto it = std::lower_bound(order.begin(), order.end(), std::pair<Number, std::int32_t>{number, 0});
        return it != order.end() && it->first == number ? it->second : -1;
    }

    void take_congruent(std::size_t old_tet, std::size_t new_tet, std::vector<std::int32_t>& same) const {
        const auto before = Element(old_, old_tet).node_ids(), after = Element(new_, new_tet).node_ids();
        for (std::size_t i = 0; i < before.size(); ++i)
            if (old_.node_numbers[before[i].index()] != new_.node_numbers[after[i].index()]) return;
        for (const auto& [i, j] : tet_sides) {
            const double was = distance(old_.point(before[std::size_t(i)]), old_.point(before[std::size_t(j)]));
            const double is = distance(new_.point(after[std::size_t(i)]), new_.point(after[std::size_t(j)]));
            if (std::abs(was - is) > 1e-9 * was) return;
        }
        for (std::size_t i = 0; i < before.size(); ++i) same[after[i].index()] = before[i].value;
    }

    void copy(std::size_t n, std::size_t old) {
        std::copy_n(values_.begin() + std::ptrdiff_t(old * width_), width_,
                    out_.values.begin() + std::ptrdiff_t(n * width_));
        out_.sources[n] = ValueSource::same_node;
    }

    bool interpolate(std::size_t n) {
        const Vec3& p = new_.points[n];
        std::int32_t best = -1;
        double deepest = -inside_tolerance;
        Barycentric place{};
        elements_.visit_around(p, [&](std::int32_t t) {
            const Barycentric l = Element(old_, std::size_t(t)).locate(p);
            if (!std::all_of(l.begin(), l.end(), [](double x) { return std::isfinite(x); })) return;  // without volume
            const double depth = *std::min_element(l.begin(), l.end());
            if (depth < deepest || (depth == deepest && best >= 0 && t > best) || !(depth > -inside_tolerance)) return;
            deepest = depth, best = t, place = l;
        });
        if (best < 0) return false;
        const Element element(old_, std::size_t(best));
        fill_in(n, element, place);
        for (std::size_t w = 0; w < width_; ++w)
            out_.errors[n * width_ + w] = std::abs(out_.values[n * width_ + w] - recovered(element, p, w));
        out_.sources[n] = ValueSource::inside;
        return true;
    }

    void fill_in(std::size_t n, const Element& element, const Barycentric& place) {
        const auto nodes = element.node_ids();
        const auto shape = element.shape(place);
        for (std::size_t w = 0; w < width_; ++w)
            for (std::size_t i = 0; i < nodes.size(); ++i)
                out_.values[n * width_ + w] += shape[i] * value(nodes[i].index(), w);
    }

    // u* of the header.
    double recovered(const Element& element, const Vec3& p, std::size_t w) const {
        const Barycentric l = barycentric(element.corners(), p);
        const auto nodes = element.node_ids();
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i)
            sum += l[i] * (value(nodes[i].index(), w) +
                           0.5 * dot(gradients_[nodes[i].index() * width_ + w], p - element.corners()[i]));
        return sum;
    }

    void take_nearest(std::size_t n) {
        const Vec3& p = new_.points[n];
        const auto nearest_in = [&](std::int32_t t) {
            const auto [a, b, c] = points_of(outer_[std::size_t(t)]);
            return nearest_in_triangle(p, a, b, c);
        };
        const std::int32_t nearest =
            surface_.nearest(p, [&](std::int32_t t) { return nearest_in(t).squared_distance; });
        const OuterTriangle& triangle = outer_[std::size_t(nearest)];
        const auto [a, b, c] = points_of(triangle);
        const std::array<double, 3> l = nearest_in(nearest).weights;
        const Vec3 foot = a * l[0] + b * l[1] + c * l[2];
        Barycentric place{};
        for (std::size_t k = 0; k < 3; ++k) place[std::size_t(triangle.corners[k])] = l[k];
        const Element element(old_, triangle.tet);
        fill_in(n, element, place);
        const auto nodes = element.node_ids();
        for (std::size_t w = 0; w < width_; ++w) {
            double change = 0;
            for (std::size_t i = 0; i < 4; ++i)
                change += place[i] * dot(gradients_[nodes[i].index() * width_ + w], p - foot);
            out_.errors[n * width_ + w] = std::abs(change);
        }
    }

    const Mesh& old_;
    const Mesh& new_;
    std::span<const double> values_;
    std::size_t width_;
    RunContext& context_;
    BoxTree elements_;
    std::vector<OuterTriangle> outer_;
    BoxTree surface_;
    std::vector<Vec3> gradients_;  // (corner nodes, components)
    TransferredField out_;
};

}  // namespace

TransferredField transfer_field(const Mesh& old_mesh, const Mesh& new_mesh, std::span<const double> values,
                                double same_place, RunContext& context) {
    if (old_mesh.tets.empty() || old_mesh.node_count() == 0) throw InputError(say<Code::no_values>());
    if (values.empty() || values.size() % old_mesh.node_count() != 0)
        throw InputError(say<Code::values_misfit>(values.size(), old_mesh.node_count()));
    return Transfer(old_mesh, new_mesh, values, context).run(same_place);
}

}  // namespace featuremesh
