// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "mesh/second_order.h"
#include "mesh/sharp_angles.h"
#include "mesh/side_table.h"

namespace featuremesh {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr std::size_t grain = 1 << 14;

/// Cosines of the six dihedral angles and the radius ratio of one tet.
struct TetShape {
    std::array<double, 6> cosines;
    double radius_ratio;
};

TetShape shape_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const Vec3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    // outward normals of the faces opposite b, c, d and a, each twice the area long
    const std::array<Vec3, 4> normal{-vw, -wu, -uv, vw + wu + uv};
    std::array<double, 4> area;
    std::array<double, 4> inverse;
    for (int i = 0; i < 4; ++i) {
        area[i] = length(normal[i]);
        inverse[i] = 1.0 / std::max(area[i], 1e-300);
    }
    TetShape shape;
    int k = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) shape.cosines[k++] = -dot(normal[i], normal[j]) * inverse[i] * inverse[j];
    // r = 3 V / sum of areas, R = |alpha| / (12 V) with alpha as below
    const double six_volume = std::abs(dot(u, vw));
    const Vec3 alpha = squared_length(u) * vw + squared_length(v) * wu + squared_length(w) * uv;
    const double areas = area[0] + area[1] + area[2] + area[3];
    shape.radius_ratio = 6 * six_volume * six_volume / std::max(areas * length(alpha), 1e-300);
    return shape;
}

double angle_deg(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * degrees; }

/// Arc cosine for sums, within 1.2e-6 degrees and without a call. Abramowitz and Stegun, 4.4.46.
double fast_angle_deg(double cosine) {
    const double x = std::min(std::abs(cosine), 1.0);
    double p = -0.0012624911;
    for (double c :
         {0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046, 0.0889789874, -0.2145988016, 1.5707963050})
        p = p * x + c;
    const double angle = std::sqrt(1 - x) * p * degrees;
    return cosine < 0 ? 180 - angle : angle;
}

/// Finds the 5-degree bin of an angle from its cosine without an arc cosine: a fine table gives the bin at a cell's
/// right end, and a cell holds at most one border.
class AngleBins {
  public:
    AngleBins() {
        for (int i = 0; i <= 36; ++i) border_[i] = std::cos(i * 5.0 / degrees);
        border_[36] = -2;
        for (int cell = 0; cell < cells; ++cell) {
            const double right = -1.0 + 2.0 * (cell + 1) / cells;
            int bin = 0;
            while (bin < 35 && right <= border_[bin + 1]) ++bin;
            first_[cell] = static_cast<std::uint8_t>(bin);
        }
    }
    int operator()(double cosine) const {
        const int cell = std::clamp(static_cast<int>((cosine + 1.0) * (cells / 2.0)), 0, cells - 1);
        const int bin = first_[cell];
        return bin + (cosine <= border_[bin + 1]);
    }

  private:
    static constexpr int cells = 2048;
    std::array<std::uint8_t, cells> first_;
    std::array<double, 37> border_;
};

/// What is summed up over one chunk of tets.
struct Tally {
    double largest_cosine = -1, smallest_cosine = 1;
    double largest_good_cosine = -1;              ///< of the tets that are not in `small`
    std::vector<std::pair<TetId, double>> small;  ///< tets below 25 degrees and the cosine of their smallest angle
    double sum_of_min_angles = 0, sum_of_ratios = 0, smallest_ratio = 1;
    double scaled_jacobian = 1;
    std::int64_t below_10 = 0, below_20 = 0;
    std::array<std::int64_t, 36> histogram{};
};

