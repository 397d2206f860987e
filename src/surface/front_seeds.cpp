// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "core/geometry.h"
#include "surface/seeds.h"

namespace featuremesh {

namespace {

/// A seed nearer to another one than this share of the wanted length is one too many.
constexpr double spacing = 0.72;
/// A seed nearer than this to the middle of a boundary piece makes a flat triangle there.
constexpr double boundary_spacing = 0.5;

/// Points in space in cells of about their own spacing, one grid per power of two of the spacing.
class PointGrid {
  public:
    void add(const Vec3& p, double reach) {
        const int level = level_of(reach);
        const Cell c = cell_of(p, level);
        auto& first = heads_.try_emplace(key(c, level), -1).first->second;
        entries_.push_back({p, reach, first});
        first = static_cast<int>(entries_.size()) - 1;
        low_level_ = std::min(low_level_, level), high_level_ = std::max(high_level_, level);
    }

    /// Whether a point lies nearer than its own reach or than `reach`, whichever is smaller.
    bool has_near(const Vec3& p, double reach) const {
        const int level = level_of(reach);
        for (int l = std::max(low_level_, level - 1); l <= std::min(high_level_, level + 1); ++l)
            if (has_near_on_level(p, reach, l)) return true;
        return false;
    }

  private:
    struct Cell {
        long x, y, z;
    };
    struct Entry {
        Vec3 p;
        double reach;
        int next;
    };
    static int level_of(double reach) { return std::ilogb(reach) + 1; }
    static Cell cell_of(const Vec3& p, int level) {
        const double inverse = std::ldexp(1.0, -level);
        return {static_cast<long>(std::floor(p.x * inverse)), static_cast<long>(std::floor(p.y * inverse)),
                static_cast<long>(std::floor(p.z * inverse))};
    }
    static std::uint64_t key(const Cell& c, int level) {
        auto mix = [](std::uint64_t h, long v) { return (h ^ static_cast<std::uint64_t>(v)) * 0x9E3779B97F4A7C15ull; };
        std::uint64_t h = mix(mix(mix(mix(0x51ED270B, c.x), c.y), c.z), level);
        return h ^ (h >> 29);
    }

    bool has_near_on_level(const Vec3& p, double reach, int level) const {
        const double width = std::ldexp(1.0, level), limit = std::min(reach, width);
        const Cell low = cell_of(p - Vec3{limit, limit, limit}, level),
                   high = cell_of(p + Vec3{limit, limit, limit}, level);
        for (long x = low.x; x <= high.x; ++x)
            for (long y = low.y; y <= high.y; ++y)
                for (long z = low.z; z <= high.z; ++z) {
                    const auto head = heads_.find(key({x, y, z}, level));
                    if (head == heads_.end()) continue;
                    for (int e = head->second; e >= 0; e = entries_[static_cast<std::size_t>(e)].next) {
                        const Entry& entry = entries_[static_cast<std::size_t>(e)];
                        const double r = std::min(reach, entry.reach);
                        if (squared_length(entry.p - p) < r * r) return true;
                    }
                }
        return false;
    }

    std::unordered_map<std::uint64_t, int> heads_;
    std::vector<Entry> entries_;
    int low_level_ = 1 << 20, high_level_ = -(1 << 20);
};

struct Seed {
    Vec2 point;
    Vec3 place, direction;  ///< direction of one of its six neighbours, in the surface
    double wanted = 0;
    void* hint = nullptr;
};

class Front {
  public:
    Front(const FaceBoundary& boundary, std::span<const double> wanted, const ChartDomain& domain, const Chart& chart,
          const WantedLength& sizing, const Mesh& mesh, const Heartbeat& heart)
        : boundary_(boundary),
          wanted_(wanted),
          domain_(domain),
          chart_(chart),
          sizing_(sizing),
          mesh_(mesh),
          heart_(heart) {}

