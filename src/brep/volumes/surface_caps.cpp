// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/surface_caps.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Standard_DomainError.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>
#include <numbers>

#include "brep/occt_geometry.h"
#include "brep/volumes/period_shifts.h"

namespace featuremesh {

namespace {

constexpr double same_parameters = 1e-3;  // of the region's extent: tells the two uses of a seam apart
constexpr double no_turn = 0.02;          // rad: which of two uses is further left is not to be told any more

struct Point {
    double u = 0, v = 0;
};
Point operator-(const Point& a, const Point& b) { return {a.u - b.u, a.v - b.v}; }
double cross(const Point& a, const Point& b) { return a.u * b.v - a.v * b.u; }
double dot(const Point& a, const Point& b) { return a.u * b.u + a.v * b.v; }

struct Rectangle {
    Point low{1e300, 1e300}, high{-1e300, -1e300};
    void add(const Point& p) {
        low = {std::min(low.u, p.u), std::min(low.v, p.v)};
        high = {std::max(high.u, p.u), std::max(high.v, p.v)};
    }
    bool contains(const Point& p) const { return low.u <= p.u && p.u <= high.u && low.v <= p.v && p.v <= high.v; }
    bool overlaps(const Rectangle& b) const {
        return low.u <= b.high.u && b.low.u <= high.u && low.v <= b.high.v && b.low.v <= high.v;
    }
};

/// A directed piece of border with its way through the parameters.
struct Step {
    SurfaceCap::Coedge coedge;
    int from = 0, to = 0;  // vertices
    std::vector<Point> way;
};

struct Loop {
    std::vector<std::size_t> steps;
    std::vector<Point> polygon;
    Rectangle box;
    double area = 0;  // twice
    int depth = 0;    // winding number outside of it
    int within = -1;  // the loop next around it
};

/// Chords enough that the ways of two edges that do not meet do not either.
int chords_of(GeomAbs_CurveType type, double range) {
    if (type == GeomAbs_Line) return 1;
    if (type == GeomAbs_Circle || type == GeomAbs_Ellipse)
        return std::max(4, int(std::ceil(48 * range / (2 * std::numbers::pi))));
    return 24;
}

/// The caps of one underlying surface.
class CapsOfSurface {
  public:
    CapsOfSurface(const std::vector<PatchFace>& faces, const MergedEdges& edges, std::vector<std::size_t> members)
        : faces_(faces), edges_(edges), members_(std::move(members)), surface_(faces[members_.front()].face, false) {
        for (const std::size_t face : members_) add(face);
        for (const Step& step : steps_)
            for (const Point& p : step.way) extent_.add(p);
        meet_in_vertices();
        cancel();
        refuse_doubles();
        refuse_crossings();
        walk();
        nest();
    }

    void append_to(std::vector<SurfaceCap>& caps) const {
        for (std::size_t outer = 0; outer < loops_.size(); ++outer) {
            if (loops_[outer].depth != 0) continue;
            SurfaceCap& cap = caps.emplace_back();
            cap.on = members_.front();
            cap.vanished = loops_[outer].area > 0;
            for (std::size_t k = 0; k < loops_.size(); ++k)
                if (k == outer || (loops_[k].depth != 0 && loops_[k].within == int(outer)))
                    cap.wires.push_back(wire_of(loops_[k], cap.vanished));
        }
    }

  private:
    bool is_plane() const { return surface_.GetType() == GeomAbs_Plane; }

    /// Whether a plane's parameters run round the other way than those of the first.
    bool is_turned(std::size_t face) const {
        if (!is_plane()) return false;
        return faces_[face].face.Orientation() != faces_[members_.front()].face.Orientation();
    }

    void add(std::size_t face) {
        const std::size_t first = steps_.size();
        for (const MergedEdges::Wire& wire : edges_.wires_of(face))
            for (const MergedEdges::Use& use : wire) add(face, use);
        if (is_plane()) return;
        join(first);
        Rectangle range;
        for (std::size_t i = first; i < steps_.size(); ++i)
            for (const Point& p : steps_[i].way) range.add(p);
        const Point middle{(range.low.u + range.high.u) / 2, (range.low.v + range.high.v) / 2};
        if (first == 0) middle_ = middle;
        const Parameters period = period_of(surface_);
        const Parameters shift{periods(period.u, middle_.u - middle.u), periods(period.v, middle_.v - middle.v)};
        for (std::size_t i = first; i < steps_.size(); ++i) move(steps_[i], shift);
    }

    static void move(Step& step, const Parameters& by) {
        for (Point& p : step.way) p = {p.u + by.u, p.v + by.v};
        step.coedge.shift = {step.coedge.shift.u + by.u, step.coedge.shift.v + by.v};
    }

