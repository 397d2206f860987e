// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/fill_face.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/errors.h"
#include "core/message.h"
#include "core/messages.h"
#include "core/sorted_pair.h"
#include "surface/chart.h"
#include "surface/folded_triangles.h"
#include "surface/opposite_places.h"
#include "surface/patch_improvement.h"
#include "surface/seeds.h"
#include "surface/triangle_patch.h"

namespace featuremesh {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// An angle that the improvement tries to reach everywhere.
constexpr double wanted_angle = 35 * M_PI / 180;

class FaceFiller {
  public:
    FaceFiller(const Brep& brep, FaceId face, const Chart& chart, const FaceBoundary& boundary, ChartDomain& domain,
               const WantedLength& sizing, const Mesh& mesh, std::span<const std::array<double, 2>> opposite,
               const Heartbeat& heart)
        : brep_(brep),
          face_(face),
          chart_(chart),
          geometry_(chart),
          boundary_(boundary),
          domain_(domain),
          sizing_(sizing),
          mesh_(mesh),
          opposite_(opposite),
          heart_(heart) {}

    FaceFilling fill() {
        try {
            plant();
            improve();
        } catch (const BrokenPatch&) {
            fail(say<Code::face_in_pieces>());
        }
        check_cover();
        return result();
    }

  private:
    void plant() {
        for (const NodeId n : boundary_.nodes) wanted_.push_back(sizing_.at(mesh_.point(n)));
        Seeds seeds;
        if (geometry_.is_flat()) seeds = even_seeds();
        is_lattice_ = !seeds.points.empty();
        if (!is_lattice_) seeds = front_seeds(boundary_, wanted_, domain_, chart_, sizing_, mesh_, heart_);
        if (!opposite_.empty()) plant_opposite(seeds);
        domain_.insert(seeds.points, heart_);
        patch_ = domain_.patch();
        std::fill_n(patch_.is_fixed.begin() + static_cast<std::ptrdiff_t>(boundary_.points.size()), seeds.fixed_count,
                    1);
        patch_.wanted = wanted_;
        patch_.wanted.insert(patch_.wanted.end(), seeds.wanted.begin(), seeds.wanted.end());
        for (std::size_t p = 0; p < boundary_.nodes.size(); ++p) patch_.nodes[p] = boundary_.nodes[p].value;
        for (std::size_t p = 0; p < patch_.points.size(); ++p) {
            const bool is_boundary = p < boundary_.nodes.size();
            if (geometry_.is_flat())
                patch_.places.push_back({patch_.points[p].x, patch_.points[p].y, 0});
            else
                patch_.places.push_back(is_boundary ? mesh_.point(boundary_.nodes[p]) : chart_.point(patch_.points[p]));
        }
    }

    void plant_opposite(Seeds& seeds) const {
        std::vector<Vec2> places;
        std::vector<double> wanted;
        for (const auto& uv : opposite_) {
            places.push_back(chart_.to_plane(chart_.in_trim_period(uv)));
            wanted.push_back(sizing_.at(chart_.point(places.back())));
        }
        put_first(places, wanted, boundary_, domain_, seeds);
    }

    /// A lattice where the wanted length is nearly the same on the whole face; else nothing.
    Seeds even_seeds() const {
        constexpr double even = 1.06;
        auto [low, high] = std::minmax_element(wanted_.begin(), wanted_.end());
        double smallest = *low, largest = *high;
        if (largest > even * smallest) return {};
        const double size = std::sqrt(smallest * largest);
        Seeds seeds{lattice_seeds(boundary_, size), {}};
        seeds.wanted.assign(seeds.points.size(), size);
        if (sizing_.is_uniform()) return seeds;
        for (const Vec2& p : seeds.points) {
            const double h = sizing_.at(chart_.point(p));
            smallest = std::min(smallest, h), largest = std::max(largest, h);
            if (largest > even * smallest) return {};
        }
        return seeds;
    }

    /// Around a thin tube with a coarse seam a side may join the two copies of one node: a node is put in its middle.
    void open_loops() {
        for (int t = 0; t < static_cast<int>(patch_.triangles.size()); ++t)
            for (int i = 0; i < 3; ++i) {
                const int a = patch_.corners(t)[at((i + 1) % 3)], b = patch_.corners(t)[at((i + 2) % 3)];
                if (patch_.neighbour(t, i) < 0 || !patch_.are_one_node(a, b)) continue;
                const Vec2 middle = 0.5 * (patch_.point(a) + patch_.point(b));
                patch_.split_side(t, i, middle, geometry_.place(middle));
            }
    }

    void improve() {
        open_loops();
        if (!geometry_.is_flat()) make_delaunay(patch_);
        if (!is_lattice_ && !split_long_sides(patch_, geometry_, heart_)) fail(say<Code::face_runs_back>());
        smooth(patch_, geometry_, heart_);
        if (!chart_.is_plane()) note_beside();
        if (split_folded(patch_, geometry_, heart_) > 0) smooth(patch_, geometry_, heart_);
        raise_smallest_angles(patch_, geometry_, wanted_angle, brep_.tolerances().least_length(), heart_);
        if (chart_.cone_sine() != 0) split_folded(patch_, geometry_, heart_);
        patch_.compact();
    }