Tally tally_of(const Mesh& mesh, std::size_t begin, std::size_t end) {
    static const AngleBins bin_of;
    static const double cos_10 = std::cos(10 / degrees), cos_20 = std::cos(20 / degrees),
                        cos_25 = std::cos(QualityReport::small_angle_deg / degrees);
    Tally tally;
    for (std::size_t t = begin; t < end; ++t) {
        const auto& n = mesh.tets[t];
        const TetShape shape = shape_of(mesh.point(n[0]), mesh.point(n[1]), mesh.point(n[2]), mesh.point(n[3]));
        // without branches, which nobody can foretell here
        double low = shape.cosines[0], high = shape.cosines[0];
        for (const double cosine : shape.cosines) {
            low = std::min(low, cosine);
            high = std::max(high, cosine);
            ++tally.histogram[bin_of(cosine)];
        }
        tally.largest_cosine = std::max(tally.largest_cosine, high);
        tally.smallest_cosine = std::min(tally.smallest_cosine, low);
        tally.sum_of_min_angles += fast_angle_deg(high);
        tally.sum_of_ratios += shape.radius_ratio;
        tally.smallest_ratio = std::min(tally.smallest_ratio, shape.radius_ratio);
        tally.below_10 += high > cos_10;
        tally.below_20 += high > cos_20;
        if (high > cos_25)
            tally.small.emplace_back(TetId(t), high);
        else
            tally.largest_good_cosine = std::max(tally.largest_good_cosine, high);
        if (mesh.order == 2 && has_curved_side(mesh, TetId(t)))
            tally.scaled_jacobian = std::min(tally.scaled_jacobian, min_scaled_jacobian(tet_nodes(mesh, TetId(t))));
    }
    return tally;
}

void add(Tally& sum, const Tally& part) {
    sum.largest_cosine = std::max(sum.largest_cosine, part.largest_cosine);
    sum.smallest_cosine = std::min(sum.smallest_cosine, part.smallest_cosine);
    sum.largest_good_cosine = std::max(sum.largest_good_cosine, part.largest_good_cosine);
    sum.small.insert(sum.small.end(), part.small.begin(), part.small.end());
    sum.sum_of_min_angles += part.sum_of_min_angles;
    sum.sum_of_ratios += part.sum_of_ratios;
    sum.smallest_ratio = std::min(sum.smallest_ratio, part.smallest_ratio);
    sum.scaled_jacobian = std::min(sum.scaled_jacobian, part.scaled_jacobian);
    sum.below_10 += part.below_10;
    sum.below_20 += part.below_20;
    for (std::size_t i = 0; i < sum.histogram.size(); ++i) sum.histogram[i] += part.histogram[i];
}

QualityReport report_of(const Tally& tally, double count) {
    QualityReport report;
    report.min_dihedral = angle_deg(tally.largest_cosine);
    report.max_dihedral = angle_deg(tally.smallest_cosine);
    report.mean_min_dihedral = tally.sum_of_min_angles / count;
    report.mean_radius_ratio = tally.sum_of_ratios / count;
    report.min_radius_ratio = tally.smallest_ratio;
    report.min_scaled_jacobian = tally.scaled_jacobian;
    report.below_10 = tally.below_10;
    report.below_20 = tally.below_20;
    report.below_25 = static_cast<std::int64_t>(tally.small.size());
    report.histogram = tally.histogram;
    return report;
}

/// Tells the small angles that the CAD forces from those it does not.
void excuse_sharp_angles(const Mesh& mesh, const Tally& tally, QualityReport& report) {
    double largest_cosine = tally.largest_good_cosine;
    if (!tally.small.empty()) {
        report.worst = std::max_element(tally.small.begin(), tally.small.end(), [](const auto& a, const auto& b) {
                           return a.second < b.second;
                       })->first;
        const SharpAngles sharp(mesh, QualityReport::small_angle_deg);
        for (const auto& [tet, cosine] : tally.small) {
            if (sharp.force(tet))
                ++report.forced_by_cad;
            else
                largest_cosine = std::max(largest_cosine, cosine);
        }
    }
    report.min_dihedral_unforced = angle_deg(largest_cosine);
}

struct TriangleShape {
    std::array<double, 3> cosines;  ///< at the corners
    double radius_ratio;
};

TriangleShape triangle_shape(const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::array<Vec3, 3> side{b - a, c - b, a - c};
    const std::array<double, 3> long_side{length(side[0]), length(side[1]), length(side[2])};
    TriangleShape shape;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t before = (k + 2) % 3;
        shape.cosines[k] = -dot(side[before], side[k]) / std::max(long_side[before] * long_side[k], 1e-300);
    }
    // r = 2 A / (a + b + c), R = a b c / (4 A)
    const double double_area = length(cross(side[0], side[1])), product = long_side[0] * long_side[1] * long_side[2];
    shape.radius_ratio =
        4 * double_area * double_area / std::max((long_side[0] + long_side[1] + long_side[2]) * product, 1e-300);
    return shape;
}