    /// Brings the steps of a face beside one another.
    void join(std::size_t first) {
        const Parameters period = period_of(surface_);
        if (period.u == 0 && period.v == 0) return;
        std::vector<BorderStep> border;
        for (std::size_t i = first; i < steps_.size(); ++i) {
            const Step& s = steps_[i];
            border.push_back({s.from, s.to, {s.way.front().u, s.way.front().v}, {s.way.back().u, s.way.back().v}});
        }
        const std::vector<Parameters> shifts = period_shifts(border, period);
        for (std::size_t i = first; i < steps_.size(); ++i) move(steps_[i], shifts[i - first]);
    }

    /// Whole periods that bring a face beside the first one.
    static double periods(double period, double distance) {
        if (period == 0 || std::abs(distance) <= 0.501 * period) return 0;
        return period * std::round(distance / period);
    }

    void add(std::size_t face, const MergedEdges::Use& use) {
        const bool against = is_turned(face) == faces_[face].vanished;  // those that appeared are turned round
        Step step{{face, use, against ? -use.sense : use.sense, {}}, 0, 0, {}};
        const MergedEdges::Piece& piece = edges_.piece(use.piece);
        step.from = piece.ends[step.coedge.sense > 0 ? 0 : 1];
        step.to = piece.ends[step.coedge.sense > 0 ? 1 : 0];
        step.way = is_plane() ? way_in_plane(use) : way_by_parameters(face, use);
        const bool along_own = (step.coedge.sense > 0) != edges_.piece(use.own).turned;
        if (!along_own) std::reverse(step.way.begin(), step.way.end());
        steps_.push_back(std::move(step));
    }

    std::vector<Point> way_in_plane(const MergedEdges::Use& use) const {
        const MergedEdges::Piece& own = edges_.piece(use.own);
        if (edges_.is_degenerated(own)) throw Standard_DomainError("a degenerated edge in a plane");
        const auto project = [&](const gp_Pnt& p) {
            Point q;
            ElSLib::Parameters(surface_.Plane(), p, q.u, q.v);
            return q;
        };
        const BRepAdaptor_Curve curve(use.edge);
        const int chords = chords_of(curve.GetType(), own.last - own.first);
        std::vector<Point> way{project(to_pnt(edges_.position(own.ends[0])))};
        for (int i = 1; i < chords; ++i)
            way.push_back(project(curve.Value(own.first + i * (own.last - own.first) / chords)));
        way.push_back(project(to_pnt(edges_.position(own.ends[1]))));
        return way;
    }

    std::vector<Point> way_by_parameters(std::size_t face, const MergedEdges::Use& use) const {
        double first = 0, last = 0;
        const TopoDS_Face forward = TopoDS::Face(faces_[face].face.Oriented(TopAbs_FORWARD));
        const Handle(Geom2d_Curve) trace = BRep_Tool::CurveOnSurface(use.edge, forward, first, last);
        if (trace.IsNull()) throw Standard_DomainError("an edge without a curve on its face");
        const MergedEdges::Piece& own = edges_.piece(use.own);
        if (!edges_.is_degenerated(own)) first = own.first, last = own.last;
        const int chords = trace->IsKind(STANDARD_TYPE(Geom2d_Line)) ? 1 : 24;
        std::vector<Point> way;
        for (int i = 0; i <= chords; ++i) {
            const gp_Pnt2d p = trace->Value(first + i * (last - first) / chords);
            way.push_back({p.X(), p.Y()});
        }
        return way;
    }

    /// The same place, and not only the same vertex: the two uses of a seam are apart.
    bool is_near(const Point& a, const Point& b) const {
        if (is_plane()) return true;
        const Point d = a - b, size = extent_.high - extent_.low;
        return std::abs(d.u) <= same_parameters * size.u && std::abs(d.v) <= same_parameters * size.v;
    }

    /// Curves of parameters end a little beside each other.
    void meet_in_vertices() {
        std::multimap<int, Point> known;
        const auto meet = [&](int vertex, Point& p) {
            const auto [first, last] = known.equal_range(vertex);
            const auto same = std::find_if(first, last, [&](const auto& entry) { return is_near(entry.second, p); });
            if (same == last)
                known.emplace(vertex, p);
            else
                p = same->second;
        };
        for (Step& step : steps_) {
            meet(step.from, step.way.front());
            meet(step.to, step.way.back());
        }
    }

    int name_of(const Step& step) const {
        return edges_.is_degenerated(edges_.piece(step.coedge.use.piece)) ? -1 - step.from : step.coedge.use.piece;
    }