    void note_beside() {
        std::map<std::array<int, 2>, EdgeId> edge_between;
        std::vector<std::vector<EdgeId>> edges_at(boundary_.points.size());
        for (const BoundarySegment& s : boundary_.segments) {
            if (!s.edge.is_valid() || s.is_pole) continue;
            edge_between[sorted_pair(s.a, s.b)] = s.edge;
            for (const int p : {s.a, s.b}) edges_at[at(p)].push_back(s.edge);
        }
        const auto note = [&](EdgeId edge, const std::vector<EdgeId>& across) {
            if (std::find(across.begin(), across.end(), edge) != across.end()) return;
            for (const EdgeId other : across) beside_.push_back({edge, other});
        };
        for (int t = 0; t < static_cast<int>(patch_.triangles.size()); ++t) {
            const auto& c = patch_.corners(t);
            if (patch_.is_removed(t) ||
                std::any_of(c.begin(), c.end(), [&](int p) { return at(p) >= boundary_.points.size(); }) ||
                !is_folded(patch_, geometry_, t))
                continue;
            for (int i = 0; i < 3; ++i)
                if (const auto side = edge_between.find(sorted_pair(c[at((i + 1) % 3)], c[at((i + 2) % 3)]));
                    side != edge_between.end())
                    note(side->second, edges_at[at(c[at(i)])]);
        }
    }

    /// All triangles the right way round, with the region's area in sum: then they cover it exactly once.
    void check_cover() const {
        double region = 0, covered = 0;
        for (const auto& s : boundary_.segments) region += cross(boundary_.points[at(s.a)], boundary_.points[at(s.b)]);
        for (const auto& t : patch_.triangles) {
            const double area = doubled_area(patch_.point(t[0]), patch_.point(t[1]), patch_.point(t[2]));
            if (!(area > 0)) fail(say<Code::face_triangle_turned>());
            covered += area;
        }
        double magnitude = 0;
        for (const auto& s : boundary_.segments)
            magnitude += std::abs(boundary_.points[at(s.a)].x * boundary_.points[at(s.b)].y) +
                         std::abs(boundary_.points[at(s.a)].y * boundary_.points[at(s.b)].x);
        if (std::abs(region - covered) > 1e-9 * region + 1e-13 * magnitude) fail(say<Code::face_not_covered>());
    }

    FaceFilling result() const {
        FaceFilling filling;
        filling.beside = beside_;
        const std::size_t boundary_count = boundary_.points.size();
        std::vector<int> new_index(patch_.points.size(), -1);
        for (std::size_t p = 0; p < boundary_count; ++p) new_index[p] = static_cast<int>(p);
        for (std::size_t p = boundary_count; p < patch_.points.size(); ++p) {
            if (patch_.triangle_of[p] < 0) continue;
            new_index[p] = static_cast<int>(boundary_count + filling.points.size());
            const auto uv = chart_.to_uv(patch_.points[p]);
            filling.parameters.push_back(uv);
            filling.points.push_back(chart_.point(patch_.points[p]));
        }
        const auto place = [&](int p) {
            return at(p) < boundary_count ? mesh_.point(boundary_.nodes[at(p)])
                                          : filling.points[at(p) - boundary_count];
        };
        filling.smallest_angle = M_PI;
        for (int i = 0; i < static_cast<int>(patch_.triangles.size()); ++i) {
            if (patch_.is_at_pole(i)) continue;
            const auto& t = patch_.corners(i);
            std::array<int, 3> c{new_index[at(t[0])], new_index[at(t[1])], new_index[at(t[2])]};
            if (chart_.is_reversed()) std::swap(c[1], c[2]);
            filling.triangles.push_back(c);
            filling.smallest_angle =
                std::min(filling.smallest_angle, smallest_angle(place(c[0]), place(c[1]), place(c[2])));
        }
        return filling;
    }

    [[noreturn]] void fail(const Message& why) const { throw MeshError(say<Code::face_not_meshed>(face_, why)); }

    const Brep& brep_;
    FaceId face_;
    const Chart& chart_;
    PatchGeometry geometry_;
    const FaceBoundary& boundary_;
    ChartDomain& domain_;
    const WantedLength& sizing_;
    const Mesh& mesh_;
    std::span<const std::array<double, 2>> opposite_;
    const Heartbeat& heart_;
    TrianglePatch patch_;
    std::vector<double> wanted_;  ///< side length by point of the boundary
    bool is_lattice_ = false;
    std::vector<std::array<EdgeId, 2>> beside_;  ///< see FaceFilling
};

}  // namespace

FaceFilling fill_face(const Brep& brep, FaceId face, const Chart& chart, const FaceBoundary& boundary,
                      ChartDomain& domain, const WantedLength& sizing, const Mesh& mesh,
                      std::span<const std::array<double, 2>> opposite, const Heartbeat& heart) {
    return FaceFiller(brep, face, chart, boundary, domain, sizing, mesh, opposite, heart).fill();
}

}  // namespace featuremesh