    Seeds grow() {
        place_boundary();
        plant_rings();
        const std::size_t ring_count = seeds_.size();
        for (const auto& s : boundary_.segments)
            if (!s.is_pole) start_from(s, 1);
        for (const auto& s : boundary_.inner) start_from(s, 1), start_from(s, -1);
        for (std::size_t i = 0; i < seeds_.size(); ++i) {
            if (i % 1024 == 0) heart_.beat();
            grow_around(i);
        }
        Seeds seeds;
        seeds.fixed_count = ring_count;
        for (const Seed& s : seeds_) seeds.points.push_back(s.point), seeds.wanted.push_back(s.wanted);
        return seeds;
    }

  private:
    Vec2 point(int p) const { return boundary_.points[static_cast<std::size_t>(p)]; }
    double wanted(int p) const { return wanted_[static_cast<std::size_t>(p)]; }
    Vec3 place(int p) const { return mesh_.point(boundary_.nodes[static_cast<std::size_t>(p)]); }

    void place_boundary() {
        const auto add_piece = [&](const BoundarySegment& s) {
            const Vec3 a = place(s.a), b = place(s.b);
            const double h = wanted(s.a), l = s.is_pole ? h : distance(a, b);
            grid_.add(a, spacing * std::max(l, h));
            if (!s.is_pole) grid_.add(0.5 * (a + b), boundary_spacing * std::min(l, 2 * h));
        };
        for (const auto& s : boundary_.segments) add_piece(s);
        for (const auto& s : boundary_.inner) add_piece(s), grid_.add(place(s.b), spacing * wanted(s.b));
        for (const int p : boundary_.lone_points) grid_.add(place(p), spacing * wanted(p));
    }

    /// What of a cone lies around its apex: two boundary points as far along the pieces that end there.
    struct Tip {
        int from, to;
        double sector;  ///< angle in the plane between them, counterclockwise
    };

    /// Rings of nodes around a cone's apex. Angles say nothing there: the fewer triangles meet in the apex, the better
    /// they look in the developed plane, and the flatter is the tip. Further out a side as long as wanted may still
    /// reach half around.
    void plant_rings() {
        for (Tip tip : find_tips()) {
            tip = beyond_short_pieces(tip);
            plant_ring(tip);
            while (!is_fine_enough(tip) && step_out(tip)) plant_ring(tip);
        }
    }

    std::vector<Tip> find_tips() const {
        std::vector<Tip> tips;
        if (chart_.cone_sine() == 0) return tips;
        for (const auto& out : boundary_.segments) {
            if (!is_apex(out.a)) continue;
            Tip tip{out.b, -1, 2 * M_PI};
            for (const auto& in : boundary_.segments) {
                if (in.b != out.a) continue;
                const double turn = std::fmod(angle_of(in.a) - angle_of(out.b) + 4 * M_PI, 2 * M_PI);
                if (turn > 1e-9 && turn < tip.sector) tip.sector = turn, tip.to = in.a;
            }
            if (tip.to >= 0) tips.push_back(tip);
        }
        return tips;
    }

    /// Where a border passes close by the apex a ring through the ends of the pieces there would be tiny: on to points
    /// as far out as there is to be room.
    Tip beyond_short_pieces(const Tip& tip) const {
        Tip further = tip;
        const auto move_on = [&](int& p, bool ahead) {
            for (const double least = 0.5 * wanted(p); length_of(p) < least;) {
                const int next = next_outside(p, ahead);
                if (next < 0) return false;
                const double turn = std::remainder(angle_of(next) - angle_of(p), 2 * M_PI);
                further.sector -= ahead ? turn : -turn;
                p = next;
            }
            return true;
        };
        return move_on(further.from, true) && move_on(further.to, false) && further.sector > 0 ? further : tip;
    }

    double radius_of(const Tip& tip) const { return 0.5 * (length_of(tip.from) + length_of(tip.to)); }

