// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/surface_cells.h"

#include <algorithm>
#include <cmath>

#include "core/distances.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

void SurfaceCells::begin_in(const UvBox& root) {
    step_ = chart_.step_for_sag(resolution_.finest / 8);
    least_free_form_cell_ = std::hypot(root.size(0) * chart_.scale()[0], root.size(1) * chart_.scale()[1]) / 150;
}

void SurfaceCells::add(const UvBox& cell) {
    if (chart_.underlying().kind == SurfaceKind::free_form) return add_free_form(cell);
    const int columns = parts_of(cell.size(0), 0), rows = parts_of(cell.size(1), 1);
    const auto corner = [&](int i, int j) { return chart_.point(cell.at(double(i) / columns, double(j) / rows)); };
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j)
            add_quadrilateral({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
}

void SurfaceCells::add_between(const CellStrip& strip, std::size_t height) {
    const int columns = parts_of(strip.right - strip.left, 0);
    for (int i = 0; i < columns; ++i) {
        const double from = double(i) / columns, to = double(i + 1) / columns;
        add_quadrilateral({chart_.point(strip.at(height, from)), chart_.point(strip.at(height, to)),
                           chart_.point(strip.at(height + 1, to)), chart_.point(strip.at(height + 1, from))});
    }
}

void SurfaceCells::add_line(const UvLine& line) {
    const auto& [a, b] = line;
    const auto at = [&](double share) {
        return chart_.point({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
    };
    const int pieces = parts_of(std::abs(b[0] - a[0]), 0);
    for (int i = 0; i < pieces; ++i) {
        const Vec3 end = at(double(i + 1) / pieces);
        triangles_.push_back({at(double(i) / pieces), end, end});
    }
}

void SurfaceCells::add_free_form(const UvBox& cell) {
    const auto at = [&](double s, double t) { return chart_.point(cell.at(s, t)); };
    const Vec3 middle = at(0.5, 0.5);
    add_free_form(cell, {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, {middle, resolution_.at(middle)}, 0);
}

// Divides the cell into quarters until its middle, and the middles of its borders, are close to its two triangles. The
// wanted resolution is costly to find: the last one found nearby bounds it, and it is computed anew only where these
// bounds do not decide.
void SurfaceCells::add_free_form(const UvBox& cell, const Corners& corners, Look look, int depth) {
    const auto& [a, b, c, d] = corners;
    const auto at = [&](double s, double t) { return chart_.point(cell.at(s, t)); };
    const Vec3 ab = at(0.5, 0), bc = at(1, 0.5), cd = at(0.5, 1), da = at(0, 0.5), middle = at(0.5, 0.5);
    const double strays = std::max({squared_distance_to_segment(ab, a, b), squared_distance_to_segment(bc, b, c),
                                    squared_distance_to_segment(cd, c, d), squared_distance_to_segment(da, d, a),
                                    squared_distance_to_segment(middle, a, c)});
    const double extent = std::max(distance(a, c), distance(b, d));
    const auto suffices = [&](double resolution) {
        const double sag = resolution / 8;
        return strays <= sag * sag && extent <= std::max(2 * resolution, least_free_form_cell_);
    };
    const double change = resolution_.slope * distance(look.place, middle);
    const bool may_suffice = suffices(look.resolution + change);
    bool does_suffice = may_suffice && suffices(look.resolution - change);
    if (may_suffice && !does_suffice) {
        look = {middle, resolution_.at(middle)};
        does_suffice = suffices(look.resolution);
    }
    if (does_suffice || depth >= 9) return add_quadrilateral(corners);
    const Corners quarters[] = {{a, ab, middle, da}, {ab, b, bc, middle}, {da, middle, cd, d}, {middle, bc, c, cd}};
    for (int quarter = 0; quarter < 4; ++quarter) {
        UvBox part;
        part.add(cell.at(0.5, 0.5));
        part.add(cell.at(quarter & 1, quarter >> 1));
        add_free_form(part, quarters[quarter], look, depth + 1);
    }
}

void SurfaceCells::add_quadrilateral(const Corners& corners) {
    const auto& [a, b, c, d] = corners;
    add_triangle(a, b, c);
    add_triangle(a, c, d);
}

// At a pole a border has no length.
void SurfaceCells::add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (squared_length(cross(b - a, c - a)) > 0) triangles_.push_back({a, b, c});
}

int SurfaceCells::parts_of(double size, std::size_t direction) const {
    return std::max(1, int(std::ceil(size / step_[direction] - 1e-9)));
}

}  // namespace featuremesh
