// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "mesh/second_order.h"
#include "volume/delaunay/triangulation.h"
#include "volume/tets/circumsphere.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

/// Fewer are triangulated as a whole. The parts depend on the points alone, never on the number of threads.
constexpr std::size_t most_points_of_a_part = 24000;
/// A part has at least this share of the points that were divided.
constexpr double least_share = 0.25;
constexpr std::size_t tets_per_chunk = 1 << 13;

/// Points of one part of space between the cuts so far, and their Delaunay tets.
struct Part {
    std::vector<int> points;
    Box box;
    Triangulation triangulation;
    int first_half = -1, level = 0;  ///< the halves stand in a row; -1 for a part that is not divided
};

/// Cuts the points in two across their longest extent that can be cut; points in one plane across it stay together.
class Division {
  public:
    Division(std::span<const Vec3> points, const RunContext& context) : points_(points), context_(context) {
        Part whole;
        whole.points.resize(points.size());
        std::iota(whole.points.begin(), whole.points.end(), 0);
        parts_.push_back(std::move(whole));
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            for (const int p : parts_[i].points) parts_[i].box.add(points_[p]);
            if (parts_[i].points.size() > most_points_of_a_part) divide(i);
        }
    }

    std::vector<Part> take() { return std::move(parts_); }

  private:
    void divide(std::size_t i) {
        context_.check_cancelled();
        const Vec3 size = parts_[i].box.size();
        std::array<int, 3> axes{0, 1, 2};
        std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size[a] > size[b]; });
        for (const int axis : axes)
            if (divide(i, axis)) return;
    }

    bool divide(std::size_t i, int axis) {
        std::vector<double> places;
        for (const int p : parts_[i].points) places.push_back(points_[p][axis]);
        const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
        std::nth_element(places.begin(), middle, places.end());
        std::array<Part, 2> halves;
        for (const int p : parts_[i].points) halves[points_[p][axis] >= *middle].points.push_back(p);
        const auto least = static_cast<std::size_t>(least_share * static_cast<double>(places.size()));
        if (std::min(halves[0].points.size(), halves[1].points.size()) < least) return false;
        parts_[i].points = {};
        parts_[i].first_half = static_cast<int>(parts_.size());
        for (Part& half : halves) {
            half.level = parts_[i].level + 1;
            parts_.push_back(std::move(half));
        }
        return true;
    }

    std::span<const Vec3> points_;
    const RunContext& context_;
    std::vector<Part> parts_;
};

/// Which tets of a half are tets of the whole for certain: no point of the other half can be in their circumspheres.
/// The answer "no" may be wrong, "yes" never is.
class FinalTets {
  public:
    FinalTets(std::span<const Vec3> points, const Triangulation& half, const Box& other)
        : points_(points), half_(half), other_(other) {
        for (int axis = 0; axis < 3; ++axis)
            largest_ = std::max({largest_, std::abs(other.low[axis]), std::abs(other.high[axis])});
    }

    bool is_final(std::size_t t) const {
        const auto& [a, b, c, d] = half_.tets[t];
        const Vec3 u = points_[b] - points_[a], v = points_[c] - points_[a], w = points_[d] - points_[a];
        const double squared = std::max({squared_length(u), squared_length(v), squared_length(w)});
        // flatter ones have a sphere that rounding may put anywhere
        if (!(dot(u, cross(v, w)) > 1e-6 * squared * std::sqrt(squared))) return false;
        return is_outside(circumsphere(points_[a], points_[b], points_[c], points_[d]));
    }

    /// The same of the endless cell outside a facet of the hull: what is before the facet's plane, and its circle.
    bool is_final(std::size_t t, int facet) const {
        const auto& tet = half_.tets[t];
        const Vec3 &a = points_[tet[tet_faces[facet][0]]], &b = points_[tet[tet_faces[facet][1]]],
                   &c = points_[tet[tet_faces[facet][2]]];
        const Vec3 u = b - a, v = c - a, n = cross(u, v);
        // of long thin triangles not even the normal is known
        if (!(length(n) > 1e-6 * std::max(squared_length(u), squared_length(v)))) return false;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(a[axis] == b[axis] && a[axis] == c[axis])) continue;
            const double beyond = n[axis] > 0 ? other_.high[axis] - a[axis] : a[axis] - other_.low[axis];
            return beyond < 0 || (beyond == 0 && is_outside(circle(a, u, v, n)));
        }
        double beyond = 0, scale = 0;
        for (int axis = 0; axis < 3; ++axis) {
            beyond += n[axis] * ((n[axis] > 0 ? other_.high[axis] : other_.low[axis]) - a[axis]);
            scale += std::abs(n[axis]) * (largest_ + std::abs(a[axis]));
        }
        return beyond < -1e-8 * scale;
    }

  private:
    static Ball circle(const Vec3& a, const Vec3& u, const Vec3& v, const Vec3& n) {
        const Vec3 offset =
            (cross(n, u) * squared_length(v) + cross(v, n) * squared_length(u)) / (2 * squared_length(n));
        return {a + offset, length(offset)};
    }

    bool is_outside(const Ball& ball) const {
        double squared = 0;
        for (int axis = 0; axis < 3; ++axis)
            squared += std::pow(
                std::max({other_.low[axis] - ball.center[axis], ball.center[axis] - other_.high[axis], 0.0}), 2);
        return std::sqrt(squared) > ball.radius * (1 + 1e-6) + 1e-12 * largest_;
    }

    std::span<const Vec3> points_;
    const Triangulation& half_;
    const Box& other_;
    double largest_ = 0;
};

