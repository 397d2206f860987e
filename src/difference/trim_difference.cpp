// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/trim_difference.h"

#include <BRepTools.hxx>
#include <algorithm>
#include <numeric>

#include "brep/solid_probe.h"
#include "core/ids.h"
#include "difference/boundary_model.h"
#include "difference/cell_strips.h"
#include "difference/surface_cells.h"
#include "difference/surface_chart.h"
#include "difference/told_cells.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {
namespace {
constexpr double most_border_cells = 20000;
constexpr double gap = 1e-6;  // mm, between ends of edges that are meant to meet

/// A stretch of a changed piece in the parameter plane; the true curve is no further from it than `margin` (scaled,
/// mm).
struct Segment {
    Uv a, b;
    double margin;
    bool is_border;    ///< left of it is difference and right of it not, or the other way round
    bool is_straight;  ///< just so in the parameter plane
};

class TrimRaster {
  public:
    TrimRaster(const BoundaryPair& pair, const BoundaryMatch& match, const SurfaceGroup& group,
               const Resolution& resolution, std::vector<SpaceTriangle>& triangles)
        : pair_(pair),
          match_(match),
          group_(group),
          resolution_(resolution),
          leaf_(resolution.finest),
          to_old_(pair.motion.inverse()),
          chart_(underlying()),
          cells_(chart_, resolution, triangles) {}

    void run() {
        if (chart_.underlying().kind == SurfaceKind::free_form) {
            natural_ = natural_box();
            chart_.start_searches_in(natural_);
        }
        const bool known = take_borders();
        root_ = root_box();
        if (chart_.underlying().kind == SurfaceKind::plane && !clip_root_to_domain()) return;
        chart_.scale_for(root_);
        cells_.begin_in(root_);
        told_.emplace(root_);
        if (!known) return cells_.add(root_);
        shift_into_root();
        widen_margins();
        by_crossings_ = has_open_lines() && borders_close();
        if (by_crossings_) sort_into_columns();
        entering_.resize(segments_.size());
        std::iota(entering_.begin(), entering_.end(), 0);
        visit(root_, 0, {});
    }

  private:
    bool has_new() const { return !group_.new_faces.empty(); }

    UnderlyingSurface underlying() const {
        if (has_new()) return pair_.new_model.faces()[group_.new_faces[0].index()].underlying;
        return moved(pair_.old_model.faces()[group_.old_faces[0].index()].underlying, to_trsf(pair_.motion));
    }

    /// The parameters of all faces of a free-form underlying surface.
    UvBox natural_box() const {
        UvBox box;
        const auto add = [&](const BoundaryModel& model, FaceId f) {
            double u0, u1, v0, v1;
            BRepTools::UVBounds(model.brep().face(f), u0, u1, v0, v1);
            box.add({u0, v0}), box.add({u1, v1});
        };
        for (const FaceId f : group_.old_faces) add(pair_.old_model, f);
        for (const FaceId f : group_.new_faces) add(pair_.new_model, f);
        return box;
    }

    /// False when a border could not be found in the parameter plane.
    bool take_borders() {
        double total = 0;
        for (const ChangedPiece& piece : group_.pieces) {
            const UnderlyingCurve& curve = match_.curves[std::size_t(piece.curve)];
            const double speed = curve.kind == CurveKind::circle || curve.kind == CurveKind::ellipse ? curve.radius : 1;
            total += speed * (piece.last - piece.first);
        }
        leaf_ = std::max(leaf_, 2 * total / most_border_cells);
        for (const ChangedPiece& piece : group_.pieces)
            if (!is_far_loop(piece) && !take_piece(piece)) return false;
        for (const Vec3& p : group_.points) {
            const auto uv = chart_.parameters(p, end_near(p));
            if (!uv) return false;
            segments_.push_back({*uv, *uv, 0, false, true});
        }
        return true;
    }

