// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "surface/seeds.h"

namespace featuremesh {

namespace {

/// Seeds nearer to the boundary than this share of the size would make flat triangles there.
constexpr double clearance = 0.55;

double squared_distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double l = dot(d, d), s = l > 0 ? std::clamp(dot(p - a, d) / l, 0.0, 1.0) : 0;
    const Vec2 r = p - (a + s * d);
    return dot(r, r);
}

/// Rows of a hexagonal lattice; every other row is shifted by half a size.
class Lattice {
  public:
    Lattice(const FaceBoundary& boundary, double size)
        : boundary_(boundary), size_(size), row_height_(size * std::sqrt(0.75)) {
        Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
        for (const auto& s : boundary.segments)
            for (const Vec2 p : {point(s.a), point(s.b)}) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
        first_row_ = static_cast<long>(std::floor(low.y / row_height_));
        first_column_ = static_cast<long>(std::floor(low.x / size)) - 1;
        rows_ = static_cast<long>(std::ceil(high.y / row_height_)) - first_row_ + 1;
        columns_ = static_cast<long>(std::ceil(high.x / size)) - first_column_ + 2;
        is_inside_.assign(static_cast<std::size_t>(rows_ * columns_), 0);
    }

    std::vector<Vec2> inside() {
        fill_rows();
        for (const auto& s : boundary_.segments) clear_near(point(s.a), point(s.b));
        for (const auto& s : boundary_.inner) clear_near(point(s.a), point(s.b));
        for (const int p : boundary_.lone_points) clear_near(point(p), point(p));
        std::vector<Vec2> seeds;
        for (long r = 0; r < rows_; ++r)
            for (long c = 0; c < columns_; ++c)
                if (is_inside_[index(r, c)]) seeds.push_back(at(r, c));
        return seeds;
    }

  private:
    Vec2 point(int p) const { return boundary_.points[static_cast<std::size_t>(p)]; }
    std::size_t index(long r, long c) const { return static_cast<std::size_t>(r * columns_ + c); }
    double row_y(long r) const { return static_cast<double>(first_row_ + r) * row_height_; }
    double row_shift(long r) const { return ((first_row_ + r) & 1) != 0 ? 0.5 * size_ : 0; }
    Vec2 at(long r, long c) const { return {static_cast<double>(first_column_ + c) * size_ + row_shift(r), row_y(r)}; }

    /// Between an odd and the next even crossing of a row with the boundary lies the inside.
    void fill_rows() {
        std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
        for (const auto& s : boundary_.segments) {
            const Vec2 a = point(s.a), b = point(s.b);
            const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
            const long from = std::max(0L, static_cast<long>(std::ceil(low / row_height_)) - first_row_ - 1);
            for (long r = from; r < rows_ && row_y(r) < high; ++r) {
                const double y = row_y(r);
                if (y >= low && y < high)
                    crossings[static_cast<std::size_t>(r)].push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            }
        }
        for (long r = 0; r < rows_; ++r) {
            auto& row = crossings[static_cast<std::size_t>(r)];
            std::sort(row.begin(), row.end());
            for (std::size_t k = 0; k + 1 < row.size(); k += 2) mark(r, row[k], row[k + 1]);
        }
    }

    void mark(long r, double from, double to) {
        const double offset = row_shift(r);
        const long first = std::max(0L, static_cast<long>(std::ceil((from - offset) / size_)) - first_column_);
        const long last = std::min(columns_ - 1, static_cast<long>(std::floor((to - offset) / size_)) - first_column_);
        for (long c = first; c <= last; ++c) is_inside_[index(r, c)] = 1;
    }

    void clear_near(Vec2 a, Vec2 b) {
        const double reach = clearance * size_;
        const long r0 =
            std::max(0L, static_cast<long>(std::floor((std::min(a.y, b.y) - reach) / row_height_)) - first_row_);
        const long r1 =
            std::min(rows_ - 1, static_cast<long>(std::ceil((std::max(a.y, b.y) + reach) / row_height_)) - first_row_);
        for (long r = r0; r <= r1; ++r) {
            const double offset = row_shift(r);
            const long c0 = std::max(
                0L, static_cast<long>(std::floor((std::min(a.x, b.x) - reach - offset) / size_)) - first_column_);
            const long c1 =
                std::min(columns_ - 1,
                         static_cast<long>(std::ceil((std::max(a.x, b.x) + reach - offset) / size_)) - first_column_);
            for (long c = c0; c <= c1; ++c)
                if (is_inside_[index(r, c)] && squared_distance_to_segment(at(r, c), a, b) < reach * reach)
                    is_inside_[index(r, c)] = 0;
        }
    }

    const FaceBoundary& boundary_;
    double size_, row_height_;
    long first_row_ = 0, first_column_ = 0, rows_ = 0, columns_ = 0;
    std::vector<char> is_inside_;
};

}  // namespace

std::vector<Vec2> lattice_seeds(const FaceBoundary& boundary, double size) { return Lattice(boundary, size).inside(); }

}  // namespace featuremesh
