// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/thicken.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "volume/cavity_editor.h"
#include "volume/edge_removal.h"
#include "volume/shrinking_steps.h"
#include "volume/tet_topology.h"

namespace featuremesh {

namespace {

/// Of six volumes against the product of three edges: some way above what the validation of a mesh refuses.
constexpr double least_share = 3e-6;
/// A step that does not reach the aim has to gain this factor, else passes would go on for nothing.
constexpr double least_gain = 1.01;
bool is_gain(double before, double after) {
    return before < 1 && after > 0 && (after >= 1 || after > std::max(0.0, before) * least_gain);
}
constexpr int most_passes = 12;

double thickness_of_corners(const std::array<Vec3, 4>& p, double least_volume) {
    const double six_volumes = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
    const double ab = squared_length(p[1] - p[0]), ac = squared_length(p[2] - p[0]), ad = squared_length(p[3] - p[0]),
                 bc = squared_length(p[2] - p[1]), bd = squared_length(p[3] - p[1]), cd = squared_length(p[3] - p[2]);
    // the largest product of the three edges at a corner
    const double lengths = std::sqrt(std::max({ab * ac * ad, ab * bc * bd, ac * bc * cd, ad * bd * cd}));
    return std::min(six_volumes / (6 * least_volume), six_volumes / (least_share * lengths));
}

std::vector<int> thin_tets(const TetComplex& complex, double least_volume, const RunContext& context) {
    std::vector<int> thin;
    RoundWatch watch(context);
    for (std::size_t t = 0; t < complex.tets.size(); ++t) {
        watch();
        if (complex.tets[t][0] >= 0 && thickness(complex, complex.tets[t], least_volume) < 1)
            thin.push_back(static_cast<int>(t));
    }
    return thin;
}

/// A cavity that is filled from a new point, as in Klingner and Shewchuk 2007.
class ThickCavity {
  public:
    ThickCavity(CavityEditor& editor, double least_volume) : editor_(editor), least_volume_(least_volume) {}

    /// Grows from `start` and moves the point, in turns; keeps the best met. False where the thinnest is no thicker.
    bool plan(std::span<const int> start, Vec3 point) {
        constexpr int rounds = 10;
        best_ = 0;
        reset(start, point);
        for (int round = 0; round < rounds && best_ < 1; ++round) {
            if (!make_visible(point)) break;
            if (!loses_fixed_vertex()) point = climb(point);
            if (!give_room(point)) break;
        }
        return best_ > 0;
    }

    /// Cones looked at so far.
    std::size_t evaluations() const { return evaluations_; }
    double thinnest_after() const { return best_; }
    const Vec3& point() const { return best_point_; }
    const std::vector<int>& removed() const { return best_removed_; }
    std::vector<Tet> cones(int apex) const {
        std::vector<Tet> cones;
        for (const auto& f : best_faces_) cones.push_back({apex, f[0], f[1], f[2]});
        return cones;
    }

  private:
    struct Face {
        int tet, face;
        std::array<int, 3> corners;
        double value;
    };
    static constexpr std::size_t most_tets = 240;

    double cone(const std::array<int, 3>& f, const Vec3& apex) {
        const auto& p = editor_.complex().points;
        ++evaluations_;
        return thickness_of_corners({apex, p[f[0]], p[f[1]], p[f[2]]}, least_volume_);
    }

    void add(int tet, const Vec3& point) {
        const TetComplex& complex = editor_.complex();
        tets_.push_back(tet);
        editor_.mark(tet);
        before_ = std::min(before_, thickness(complex, complex.tets[tet], least_volume_));
        for (int face = 0; face < 4; ++face) {
            const int next = complex.neighbours[tet][face];
            if (next >= 0 && editor_.is_marked(next)) {
                const int back = face_towards(complex.neighbours[next], tet);
                std::erase_if(faces_, [&](const Face& f) { return f.tet == next && f.face == back; });
                continue;
            }
            const auto& c = opposite_face[face];
            const Tet& v = complex.tets[tet];
            const std::array<int, 3> corners{v[c[0]], v[c[1]], v[c[2]]};
            faces_.push_back({tet, face, corners, cone(corners, point)});
        }
    }