    bool take_piece(const ChangedPiece& piece) {
        const UnderlyingCurve& curve = match_.curves[std::size_t(piece.curve)];
        const int count = samples_of(curve, piece);
        std::vector<Vec3> points;
        std::vector<Uv> trace;
        for (int i = 0; i <= count; ++i) {
            points.push_back(point_at(curve, piece.first + (piece.last - piece.first) * i / count));
            const auto uv =
                chart_.parameters(points.back(), trace.empty() ? end_near(points.back()) : std::optional(trace.back()));
            if (!uv) return false;
            trace.push_back(*uv);
        }
        ends_.insert(ends_.end(), {{points.front(), trace.front()}, {points.back(), trace.back()}});
        // The first point may be a pole, where u was arbitrary: it takes u from its neighbour.
        if (const auto again = chart_.parameters(points[0], trace[1])) trace[0] = *again;
        if (count == 1 || runs_around(trace))
            segments_.push_back({trace.front(), trace.back(), 0, piece.is_border, true});
        else
            for (std::size_t i = 0; i < std::size_t(count); ++i)
                segments_.push_back({trace[i], trace[i + 1], 0.15, piece.is_border, false});
        if (piece.is_border) border_ends_.push_back(points.front()), border_ends_.push_back(points.back());
        return true;
    }

    /// A circle round a cylinder or a cone is straight in the parameter plane.
    bool runs_around(const std::vector<Uv>& trace) const {
        const SurfaceKind kind = chart_.underlying().kind;
        return (kind == SurfaceKind::cylinder || kind == SurfaceKind::cone) &&
               std::all_of(trace.begin(), trace.end(),
                           [&](const Uv& uv) { return std::abs(uv[1] - trace[0][1]) <= pair_.sameness.length; });
    }

    /// Parameters of the end of an earlier piece at the same place: on a free-form underlying surface a search from
    /// nothing is dear.
    std::optional<Uv> end_near(const Vec3& p) const {
        if (chart_.underlying().kind != SurfaceKind::free_form) return std::nullopt;
        for (const auto& [end, uv] : ends_)
            if (distance(end, p) <= gap) return uv;
        return std::nullopt;
    }

    /// The finest along a piece of that length; between two looks it changes by less than half.
    double resolution_along(const UnderlyingCurve& curve, const ChangedPiece& piece, double length) const {
        double least = resolution_.at(point_at(curve, piece.first));
        if (!resolution_.coarser) return least;
        const int looks = int(std::clamp(std::ceil(length / least), 1.0, 16.0));
        for (int i = 1; i <= looks; ++i)
            least =
                std::min(least, resolution_.at(point_at(curve, piece.first + (piece.last - piece.first) * i / looks)));
        return least;
    }

    static double length_of(const UnderlyingCurve& curve, const ChangedPiece& piece) {
        if (curve.kind == CurveKind::line) return piece.last - piece.first;
        if (curve.kind != CurveKind::free_form) return curve.radius * (piece.last - piece.first);
        double length = 0;
        Vec3 last = point_at(curve, piece.first);
        for (int i = 1; i <= 16; ++i) {
            const Vec3 p = point_at(curve, piece.first + (piece.last - piece.first) * i / 16);
            length += distance(last, p), last = p;
        }
        return length;
    }

    int samples_of(const UnderlyingCurve& curve, const ChangedPiece& piece) const {
        const SurfaceKind kind = chart_.underlying().kind;
        if (curve.kind == CurveKind::line && kind != SurfaceKind::free_form) return 1;
        // No chord strays from its curve by more than an eighth of the resolution.
        const double length = length_of(curve, piece), resolution = resolution_along(curve, piece, length),
                     sampling = std::min(std::max(leaf_, resolution), 10 * resolution);
        if (curve.kind == CurveKind::line) return int(std::clamp(std::ceil(4 * length / sampling), 4.0, 400.0));
        const bool is_free = curve.kind == CurveKind::free_form;
        const double turns = is_free ? 24 : (piece.last - piece.first) / 0.2;
        return int(std::clamp(std::max(std::ceil(2 * length / sampling), turns), 2.0, is_free ? 1000.0 : 10000.0));
    }

