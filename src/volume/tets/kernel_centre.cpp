// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/tets/kernel_centre.h"

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include "volume/tets/orientation.h"

namespace featuremesh {

namespace {

bool sees_all(const Vec3& point, std::span<const std::array<Vec3, 3>> triangles) {
    for (const auto& [a, b, c] : triangles)
        if (orientation(point, a, b, c) <= 0) return false;
    return true;
}

}  // namespace

std::optional<Vec3> kernel_centre(std::span<const std::array<Vec3, 3>> triangles, const Vec3& start, double reach) {
    constexpr int depth = 3;  // the variable after the coordinates relative to `start`
    CGAL::Quadratic_program<double> program(CGAL::LARGER, false, 0, false, 0);
    for (int k = 0; k <= depth; ++k) program.set_l(k, true, k == depth ? 0 : -reach), program.set_u(k, true, reach);
    program.set_c(depth, -1);
    int row = 0;
    for (const auto& [a, b, c] : triangles) {
        const Vec3 inward = -normalized(cross(b - a, c - a));
        for (int k = 0; k < depth; ++k) program.set_a(k, row, inward[k]);
        program.set_a(depth, row, -1);
        program.set_b(row++, dot(inward, a - start));
    }
    const auto solution = CGAL::solve_linear_program(program, CGAL::Gmpzf());
    if (!solution.is_optimal()) return {};
    auto value = solution.variable_values_begin();
    const double x = CGAL::to_double(*value++), y = CGAL::to_double(*value++), z = CGAL::to_double(*value);
    const Vec3 centre = start + Vec3{x, y, z};
    if (!sees_all(centre, triangles)) return {};
    return centre;
}

}  // namespace featuremesh