    void reset(std::span<const int> start, const Vec3& point) {
        tets_.clear(), faces_.clear();
        before_ = 1;
        editor_.begin_marks();
        for (const int tet : start) add(tet, point);
    }

    int next_of(const Face& f) const { return editor_.complex().neighbours[f.tet][f.face]; }

    /// Adds the tets behind triangles that do not see the point. False where such a triangle is the boundary.
    bool make_visible(const Vec3& point) {
        for (;;) {
            const auto hidden =
                std::find_if(faces_.begin(), faces_.end(), [](const Face& f) { return !(f.value > 0); });
            if (hidden == faces_.end()) return true;
            const int next = next_of(*hidden);
            if (next < 0 || tets_.size() >= most_tets) return false;
            add(next, point);
        }
    }

    /// Adds the tets behind the thinnest cones, so that the point can move further.
    bool give_room(const Vec3& point) {
        constexpr std::size_t most_at_once = 4;
        std::vector<std::pair<double, int>> behind;
        for (Face& f : faces_) {
            f.value = cone(f.corners, point);
            if (next_of(f) >= 0) behind.emplace_back(f.value, next_of(f));
        }
        std::sort(behind.begin(), behind.end());
        std::size_t added = 0;
        for (const auto& [value, tet] : behind)
            if (added < most_at_once && tets_.size() < most_tets && !editor_.is_marked(tet)) add(tet, point), ++added;
        return added > 0;
    }

    bool loses_fixed_vertex() const {
        const TetComplex& complex = editor_.complex();
        for (const int tet : tets_)
            for (const int v : complex.tets[tet])
                if (complex.is_fixed[v] && std::none_of(faces_.begin(), faces_.end(), [&](const Face& f) {
                        return f.corners[0] == v || f.corners[1] == v || f.corners[2] == v;
                    }))
                    return true;
        return false;
    }

    /// At most `enough` where it is no more than that.
    double thinnest_cone(const Vec3& point, double enough) {
        double least = 1;
        for (std::size_t i = 0; i < faces_.size() && least > enough; ++i)
            least = std::min(least, cone(faces_[i].corners, point));
        return least;
    }

    Vec3 climb(Vec3 point) {
        double now = thinnest_cone(point, -std::numeric_limits<double>::infinity()), step = 0;
        for (const Face& f : faces_)
            for (const int v : f.corners)
                step = std::max(step, 0.5 * distance(editor_.complex().points[static_cast<std::size_t>(v)], point));
        const double least_step = 1e-4 * step;
        while (step > least_step && now < 1) {
            bool is_better = false;
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = -1; z <= 1; ++z) {
                        const Vec3 trial = point + step * Vec3{double(x), double(y), double(z)};
                        if (const double value = thinnest_cone(trial, now); value > now)
                            now = value, point = trial, is_better = true;
                    }
            if (!is_better) step *= 0.5;
        }
        if (now > best_ && is_gain(before_, now)) {
            best_ = now, best_point_ = point, best_removed_ = tets_;
            best_faces_.clear();
            for (const Face& f : faces_) best_faces_.push_back(f.corners);
        }
        return point;
    }

    CavityEditor& editor_;
    double least_volume_, before_ = 1, best_ = 0;
    std::size_t evaluations_ = 0;
    Vec3 best_point_{};
    std::vector<int> tets_, best_removed_;
    std::vector<Face> faces_;
    std::vector<std::array<int, 3>> best_faces_;
};

class Thickener {
  public:
    Thickener(TetComplex& complex, double least_volume, std::size_t most_insertions, std::size_t most_cones,
              RunContext& context)
        : complex_(complex),
          least_volume_(least_volume),
          insertions_left_(most_insertions),
          most_cones_(most_cones),
          context_(context),
          editor_(complex),
          cavity_(editor_, least_volume) {}