    // A difference ends at changed pieces, so its extent is theirs, except round a sphere or a torus or on a closed
    // free-form underlying surface.
    UvBox root_box() {
        const SurfaceKind kind = chart_.underlying().kind;
        if (kind == SurfaceKind::free_form) return natural_;
        constexpr double pi = 3.14159265358979323846;
        if (kind == SurfaceKind::sphere) return cut_to_borders(UvBox{{0, -pi / 2}, {2 * pi, pi / 2}});
        if (kind == SurfaceKind::torus) return cut_to_borders(UvBox{{0, 0}, {2 * pi, 2 * pi}});
        UvBox box;
        for (const Segment& s : segments_) box.add(s.a), box.add(s.b);
        if (kind != SurfaceKind::plane) std::tie(box.low[0], box.high[0]) = covered_arc(0);
        if (box.is_empty()) box.add({0, 0});
        chart_.scale_for(box);
        for (int k = 0; k < 2; ++k)
            if (const double least = 0.25 * leaf_ / chart_.scale()[k]; box.size(k) < least)
                box.low[k] -= least / 2, box.high[k] += least / 2;
        return box;
    }

    // Round a closed underlying surface an arc without borders is wholly inside or wholly outside the difference: ask
    // there.
    UvBox cut_to_borders(UvBox box) const {
        for (int k = 0; k < 2; ++k) {
            const double full = chart_.period(k);
            if (full == 0 || segments_.empty()) continue;
            const auto [begin, end] = covered_arc(k);
            const double free = begin + full - end, slack = std::min(0.25 * free, 0.05 * (end - begin) + 1e-3);
            if (free < 1e-2 || !is_outside_along(box, k, end + 0.5 * free)) continue;
            box.low[k] = begin - slack;
            box.high[k] = end + slack;
        }
        return box;
    }

    bool is_outside_along(const UvBox& box, int k, double at) const {
        for (const double share : {0.37, 0.13, 0.71}) {
            Uv uv = box.at(share, share);
            uv[std::size_t(k)] = at;
            if (const auto verdict = differs_by_trims(uv)) return !*verdict;
        }
        return false;
    }

    /// The domain seen along the plane's normal.
    UvBox domain_in_plane() const {
        UvBox box;
        for (int corner = 0; corner < 8; ++corner)
            box.add(parameters_of(chart_.underlying(), {corner & 1 ? pair_.domain->high.x : pair_.domain->low.x,
                                                        corner & 2 ? pair_.domain->high.y : pair_.domain->low.y,
                                                        corner & 4 ? pair_.domain->high.z : pair_.domain->low.z}));
        return box;
    }

    /// False when nothing is left.
    bool clip_root_to_domain() {
        if (!pair_.domain) return true;
        const UvBox domain = domain_in_plane();
        for (int k = 0; k < 2; ++k) {
            root_.low[k] = std::max(root_.low[k], domain.low[k]),
            root_.high[k] = std::min(root_.high[k], domain.high[k]);
            if (root_.size(k) <= 0) return false;
        }
        return true;
    }

    /// A whole circle in a plane that does not come near the domain: every point there is outside it.
    bool is_far_loop(const ChangedPiece& piece) const {
        const UnderlyingCurve& curve = match_.curves[std::size_t(piece.curve)];
        if (!pair_.domain || chart_.underlying().kind != SurfaceKind::plane || curve.kind != CurveKind::circle ||
            piece.last - piece.first < period_of(curve) - 1e-9)
            return false;
        const Uv centre = parameters_of(chart_.underlying(), to_vec3(curve.position.Location()));
        const UvBox domain = domain_in_plane();
        const double reach = curve.radius + leaf_;
        return centre[0] + reach < domain.low[0] || centre[0] - reach > domain.high[0] ||
               centre[1] + reach < domain.low[1] || centre[1] - reach > domain.high[1];
    }