    void cancel() {
        std::map<int, std::vector<std::size_t>> waiting;
        std::vector<char> is_gone(steps_.size(), 0);
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            std::vector<std::size_t>& others = waiting[name_of(steps_[i])];
            const auto partner = std::find_if(others.begin(), others.end(), [&](std::size_t k) {
                return steps_[k].from == steps_[i].to && steps_[k].to == steps_[i].from &&
                       (steps_[k].coedge.sense != steps_[i].coedge.sense || name_of(steps_[i]) < 0) &&
                       is_near(steps_[k].way.front(), steps_[i].way.back()) &&
                       is_near(steps_[k].way.back(), steps_[i].way.front());
            });
            if (partner == others.end()) {
                others.push_back(i);
                continue;
            }
            is_gone[i] = is_gone[*partner] = 1;
            others.erase(partner);
        }
        std::vector<Step> left;
        for (std::size_t i = 0; i < steps_.size(); ++i)
            if (!is_gone[i]) left.push_back(std::move(steps_[i]));
        steps_ = std::move(left);
    }

    /// Faces before and after lie left of the same edge, or both right, but their parameters are elsewhere.
    void refuse_doubles() const {
        for (std::size_t i = 0; i < steps_.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (steps_[i].coedge.use.piece == steps_[k].coedge.use.piece &&
                    steps_[i].coedge.sense != steps_[k].coedge.sense &&
                    faces_[steps_[i].coedge.face].vanished != faces_[steps_[k].coedge.face].vanished)
                    throw Standard_DomainError("a surface with a seam elsewhere");
    }

    /// Throws where two borders cross: a region would end at the crossing, where no vertex is.
    void refuse_crossings() const {
        std::vector<Rectangle> boxes(steps_.size());
        for (std::size_t i = 0; i < steps_.size(); ++i)
            for (const Point& p : steps_[i].way) boxes[i].add(p);
        for (std::size_t i = 0; i < steps_.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (steps_[i].coedge.use.piece != steps_[k].coedge.use.piece && boxes[i].overlaps(boxes[k]) &&
                    do_cross(steps_[i].way, steps_[k].way, boxes[k]))
                    throw Standard_DomainError("edges of faces before and after cross");
    }

    static bool do_cross(const std::vector<Point>& a, const std::vector<Point>& b, const Rectangle& box_of_b) {
        for (std::size_t i = 0; i + 1 < a.size(); ++i) {
            Rectangle chord;
            chord.add(a[i]);
            chord.add(a[i + 1]);
            if (!chord.overlaps(box_of_b)) continue;
            for (std::size_t k = 0; k + 1 < b.size(); ++k) {
                Rectangle other;
                other.add(b[k]);
                other.add(b[k + 1]);
                if (chord.overlaps(other) && do_cross(a[i], a[i + 1], b[k], b[k + 1])) return true;
            }
        }
        return false;
    }

    /// In points well within both, so that uses that begin or end at the same vertex do not.
    static bool do_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
        const Point along = b - a, other = d - c;
        const double sine = cross(along, other);
        if (sine * sine <= 1e-18 * dot(along, along) * dot(other, other)) return false;
        const double s = cross(c - a, other) / sine, t = cross(c - a, along) / sine;
        constexpr double end = 1e-6;
        return s > end && s < 1 - end && t > end && t < 1 - end;
    }

    static Point direction(const Step& step, bool at_end) {
        const std::size_t n = step.way.size();
        return at_end ? step.way[n - 1] - step.way[n - 2] : step.way[1] - step.way[0];
    }

    /// The unused step that goes on from this one; of several the one furthest to the left, so that regions that touch
    /// in a vertex stay apart.
    std::size_t next_of(const Step& step, const std::multimap<int, std::size_t>& starts,
                        const std::vector<char>& is_used) const {
        std::vector<std::pair<double, std::size_t>> turns;
        const auto [first, last] = starts.equal_range(step.to);
        const Point in = direction(step, true);
        for (auto it = first; it != last; ++it) {
            const Step& other = steps_[it->second];
            if (is_used[it->second] || !is_near(other.way.front(), step.way.back())) continue;
            const Point out = direction(other, false);
            turns.emplace_back(std::atan2(cross(in, out), dot(in, out)), it->second);
        }
        if (turns.empty()) throw Standard_DomainError("a border that ends");
        std::sort(turns.rbegin(), turns.rend());
        if (turns.size() > 1 && turns[0].first - turns[1].first < no_turn)
            throw Standard_DomainError("borders that touch each other");
        return turns[0].second;
    }

    void walk() {
        std::multimap<int, std::size_t> starts;
        for (std::size_t i = 0; i < steps_.size(); ++i) starts.emplace(steps_[i].from, i);
        std::vector<char> is_used(steps_.size(), 0);
        for (std::size_t first = 0; first < steps_.size(); ++first) {
            if (is_used[first]) continue;
            std::vector<std::size_t> path{first};
            is_used[first] = 1;
            while (!closes(path.back(), path.front())) {
                path.push_back(next_of(steps_[path.back()], starts, is_used));
                is_used[path.back()] = 1;
                cut_off_loop(path);
            }
            add_loop(path);
        }
    }

    bool closes(std::size_t last, std::size_t first) const {
        return steps_[last].to == steps_[first].from && is_near(steps_[last].way.back(), steps_[first].way.front());
    }

    /// When a path returns to a point that it passed before, the steps since then enclose a region: they become a loop.
    void cut_off_loop(std::vector<std::size_t>& path) {
        for (std::size_t i = 1; i < path.size(); ++i)
            if (closes(path.back(), path[i])) {
                add_loop({path.begin() + std::ptrdiff_t(i), path.end()});
                path.resize(i);
                return;
            }
    }

    void add_loop(std::vector<std::size_t> steps) {
        Loop loop{std::move(steps), {}, {}};
        for (const std::size_t s : loop.steps)
            loop.polygon.insert(loop.polygon.end(), steps_[s].way.begin(), steps_[s].way.end() - 1);
        for (std::size_t i = 0; i < loop.polygon.size(); ++i) {
            loop.box.add(loop.polygon[i]);
            loop.area +=
                cross(loop.polygon[i] - extent_.low, loop.polygon[(i + 1) % loop.polygon.size()] - extent_.low);
        }
        loops_.push_back(std::move(loop));
    }

    static bool contains(const Loop& loop, const Point& p) {
        if (!loop.box.contains(p)) return false;
        bool inside = false;
        Point a = loop.polygon.back();
        for (const Point& b : loop.polygon) {
            if ((a.v > p.v) != (b.v > p.v) && p.u < a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u)) inside = !inside;
            a = b;
        }
        return inside;
    }