    /// Whether so many sides as wanted go around there that none reaches far.
    bool is_fine_enough(const Tip& tip) const {
        constexpr double enough = 5;
        return tip.sector * radius_of(tip) > enough * std::max(wanted(tip.from), wanted(tip.to));
    }

    /// On to the next points on the same straight lines from the apex, if there are any.
    bool step_out(Tip& tip) const {
        const int from = next_outside(tip.from, true), to = next_outside(tip.to, false);
        if (from < 0 || to < 0 || !are_in_line(tip.from, from) || !are_in_line(tip.to, to)) return false;
        tip.from = from, tip.to = to;
        return true;
    }

    bool are_in_line(int p, int q) const {
        return std::abs(cross(point(p), point(q))) < 1e-6 * length_of(p) * length_of(q);
    }

    /// The other end of the border's next piece, if that is further from the apex.
    int next_outside(int p, bool ahead) const {
        for (const auto& s : boundary_.segments)
            if ((ahead ? s.a : s.b) == p)
                if (const int next = ahead ? s.b : s.a; length_of(next) > length_of(p)) return next;
        return -1;
    }

    void plant_ring(const Tip& tip) {
        constexpr double smallest_corner = 28 * M_PI / 180, least_clearance = 0.3;
        const double turn = tip.sector / chart_.cone_sine(), radius = radius_of(tip);
        const auto pieces_of = [&](double most) {
            return std::max(1, static_cast<int>(std::ceil(turn / most - 0.01)));
        };
        int pieces = pieces_of(2 * M_PI / 5);
        if (tip.sector / pieces < smallest_corner) pieces = pieces_of(M_PI / 2);
        pieces =
            std::max(pieces, static_cast<int>(std::lround(tip.sector * radius / std::max(wanted(tip.from), radius))));
        for (int k = 1; k < pieces; ++k) {
            const double share = static_cast<double>(k) / pieces, angle = angle_of(tip.from) + share * tip.sector;
            const double r = length_of(tip.from) + share * (length_of(tip.to) - length_of(tip.from));
            const Vec2 p{r * std::cos(angle), r * std::sin(angle)};
            void* hint = nullptr;
            if (!domain_.contains(p, hint) || is_at_boundary(p, least_clearance * tip.sector * r / pieces)) continue;
            const Chart::Frame frame = chart_.frame(p);
            const double h = sizing_.at(frame.point);
            grid_.add(frame.point, spacing * std::min(r, h));
            seeds_.push_back({p, frame.point, -std::sin(angle) * frame.dx + std::cos(angle) * frame.dy, h, hint});
        }
    }

    /// The straight lines may end at the base of the cone, whose pieces are where another ring would be.
    bool is_at_boundary(Vec2 p, double clearance) const {
        return std::any_of(boundary_.segments.begin(), boundary_.segments.end(), [&](const BoundarySegment& s) {
            const Vec2 along = point(s.b) - point(s.a), to_p = p - point(s.a);
            const double square = dot(along, along);
            const double share = square > 0 ? std::clamp(dot(to_p, along) / square, 0.0, 1.0) : 0;
            return distance(to_p, share * along) < clearance;
        });
    }

    double length_of(int p) const { return distance(point(p), Vec2{}); }
    bool is_apex(int p) const {
        return length_of(p) < 1e-7 * distance(point(boundary_.segments.front().a), point(boundary_.segments.front().b));
    }
    double angle_of(int p) const { return std::atan2(point(p).y, point(p).x); }

    /// The apex of the equilateral triangle on a piece.
    void start_from(const BoundarySegment& s, double sign) {
        const Vec2 middle = 0.5 * (point(s.a) + point(s.b));
        const Chart::Frame frame = chart_.frame(middle);
        const Vec3 along = place(s.b) - place(s.a);
        const double l = length(along);
        if (!(l > 0)) return;
        const Vec3 inwards = normalized(cross(cross(frame.dx, frame.dy), along));
        const double h = 0.5 * (wanted(s.a) + wanted(s.b)),
                     height = std::sqrt(std::max(0.25 * h * h, h * h - 0.25 * l * l));
        try_add(middle, frame, sign * height * inwards, along, at_border_, 0.5 * (place(s.a) + place(s.b)));
    }

