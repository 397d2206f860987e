// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/cell_strips.h"

#include <algorithm>
#include <utility>

namespace featuremesh {
namespace {

double height_of(const UvLine& line, double u) {
    const auto& [a, b] = line;
    return a[1] + (b[1] - a[1]) * (u - a[0]) / (b[0] - a[0]);
}

std::pair<double, double> extent_of(const UvLine& line) { return std::minmax(line[0][0], line[1][0]); }

/// Where two lines cross, if they do.
std::optional<double> crossing_of(const UvLine& a, const UvLine& b) {
    const auto [a_left, a_right] = extent_of(a);
    const auto [b_left, b_right] = extent_of(b);
    const double left = std::max(a_left, b_left), right = std::min(a_right, b_right);
    if (!(left < right)) return {};
    const double before = height_of(a, left) - height_of(b, left), after = height_of(a, right) - height_of(b, right);
    if (before == after || (before > 0) == (after > 0)) return {};
    return left + (right - left) * before / (before - after);
}

/// Borders of strips, ascending.
std::vector<double> stops_of(const UvBox& cell, std::span<const UvLine> lines, double slack) {
    std::vector<double> all;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const Uv& end : lines[i]) all.push_back(end[0]);
        for (std::size_t j = 0; j < i; ++j)
            if (const auto u = crossing_of(lines[i], lines[j])) all.push_back(*u);
    }
    std::sort(all.begin(), all.end());
    std::vector<double> stops{cell.low[0]};
    for (const double u : all)
        if (u > stops.back() + slack && u < cell.high[0] - slack) stops.push_back(u);
    stops.push_back(cell.high[0]);
    return stops;
}

CellStrip strip_between(double left, double right, const UvBox& cell, std::span<const UvLine> lines, double slack) {
    CellStrip strip{left, right, 0.5 + 0.5 * std::min(slack / (right - left), 0.5), {}};
    const double middle = left + strip.middle * (right - left);
    std::vector<std::pair<double, const UvLine*>> along;
    for (const UvLine& line : lines)
        if (const auto [from, to] = extent_of(line); from < middle && to > middle)
            along.emplace_back(height_of(line, middle), &line);
    std::sort(along.begin(), along.end());
    const auto within = [&](double v) { return std::clamp(v, cell.low[1], cell.high[1]); };
    strip.heights.push_back({cell.low[1], cell.low[1]});
    for (const auto& [height, line] : along)
        strip.heights.push_back({within(height_of(*line, left)), within(height_of(*line, right))});
    strip.heights.push_back({cell.high[1], cell.high[1]});
    return strip;
}

}  // namespace

std::size_t CellStrip::widest() const {
    const auto room_above = [&](std::size_t k) { return at(k + 1, middle)[1] - at(k, middle)[1]; };
    std::size_t widest = 0;
    for (std::size_t k = 1; k + 1 < heights.size(); ++k)
        if (room_above(k) > room_above(widest)) widest = k;
    return widest;
}

std::optional<UvLine> part_inside(const UvLine& line, const UvBox& box) {
    const auto& [a, b] = line;
    double from = 0, to = 1;
    for (std::size_t k = 0; k < 2; ++k) {
        const double d = b[k] - a[k];
        if (d == 0) {
            if (a[k] < box.low[k] || a[k] > box.high[k]) return {};
            continue;
        }
        const double at_low = (box.low[k] - a[k]) / d, at_high = (box.high[k] - a[k]) / d;
        from = std::max(from, std::min(at_low, at_high));
        to = std::min(to, std::max(at_low, at_high));
    }
    if (from > to) return {};
    const auto at = [&](double share) { return Uv{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])}; };
    return UvLine{from == 0 ? a : at(from), to == 1 ? b : at(to)};
}

std::vector<CellStrip> strips_of(const UvBox& cell, std::span<const UvLine> lines, double slack) {
    const std::vector<double> stops = stops_of(cell, lines, slack);
    std::vector<CellStrip> strips;
    for (std::size_t i = 1; i < stops.size(); ++i)
        strips.push_back(strip_between(stops[i - 1], stops[i], cell, lines, slack));
    return strips;
}

}  // namespace featuremesh