    // Where no border is over a whole arc, a line along the axis there meets no border: it is outside the difference.
    std::tuple<double, double> covered_arc(int k) const {
        const double full = chart_.period(k);
        std::vector<std::array<double, 2>> arcs;
        for (const Segment& s : segments_) {
            const double low = std::min(s.a[k], s.b[k]), length = std::abs(s.a[k] - s.b[k]);
            const double start = low - full * std::floor(low / full);
            arcs.push_back({start, start + length});
        }
        if (arcs.empty()) return {0, full};
        std::sort(arcs.begin(), arcs.end());
        double reach = arcs[0][1], widest = -1, begin = 0;
        for (const auto& arc : arcs) reach = std::max(reach, arc[1] - full);
        for (const auto& arc : arcs) {
            if (arc[0] - reach > widest) widest = arc[0] - reach, begin = arc[0];
            reach = std::max(reach, arc[1]);
        }
        if (arcs[0][0] + full - reach > widest) widest = arcs[0][0] + full - reach, begin = arcs[0][0];
        return widest <= 1e-9 ? std::tuple{0.0, full} : std::tuple{begin, begin + full - widest};
    }

    // Segments are repeated a period away where that reaches into the root.
    void shift_into_root() {
        for (int k = 0; k < 2; ++k) {
            const double full = chart_.period(k);
            if (full == 0) continue;
            std::vector<Segment> shifted;
            for (const Segment& s : segments_) {
                const double low = std::min(s.a[k], s.b[k]), high = std::max(s.a[k], s.b[k]);
                const double slack = 1e-9 + s.margin * (high - low);
                for (double n = std::floor((root_.low[k] - high - slack) / full);
                     n * full <= root_.high[k] - low + slack; ++n)
                    if (high + n * full >= root_.low[k] - slack) {
                        shifted.push_back(s);
                        shifted.back().a[k] += n * full, shifted.back().b[k] += n * full;
                    }
            }
            segments_ = std::move(shifted);
        }
    }

    void widen_margins() {
        const Uv scale = chart_.scale();
        for (Segment& s : segments_) {
            const double length = std::hypot((s.b[0] - s.a[0]) * scale[0], (s.b[1] - s.a[1]) * scale[1]);
            s.margin = s.margin * length + 2 * pair_.sameness.length;
        }
    }

    // Liang and Barsky: the part of the segment inside the box grown by the margin.
    bool enters(const Segment& s, const UvBox& box) const {
        double from = 0, to = 1;
        for (int k = 0; k < 2; ++k) {
            const double margin = s.margin / chart_.scale()[k];
            const double low = box.low[k] - margin, high = box.high[k] + margin, d = s.b[k] - s.a[k];
            if (d == 0) {
                if (s.a[k] < low || s.a[k] > high) return false;
                continue;
            }
            const double t0 = (low - s.a[k]) / d, t1 = (high - s.a[k]) / d;
            from = std::max(from, std::min(t0, t1));
            to = std::min(to, std::max(t0, t1));
        }
        return from <= to;
    }

    /// Bounds of the resolution at a cell's middle, as far as a look at the middle of a cell around it tells. No cell
    /// asks for its own where they suffice.
    struct ResolutionBounds {
        double least = 0, most = 1e300;
        ResolutionBounds after(double change) const { return {least - change, most + change}; }
    };

    bool is_small(const UvBox& cell, double extent, ResolutionBounds& bounds) const {
        if (extent <= leaf_) return true;
        if (!resolution_.coarser || extent > bounds.most) return false;
        if (extent > bounds.least) bounds.least = bounds.most = resolution_.at(chart_.point(cell.at(0.5, 0.5)));
        return extent <= bounds.least;
    }

    /// `first`: from there on `entering_` has the segments that enter the cell.
    void visit(const UvBox& cell, std::size_t first, ResolutionBounds bounds) {
        const Uv scale = chart_.scale();
        const double width = cell.size(0) * scale[0], height = cell.size(1) * scale[1];
        if (outside_domain(cell, width, height)) return;
        const std::size_t end = entering_.size();
        if (first == end) {
            if (differs(cell)) cells_.add(cell);
            return;
        }
        if (is_between_lines(first)) return emit_between_lines(cell, first);
        const double extent = std::max(width, height);
        if (is_small(cell, extent, bounds)) return cells_.add(cell);
        const ResolutionBounds of_halves = bounds.after(resolution_.slope * 0.25 * extent);
        const int k = width >= height ? 0 : 1;
        UvBox low = cell, high = cell;
        low.high[k] = high.low[k] = 0.5 * (cell.low[k] + cell.high[k]);
        for (const UvBox* half : {&low, &high}) {
            for (std::size_t i = first; i < end; ++i)
                if (const int s = entering_[i]; enters(segments_[std::size_t(s)], *half)) entering_.push_back(s);
            visit(*half, end, of_halves);
            entering_.resize(end);
        }
    }