    void grow_around(std::size_t i) {
        const Seed seed = seeds_[i];
        const Chart::Frame frame = chart_.frame(seed.point);
        const Vec3 normal = normalized(cross(frame.dx, frame.dy));
        const Vec3 e1 = normalized(seed.direction - dot(seed.direction, normal) * normal), e2 = cross(normal, e1);
        const double h_here = seed.wanted, half = 0.5, height = std::sqrt(0.75);
        const std::array<std::array<double, 2>, 6> around{
            {{1, 0}, {half, height}, {-half, height}, {-1, 0}, {-half, -height}, {half, -height}}};
        for (const auto& [x, y] : around) {
            const Vec3 direction = x * e1 + y * e2, rough = seed.place + h_here * direction;
            if (grid_.has_near(rough, 0.5 * spacing * h_here)) continue;
            const double h = sizing_.is_uniform() ? h_here : 0.5 * (h_here + sizing_.at(rough));
            void* hint = seed.hint;
            try_add(seed.point, frame, h * direction, direction, hint, seed.place);
        }
    }

    /// Steps along the surface and adds what it reaches when that is inside and nothing is near.
    void try_add(Vec2 from, const Chart::Frame& frame, const Vec3& step, const Vec3& direction, void*& hint,
                 const Vec3& start) {
        Vec2 p;
        if (!step_in_chart(frame, step, p)) return;
        p = from + p;
        const Vec3 target = start + step;
        Chart::Frame there = chart_.frame(p);
        for (int round = 0; round < 3; ++round) {
            Vec2 correction;
            if (!step_in_chart(there, target - there.point, correction)) return;
            p = p + correction;
            const Chart::Frame next = chart_.frame(p);
            const double moved = distance(next.point, there.point);
            there = next;
            if (moved < 0.05 * length(step)) break;
        }
        if (distance(there.point, target) > 0.5 * length(step)) return;
        const double h = sizing_.at(there.point);
        if (grid_.has_near(there.point, spacing * h) || !domain_.contains(p, hint)) return;
        grid_.add(there.point, spacing * h);
        seeds_.push_back({p, there.point, direction, h, hint});
    }

    /// The step in the chart that moves by the given vector on the surface, in the least-squares sense; false where the
    /// surface is singular.
    static bool step_in_chart(const Chart::Frame& f, const Vec3& d, Vec2& step) {
        const double e = dot(f.dx, f.dx), g = dot(f.dy, f.dy), m = dot(f.dx, f.dy), det = e * g - m * m;
        if (!(det > 1e-12 * e * g)) return false;
        const double a = dot(f.dx, d), b = dot(f.dy, d);
        step = {(a * g - b * m) / det, (b * e - a * m) / det};
        return true;
    }

    const FaceBoundary& boundary_;
    std::span<const double> wanted_;
    const ChartDomain& domain_;
    const Chart& chart_;
    const WantedLength& sizing_;
    const Mesh& mesh_;
    const Heartbeat& heart_;
    PointGrid grid_;
    std::vector<Seed> seeds_;
    void* at_border_ = nullptr;  ///< hint of the last piece: the next one is near it, and a walk along a strip is long
};

}  // namespace

Seeds front_seeds(const FaceBoundary& boundary, std::span<const double> wanted, const ChartDomain& domain,
                  const Chart& chart, const WantedLength& sizing, const Mesh& mesh, const Heartbeat& heart) {
    return Front(boundary, wanted, domain, chart, sizing, mesh, heart).grow();
}

}  // namespace featuremesh
