// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/adopted_sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "core/geometry.h"
#include "core/ids.h"
#include "mesh/second_order.h"

namespace featuremesh {

namespace {

struct Sum {
    Vec3 place;
    double size = 0;
    int count = 0;
};

/// By corner node, mm; 0 for one without tets.
std::vector<double> mean_sides(const Mesh& mesh) {
    std::vector<double> sums(mesh.node_count(), 0), counts(mesh.node_count(), 0);
    for (const auto& tet : mesh.tets)
        for (const auto& [i, j] : tet_sides) {
            const double side = distance(mesh.point(tet[i]), mesh.point(tet[j]));
            for (const NodeId n : {tet[i], tet[j]}) sums[n.index()] += side, counts[n.index()] += 1;
        }
    for (std::size_t n = 0; n < sums.size(); ++n)
        if (counts[n] > 0) sums[n] /= counts[n];
    return sums;
}

/// Is the size asked for clearly below the mesh's mean size on its surface, weighted by area? Then the user wants finer
/// elements in updates.
bool is_finer_asked(const std::vector<SizeSource>& sources, double size) {
    double sum = 0, area = 0;
    for (const SizeSource& source : sources) sum += std::pow(source.size, 3), area += std::pow(source.size, 2);
    return sum > 1.4 * size * area;
}

}  // namespace

std::vector<SizeSource> local_sizes(const Mesh& mesh, double size) {
    const std::vector<double> sizes = mean_sides(mesh);
    // Cubes of two to four edge lengths: by the exponent of their width, and their place.
    std::map<std::array<std::int64_t, 4>, Sum> cubes;
    for (std::size_t n = 0; n < sizes.size(); ++n) {
        if (!(sizes[n] > 0)) continue;
        const int exponent = int(std::ceil(std::log2(2 * sizes[n])));
        const double width = std::exp2(exponent);
        const Vec3& p = mesh.points[n];
        const auto cell = [&](double x) { return std::int64_t(std::floor(x / width)); };
        Sum& cube = cubes[{exponent, cell(p.x), cell(p.y), cell(p.z)}];
        cube.place += p;
        cube.size += sizes[n];
        ++cube.count;
    }
    std::vector<SizeSource> sources;
    for (const auto& [key, cube] : cubes) sources.push_back({cube.place / cube.count, cube.size / cube.count});
    if (is_finer_asked(sources, size))
        for (SizeSource& source : sources) source.size = std::min(source.size, size);
    return sources;
}

}  // namespace featuremesh