    bool outside_domain(const UvBox& cell, double width, double height) const {
        if (!pair_.domain) return false;
        const Vec3 centre = chart_.point(cell.at(0.5, 0.5));
        return !pair_.domain->grown(0.5 * std::hypot(width, height) + resolution_.finest).contains(centre);
    }

    /// Few lines, all straight, enter the cell, and what is between them can be told.
    bool is_between_lines(std::size_t first) const {
        constexpr std::size_t few = 8;
        return by_crossings_ && entering_.size() - first <= few &&
               std::all_of(entering_.begin() + std::ptrdiff_t(first), entering_.end(),
                           [&](int s) { return segments_[std::size_t(s)].is_straight; });
    }

    /// Just what differs of the cell, and edges that only one state has.
    void emit_between_lines(const UvBox& cell, std::size_t first) {
        std::vector<UvLine> borders;
        for (std::size_t i = first; i < entering_.size(); ++i) {
            const Segment& s = segments_[std::size_t(entering_[i])];
            const auto part = part_inside({s.a, s.b}, s.is_border ? cell : grown(cell, s.margin));
            if (part && s.is_border)
                borders.push_back(*part);
            else if (part)
                cells_.add_line(*part);
        }
        for (const CellStrip& strip : strips_of(cell, borders, 2 * gap / chart_.scale()[0])) emit_strip(strip);
    }

    UvBox grown(UvBox box, double margin) const {
        for (std::size_t k = 0; k < 2; ++k)
            box.low[k] -= margin / chart_.scale()[k], box.high[k] += margin / chart_.scale()[k];
        return box;
    }

    /// Every border is one between what differs and what does not. Where nothing tells, all of the strip differs.
    void emit_strip(const CellStrip& strip) {
        const std::size_t widest = strip.widest();
        std::optional<bool> differs;
        for (const double share : {strip.middle, 0.37, 0.71})
            if (!differs) differs = differs_by_crossings(strip.between(widest, share));
        for (std::size_t k = 0; k + 1 < strip.heights.size(); ++k)
            if (!differs || *differs == ((k + widest) % 2 == 0)) cells_.add_between(strip, k);
    }

    /// On these underlying surfaces the difference ends along every line u = const.
    bool has_open_lines() const {
        const SurfaceKind kind = chart_.underlying().kind;
        return kind == SurfaceKind::plane || kind == SurfaceKind::cylinder || kind == SurfaceKind::cone;
    }

    /// Whether the borders of the difference are closed lines, as they are when the shapes' vertices are where their
    /// edges end.
    bool borders_close() {
        std::sort(border_ends_.begin(), border_ends_.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
        std::vector<char> visited(border_ends_.size(), 0);
        for (std::size_t i = 0; i < border_ends_.size(); ++i) {
            if (visited[i]) continue;
            int meeting = 0;
            for (std::size_t j = i; j < border_ends_.size() && border_ends_[j].x - border_ends_[i].x <= 2 * gap; ++j)
                if (!visited[j] && distance(border_ends_[i], border_ends_[j]) <= 2 * gap) visited[j] = 1, ++meeting;
            if (meeting % 2 != 0) return false;
        }
        return true;
    }

    void sort_into_columns() {
        columns_.resize(std::clamp<std::size_t>(segments_.size() / 4, 1, 1000));
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const Segment& s = segments_[i];
            if (!s.is_border) continue;
            const double slack = 2 * gap / chart_.scale()[0];
            const int last = column_of(std::max(s.a[0], s.b[0]) + slack);
            for (int c = column_of(std::min(s.a[0], s.b[0]) - slack); c <= last; ++c)
                columns_[std::size_t(c)].push_back(int(i));
        }
    }

    int column_of(double u) const {
        const double share = (u - root_.low[0]) / root_.size(0);
        return int(std::clamp(share * double(columns_.size()), 0.0, double(columns_.size()) - 1));
    }