    Thickened run(std::vector<int> thin) {
        for (int pass = 0; pass < most_passes && !thin.empty(); ++pass) {
            bool gained = false;
            for (const int tet : thin) {
                context_.progress(static_cast<double>(pass) / most_passes);
                if (complex_.tets[tet][0] < 0 || thickness_of(complex_.tets[tet]) >= 1) continue;
                gained = (remove_edge(tet) || collapse(tet) || move(tet) || insert(tet)) || gained;
            }
            thin = thin_tets(complex_, least_volume_, context_);
            if (!gained) break;
        }
        return {std::move(thin), std::move(changed_)};
    }

  private:
    double thickness_of(const Tet& tet) const { return thickness(complex_, tet, least_volume_); }
    /// At most `enough` where it is no more than that.
    double thinnest(std::span<const int> tets, double enough = -std::numeric_limits<double>::infinity()) const {
        double least = 1;
        for (std::size_t i = 0; i < tets.size() && least > enough; ++i)
            least = std::min(least, thickness_of(complex_.tets[tets[i]]));
        return least;
    }

    bool remove_edge(int tet) {
        EdgeRing ring;
        for (const auto& [from, to] : edge_corners) {
            if (!find_ring(complex_, tet, from, to, ring)) continue;
            const double before = std::max(1e-12, thinnest(ring.all_tets()));
            const auto cost = [&](int i, int j, int k) {
                const int a = ring.vertices[i], b = ring.vertices[j], c = ring.vertices[k];
                const double least = std::min(thickness_of({a, b, c, ring.to}), thickness_of({b, a, c, ring.from}));
                return least > 0 ? 1 / std::min(1.0, least) : std::numeric_limits<double>::infinity();
            };
            // a cost of 1 is thick enough
            const double limit = std::max(1 + 1e-12, 1 / (before * least_gain));
            const RingTriangulation<> best = triangulate_ring<WorstOf>(ring.size, limit, cost);
            if (std::isinf(best.cost)) continue;
            std::array<Tet, 2 * EdgeRing::max_size> added;
            const int count = tets_of_triangulation(ring, best, added);
            note_changed(editor_.replace(ring.all_tets(), {added.data(), static_cast<std::size_t>(count)}));
            return true;
        }
        return false;
    }

    bool collapse(int tet) {
        const Tet corners = complex_.tets[tet];
        for (const int gone : corners) {
            if (complex_.is_fixed[gone] || !gather_star(complex_, gone, star_)) continue;
            const double before = thinnest(star_);
            double best = before;
            std::vector<Tet> best_tets;
            for (const int apex : neighbours_of(gone)) {
                std::vector<Tet> cones;
                double least = 1;
                for (std::size_t i = 0; i < star_.size() && least > best; ++i) {
                    Tet cone = complex_.tets[star_[i]];
                    if (std::find(cone.begin(), cone.end(), apex) != cone.end()) continue;
                    cone[corner_of(cone, gone)] = apex;
                    least = std::min(least, thickness_of(cone));
                    cones.push_back(cone);
                }
                if (least > best) best = least, best_tets = std::move(cones);
            }
            if (!is_gain(before, best) || best_tets.empty()) continue;
            note_changed(editor_.replace(star_, best_tets));
            return true;
        }
        return false;
    }

    std::vector<int> neighbours_of(int vertex) const {
        std::vector<int> around;
        gather_neighbours(complex_, vertex, star_, around);
        return around;
    }

    bool move(int tet) {
        bool gained = false;
        for (const int v : complex_.tets[tet])
            if (!complex_.is_fixed[v] && gather_star(complex_, v, star_) && climb(v))
                note_changed(star_), gained = true;
        return gained;
    }

    void note_changed(std::span<const int> tets) { changed_.insert(changed_.end(), tets.begin(), tets.end()); }