    /// All points of the one within the other, or none; vertices in which they touch do not count.
    bool contains(const Loop& outer, const Loop& inner) const {
        if (!outer.box.overlaps(inner.box)) return false;
        std::vector<int> shared;
        for (const std::size_t s : outer.steps) shared.push_back(steps_[s].from);
        int in = 0, out = 0;
        for (const std::size_t s : inner.steps) {
            const std::vector<Point>& way = steps_[s].way;
            const bool touches = std::find(shared.begin(), shared.end(), steps_[s].from) != shared.end();
            for (std::size_t i = touches ? 1 : 0; i + 1 < way.size(); ++i) ++(contains(outer, way[i]) ? in : out);
            const Point middle{(way[0].u + way[1].u) / 2, (way[0].v + way[1].v) / 2};
            ++(contains(outer, middle) ? in : out);
        }
        if (in > 0 && out > 0) throw Standard_DomainError("borders that overlap");
        return in > 0;
    }

    void nest() {
        for (std::size_t k = 0; k < loops_.size(); ++k) {
            Loop& loop = loops_[k];
            for (std::size_t i = 0; i < loops_.size(); ++i) {
                if (i == k || std::abs(loops_[i].area) <= std::abs(loop.area) || !contains(loops_[i], loop)) continue;
                loop.depth += loops_[i].area > 0 ? 1 : -1;
                if (loop.within < 0 || std::abs(loops_[i].area) < std::abs(loops_[std::size_t(loop.within)].area))
                    loop.within = int(i);
            }
            const int inside = loop.depth + (loop.area > 0 ? 1 : -1);
            if (std::abs(loop.depth) > 1 || std::abs(inside) > 1) throw Standard_DomainError("a surface covered twice");
        }
    }

    std::vector<SurfaceCap::Coedge> wire_of(const Loop& loop, bool along) const {
        std::vector<SurfaceCap::Coedge> wire;
        for (const std::size_t s : loop.steps) {
            wire.push_back(steps_[s].coedge);
            if (!along) wire.back().sense = -wire.back().sense;
        }
        if (!along) std::reverse(wire.begin(), wire.end());
        return wire;
    }

    const std::vector<PatchFace>& faces_;
    const MergedEdges& edges_;
    std::vector<std::size_t> members_;
    BRepAdaptor_Surface surface_;
    std::vector<Step> steps_;
    Point middle_;  // of the first face
    Rectangle extent_;
    std::vector<Loop> loops_;
};

}  // namespace

std::vector<SurfaceCap> surface_caps(const std::vector<PatchFace>& faces, const MergedEdges& edges) {
    std::map<int, std::vector<std::size_t>> members;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (faces[f].underlying >= 0) members[faces[f].underlying].push_back(f);
    std::vector<SurfaceCap> caps;
    for (const auto& [underlying, of] : members) CapsOfSurface(faces, edges, of).append_to(caps);
    return caps;
}

}  // namespace featuremesh