    /// Of a cell that nothing enters. True also when no point of it could be told.
    bool differs(const UvBox& cell) {
        if (by_crossings_) return told(cell, [&](const Uv& uv) { return differs_by_crossings(uv); }).value_or(true);
        auto verdict = told_->beside(cell);
        if (!verdict) verdict = told(cell, [&](const Uv& uv) { return differs_by_trims(uv); });
        if (!verdict) return true;
        told_->add(cell, *verdict);
        return *verdict;
    }

    template <class DiffersAt>
    std::optional<bool> told(const UvBox& cell, const DiffersAt& differs_at) const {
        constexpr double fractions[][2] = {{0.5, 0.5}, {0.29, 0.37}, {0.71, 0.59}, {0.37, 0.73}, {0.61, 0.23}};
        for (const auto& [s, t] : fractions)
            if (const auto verdict = differs_at(cell.at(s, t))) return verdict;
        return std::nullopt;
    }

    /// The parity of the borders between the point and infinity, on a cone away from the apex; nothing when a border
    /// starts there.
    std::optional<bool> differs_by_crossings(const Uv& uv) const {
        const UnderlyingSurface& c = chart_.underlying();
        const double nappe = (c.radius + uv[1] * std::sin(c.second)) * std::sin(c.second);
        const double away = c.kind == SurfaceKind::cone && nappe < 0 ? -1 : 1;
        const double slack = gap / chart_.scale()[0];
        bool odd = false;
        for (const int i : columns_[std::size_t(column_of(uv[0]))]) {
            const Segment& s = segments_[std::size_t(i)];
            if (std::abs(s.a[0] - uv[0]) <= slack || std::abs(s.b[0] - uv[0]) <= slack) return std::nullopt;
            if ((s.a[0] < uv[0]) == (s.b[0] < uv[0])) continue;
            const double v = s.a[1] + (s.b[1] - s.a[1]) * (uv[0] - s.a[0]) / (s.b[0] - s.a[0]);
            if ((v - uv[1]) * away > 0) odd = !odd;
        }
        return odd;
    }

    std::optional<bool> differs_by_trims(const Uv& uv) const {
        const Vec3 p = chart_.point(uv);
        const Containment was = containment(pair_.old_model, group_.old_faces, to_old_.apply(p), uv);
        const Containment is = containment(pair_.new_model, group_.new_faces, p, uv);
        return was == Containment::on || is == Containment::on ? std::nullopt : std::optional(was != is);
    }

    Containment containment(const BoundaryModel& model, const std::vector<FaceId>& faces, const Vec3& p,
                            const Uv& uv) const {
        Containment result = Containment::outside;
        for (const FaceId f : faces) {
            const BoundaryFace& face = model.faces()[f.index()];
            if (!face.box.grown(pair_.sameness.length).contains(p)) continue;
            const bool free = face.underlying.kind == SurfaceKind::free_form;
            const Containment here = model.classify(f, free ? uv : parameters_of(face.underlying, p));
            if (here == Containment::inside) return here;
            if (here == Containment::on) result = Containment::on;
        }
        return result;
    }

    const BoundaryPair& pair_;
    const BoundaryMatch& match_;
    const SurfaceGroup& group_;
    const Resolution& resolution_;
    double leaf_;
    RigidMotion to_old_;
    SurfaceChart chart_;
    SurfaceCells cells_;
    UvBox natural_;  // on a free-form underlying surface
    UvBox root_;
    std::vector<Segment> segments_;
    std::vector<int> entering_;  ///< the cell that is visited; before them those that enter the cells around it
    std::vector<Vec3> border_ends_;
    std::vector<std::pair<Vec3, Uv>> ends_;  ///< of all pieces, with their parameters
    std::optional<ToldCells> told_;
    bool by_crossings_ = false;
    std::vector<std::vector<int>> columns_;  ///< border segments by u
};
}  // namespace

void append_trim_difference(const BoundaryPair& pair, const BoundaryMatch& match, const SurfaceGroup& group,
                            const Resolution& resolution, std::vector<SpaceTriangle>& triangles) {
    if (!group.is_unchanged()) TrimRaster(pair, match, group, resolution, triangles).run();
}

}  // namespace featuremesh