    /// A new vertex in the tet, or on one of its inner edges: where boundary nodes alone make it, as across a thin wall
    /// with a short edge on either side.
    bool insert(int tet) {
        if (insertions_left_ == 0 || cavity_.evaluations() > most_cones_) return false;
        --insertions_left_;
        const Tet& v = complex_.tets[tet];
        const auto& p = complex_.points;
        std::vector<std::pair<std::vector<int>, Vec3>> starts{{{tet}, (p[v[0]] + p[v[1]] + p[v[2]] + p[v[3]]) / 4}};
        for (const auto& [from, to] : edge_corners) {
            EdgeRing ring;
            if (!find_ring(complex_, tet, from, to, ring)) continue;
            const auto tets = ring.all_tets();
            starts.emplace_back(std::vector<int>(tets.begin(), tets.end()), 0.5 * (p[ring.from] + p[ring.to]));
        }
        double best = 0;
        Vec3 point{};
        std::vector<int> removed;
        std::vector<Tet> cones;
        const int apex = static_cast<int>(p.size());
        for (const auto& [start, middle] : starts) {
            if (best >= 1 || !cavity_.plan(start, middle) || cavity_.thinnest_after() <= best) continue;
            best = cavity_.thinnest_after();
            point = cavity_.point(), removed = cavity_.removed(), cones = cavity_.cones(apex);
        }
        if (best <= 0) return false;
        editor_.add_vertex(point);
        note_changed(editor_.replace(removed, cones));
        return true;
    }

    /// Hill climbing along the axes and the space diagonals, and towards the middle of the star.
    bool climb(int vertex) {
        Vec3& place = complex_.points[vertex];
        const double before = thinnest(star_);
        double best = before, reach = 0;
        Vec3 middle{};
        const std::vector<int> around = neighbours_of(vertex);
        for (const int n : around) {
            reach += distance(complex_.points[n], place) / static_cast<double>(around.size());
            middle = middle + (1.0 / static_cast<double>(around.size())) * complex_.points[n];
        }
        const auto try_at = [&](const Vec3& trial) {
            const Vec3 old = place;
            place = trial;
            const double now = thinnest(star_, best);
            if (now > best) {
                best = now;
                return true;
            }
            place = old;
            return false;
        };
        for (const double share : {1.0, 0.5, 0.25, 0.1}) try_at(place + share * (middle - place));
        const auto improve = [&](double step) {
            bool is_better = false;
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = -1; z <= 1; ++z)
                        is_better = try_at(place + step * Vec3{double(x), double(y), double(z)}) || is_better;
            return is_better;
        };
        search_by_shrinking_steps(
            0.3 * reach, 1e-4 * reach, [&] { return !(best < 1); }, improve);
        return is_gain(before, best);
    }

    TetComplex& complex_;
    double least_volume_;
    std::size_t insertions_left_, most_cones_;
    RunContext& context_;
    CavityEditor editor_;
    ThickCavity cavity_;
    std::vector<int> star_, changed_;
};

}  // namespace

double thickness(const TetComplex& complex, const std::array<int, 4>& tet, double least_volume) {
    const auto& p = complex.points;
    return thickness_of_corners({p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]}, least_volume);
}

bool is_too_thin(const TetComplex& complex, const std::array<int, 4>& tet, double least_volume) {
    // tets are mended until they have the least volume; with this share of it they are still no reason to refuse a part
    constexpr double tolerated_share = 0.92;
    const Vec3 &a = complex.points[tet[0]], u = complex.points[tet[1]] - a, v = complex.points[tet[2]] - a,
               w = complex.points[tet[3]] - a;
    const double six_volumes = dot(cross(u, v), w);
    return !(six_volumes > 1.01e-6 * length(u) * length(v) * length(w)) ||
           six_volumes < 6 * tolerated_share * least_volume;
}

Thickened thicken(TetComplex& complex, double least_volume, RunContext& context, std::size_t most_insertions,
                  std::size_t most_cones) {
    std::vector<int> thin = thin_tets(complex, least_volume, context);
    if (thin.empty()) return {};
    return Thickener(complex, least_volume, most_insertions, most_cones, context).run(std::move(thin));
}

}  // namespace featuremesh