/// Joins the triangulations of two halves. Tets of a half that are certainly Delaunay in the whole are taken as they
/// are. The points of all other tets are triangulated once more, by themselves, and fill the room between.
class Joining {
  public:
    Joining(std::span<const Vec3> points, const Part& first, const Part& second, RunContext& context)
        : points_(points), halves_{Half{first}, Half{second}}, context_(context) {}

    Triangulation run() {
        each_half([&](int h) { look_for_final(halves_[h], halves_[1 - h].part.box), collect(halves_[h]); });
        const Triangulation filling = triangulate_between();
        const std::vector<std::uint8_t> is_wanted = wanted_of(filling);
        std::array<std::size_t, 4> first{};
        for (int h = 0; h < 2; ++h) first[h + 1] = first[h] + count(halves_[h].is_final);
        first[3] = first[2] + count(is_wanted);
        joined_.tets.resize(first[3]);
        joined_.neighbours.resize(first[3]);
        each_half(
            [&](int h) { halves_[h].open = append(halves_[h].part.triangulation, halves_[h].is_final, first[h]); });
        std::vector<OpenFacet> open = append(filling, is_wanted, first[2]);
        for (const Half& half : halves_) open.insert(open.end(), half.open.begin(), half.open.end());
        link(std::move(open));
        return std::move(joined_);
    }

  private:
    struct OpenFacet {
        std::array<int, 3> corners;
        int tet, facet;
    };
    struct Half {
        const Part& part;
        std::vector<std::uint8_t> is_final{}, is_facet_final{};  // by tet; by tet, a bit for each facet
        std::vector<Tet> unsure{};                               // tets that are not final
        std::vector<int> between{};  // points with a cell that is not; all others keep their tets in the whole
        std::vector<OpenFacet> open{};
    };

    template <class Work>
    void each_half(Work work) {
        parallel_for(context_, 2, 1, [&](std::size_t h, std::size_t) { work(static_cast<int>(h)); });
    }
    static std::size_t count(std::span<const std::uint8_t> flags) {
        return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
    }