/// Whether edges of the part force the smallest angle of a triangle: it lies between two of their segments, or opposite
/// one that is its edge's only one.
class ForcedTriangles {
  public:
    explicit ForcedTriangles(const Mesh& mesh) : segments_(mesh.corner_count) {
        for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
            segments_.value(mesh.segments[s][0], mesh.segments[s][1]) = mesh.segment_edges[s].value;
            ++pieces_[mesh.segment_edges[s]];
        }
    }
    bool is_forced(const std::array<NodeId, 3>& triangle, std::size_t sharpest) const {
        const NodeId at = triangle[sharpest], next = triangle[(sharpest + 1) % 3], last = triangle[(sharpest + 2) % 3];
        const std::int32_t opposite = segments_.find(next, last);
        return (segments_.find(at, next) >= 0 && segments_.find(at, last) >= 0) ||
               (opposite >= 0 && pieces_.at(EdgeId(opposite)) == 1);
    }

  private:
    SideTable segments_;
    std::map<EdgeId, int> pieces_;
};

QualityReport measure_triangles(const Mesh& mesh) {
    QualityReport report;
    const ForcedTriangles forced(mesh);
    report.min_dihedral = report.min_dihedral_unforced = 180;
    report.min_radius_ratio = 1;
    double angles = 0, ratios = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& nodes = mesh.triangles[t];
        const TriangleShape shape = triangle_shape(mesh.point(nodes[0]), mesh.point(nodes[1]), mesh.point(nodes[2]));
        const auto [low, high] = std::minmax_element(shape.cosines.begin(), shape.cosines.end());
        for (const double cosine : shape.cosines)
            ++report.histogram[std::min<std::size_t>(35, static_cast<std::size_t>(angle_deg(cosine) / 5))];
        const double smallest = angle_deg(*high);
        report.min_dihedral = std::min(report.min_dihedral, smallest);
        report.max_dihedral = std::max(report.max_dihedral, angle_deg(*low));
        report.min_radius_ratio = std::min(report.min_radius_ratio, shape.radius_ratio);
        angles += smallest, ratios += shape.radius_ratio;
        report.below_10 += smallest < 10, report.below_20 += smallest < 20;
        const bool is_small = smallest < QualityReport::small_angle_deg;
        const bool is_forced = is_small && forced.is_forced(nodes, std::size_t(high - shape.cosines.begin()));
        report.below_25 += is_small, report.forced_by_cad += is_forced;
        if (!is_forced) report.min_dihedral_unforced = std::min(report.min_dihedral_unforced, smallest);
        if (mesh.order == 2)
            report.min_scaled_jacobian =
                std::min(report.min_scaled_jacobian, min_scaled_jacobian(triangle_nodes(mesh, TriangleId(t))));
    }
    report.mean_min_dihedral = angles / double(mesh.triangles.size());
    report.mean_radius_ratio = ratios / double(mesh.triangles.size());
    return report;
}

}  // namespace

DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const TetShape shape = shape_of(a, b, c, d);
    const auto [low, high] = std::minmax_element(shape.cosines.begin(), shape.cosines.end());
    return {angle_deg(*high), angle_deg(*low)};
}

double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return shape_of(a, b, c, d).radius_ratio;
}

double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c) { return triangle_shape(a, b, c).radius_ratio; }

QualityReport measure_quality(const Mesh& mesh, RunContext& context) {
    if (mesh.tets.empty()) return mesh.triangles.empty() ? QualityReport{} : measure_triangles(mesh);
    std::vector<Tally> parts((mesh.tets.size() + grain - 1) / grain);
    parallel_for(context, mesh.tets.size(), grain,
                 [&](std::size_t begin, std::size_t end) { parts[begin / grain] = tally_of(mesh, begin, end); });
    Tally sum;
    for (const Tally& part : parts) add(sum, part);
    QualityReport report = report_of(sum, static_cast<double>(mesh.tets.size()));
    excuse_sharp_angles(mesh, sum, report);
    return report;
}

QualityReport measure_quality(const Mesh& mesh) {
    RunContext context;
    return measure_quality(mesh, context);
}

}  // namespace featuremesh