    void look_for_final(Half& of, const Box& other) {
        const Triangulation& half = of.part.triangulation;
        const FinalTets final(points_, half, other);
        of.is_final.assign(half.tets.size(), 0);
        of.is_facet_final.assign(half.tets.size(), 0);
        parallel_for(context_, half.tets.size(), tets_per_chunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                of.is_final[t] = final.is_final(t);
                for (int k = 0; k < 4; ++k)
                    of.is_facet_final[t] |= (half.neighbours[t][k] < 0 && final.is_final(t, k)) << k;
            }
        });
    }

    void collect(Half& of) const {
        const Triangulation& half = of.part.triangulation;
        enum : std::uint8_t { has_no_tet, is_closed, is_open };
        std::vector<std::uint8_t> state(points_.size(), has_no_tet);
        for (std::size_t t = 0; t < half.tets.size(); ++t) {
            for (const int c : half.tets[t])
                if (state[c] == has_no_tet || !of.is_final[t]) state[c] = of.is_final[t] ? is_closed : is_open;
            if (!of.is_final[t]) of.unsure.push_back(sorted(half.tets[t]));
        }
        for (std::size_t t = 0; t < half.tets.size(); ++t)
            for (int k = 0; k < 4; ++k)
                if (half.neighbours[t][k] < 0 && !(of.is_facet_final[t] >> k & 1))
                    for (const int i : tet_faces[k]) state[half.tets[t][i]] = is_open;
        for (const int p : of.part.points)
            if (state[p] != is_closed) of.between.push_back(p);
        std::sort(of.unsure.begin(), of.unsure.end());
    }

    Triangulation triangulate_between() {
        std::vector<int> numbers = halves_[0].between;
        numbers.insert(numbers.end(), halves_[1].between.begin(), halves_[1].between.end());
        std::vector<Vec3> places;
        places.reserve(numbers.size());
        for (const int p : numbers) places.push_back(points_[p]);
        GrowingDelaunay delaunay;
        delaunay.insert(places, context_);
        return delaunay.tets(context_, numbers);
    }

    /// Which tets of the filling are tets of the whole: those with corners in both halves, and those that one of the
    /// halves has, too. All others lie in the room of final tets, which never reach across the cut.
    std::vector<std::uint8_t> wanted_of(const Triangulation& filling) const {
        std::vector<std::uint8_t> is_second(points_.size(), 0);
        for (const int p : halves_[1].between) is_second[p] = 1;
        std::vector<std::uint8_t> is_wanted(filling.tets.size(), 0);
        parallel_for(context_, filling.tets.size(), tets_per_chunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                const Tet& c = filling.tets[t];
                const int in_second = is_second[c[0]] + is_second[c[1]] + is_second[c[2]] + is_second[c[3]];
                const std::vector<Tet>& unsure = halves_[in_second == 4].unsure;
                is_wanted[t] = in_second % 4 != 0 || std::binary_search(unsure.begin(), unsure.end(), sorted(c));
            }
        });
        return is_wanted;
    }

    /// The facets whose tet beyond is not taken, or that have none.
    std::vector<OpenFacet> append(const Triangulation& part, std::span<const std::uint8_t> is_taken,
                                  std::size_t first) {
        std::vector<int> place(part.tets.size(), -1);
        int next = static_cast<int>(first);
        for (std::size_t t = 0; t < part.tets.size(); ++t)
            if (is_taken[t]) place[t] = next++;
        std::vector<OpenFacet> open;
        for (std::size_t t = 0; t < part.tets.size(); ++t) {
            if (!is_taken[t]) continue;
            const auto at = static_cast<std::size_t>(place[t]);
            joined_.tets[at] = part.tets[t];
            for (int k = 0; k < 4; ++k) {
                const int other = part.neighbours[t][k];
                joined_.neighbours[at][k] = other >= 0 ? place[other] : -1;
                if (joined_.neighbours[at][k] < 0) open.push_back(facet_of(place[t], k));
            }
        }
        return open;
    }

    OpenFacet facet_of(int tet, int k) const {
        const Tet& corners = joined_.tets[tet];
        OpenFacet facet{{corners[tet_faces[k][0]], corners[tet_faces[k][1]], corners[tet_faces[k][2]]}, tet, k};
        std::sort(facet.corners.begin(), facet.corners.end());
        return facet;
    }

    void link(std::vector<OpenFacet> open) {
        std::sort(open.begin(), open.end(), [](const OpenFacet& a, const OpenFacet& b) {
            return std::tie(a.corners, a.tet) < std::tie(b.corners, b.tet);
        });
        for (std::size_t i = 0; i + 1 < open.size(); ++i) {
            const OpenFacet &a = open[i], &b = open[i + 1];
            if (a.corners != b.corners) continue;
            joined_.neighbours[a.tet][a.facet] = b.tet;
            joined_.neighbours[b.tet][b.facet] = a.tet;
        }
    }

    std::span<const Vec3> points_;
    std::array<Half, 2> halves_;
    RunContext& context_;
    Triangulation joined_;
};

void triangulate(Part& part, std::span<const Vec3> points, RunContext& context) {
    std::vector<Vec3> places;
    places.reserve(part.points.size());
    for (const int p : part.points) places.push_back(points[p]);
    GrowingDelaunay delaunay;
    delaunay.insert(places, context);
    part.triangulation = delaunay.tets(context, part.points);
}

void join_halves(Part& whole, std::vector<Part>& parts, std::span<const Vec3> points, RunContext& context) {
    Part &first = parts[whole.first_half], &second = parts[whole.first_half + 1];
    whole.triangulation = Joining(points, first, second, context).run();
    whole.points = std::move(first.points);
    whole.points.insert(whole.points.end(), second.points.begin(), second.points.end());
    first = second = {};
}

}  // namespace

Triangulation delaunay(std::span<const Vec3> points, RunContext& context) {
    std::vector<Part> parts = Division(points, context).take();
    std::vector<std::vector<int>> at_level;
    std::vector<int> undivided;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].first_half < 0) {
            undivided.push_back(static_cast<int>(i));
            continue;
        }
        at_level.resize(static_cast<std::size_t>(parts[i].level) + 1);
        at_level.back().push_back(static_cast<int>(i));
    }
    parallel_for(context, undivided.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) triangulate(parts[undivided[i]], points, context);
    });
    for (auto level = at_level.rbegin(); level != at_level.rend(); ++level)
        parallel_for(context, level->size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) join_halves(parts[(*level)[i]], parts, points, context);
        });
    return std::move(parts.front().triangulation);
}

}  // namespace featuremesh
