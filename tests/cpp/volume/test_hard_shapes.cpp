// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"
#include "core/tolerances.h"
#include "filled_parts.h"
#include "hard_shapes.h"
#include "volume/curved/mid_side_nodes.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

/// Coarse chords of thin curved walls are off by more than a mesh for analysis would be.
std::string hard_findings(const Brep& brep, const Mesh& mesh) {
    Expectation expected = expectation_of(brep);
    expected.volume_tolerance = 0.3;
    std::string lines = several(broken_invariants(mesh, expected)).in_english();
    int tiny = 0;
    for (const auto& t : mesh.tets)
        tiny += signed_volume(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]), mesh.point(t[3])) <
                1e-12 * std::pow(brep.box().diagonal(), 3);
    if (tiny > 0) lines += std::to_string(tiny) + " tets have no volume to speak of\n";
    return lines;
}

void check_meshed(const HardShape& hard, double size, bool is_curved) {
    INFO(hard.name << ", size " << size);
    try {
        const Part part = prepare(hard.shape, size * hard.scale);
        Mesh mesh = fill(part).mesh;
        CHECK(hard_findings(part.brep, mesh) == "");
        if (!is_curved) return;
        RunContext context;
        mesh = curve_to_second_order(part.brep, std::move(mesh), nullptr, context);
        CHECK(hard_findings(part.brep, mesh) == "");
    } catch (const Error& error) {
        FAIL_CHECK(error.what());
    }
}

struct Variant {
    std::string name;
    double angle;
    Vec3 shift;
    double scale;
};

HardShape varied(const HardShape& hard, const Variant& variant) {
    const TopoDS_Shape shape = variant.scale == 1 ? hard.shape : scaled(hard.shape, variant.scale);
    return {hard.name + ", " + variant.name, turned(shape, variant.angle, variant.shift), hard.scale * variant.scale};
}

}  // namespace

TEST_CASE("hard shapes are meshed coarsely") {
    for (const HardShape& hard : hard_shapes()) check_meshed(hard, 10, hard.name != "plate with 400 holes");
}

TEST_CASE("hard shapes are meshed where they are turned") {
    for (const HardShape& hard : hard_shapes())
        if (hard.name != "plate with 400 holes") check_meshed(varied(hard, {"turned", 0.651, {}, 1}), 4, true);
}

TEST_CASE("hard shapes are meshed at three sizes, turned, far away, small and large, with 4-node and 10-node tets",
          "[.hard]") {
    const std::vector<Variant> variants{{"as built", 0, {}, 1},
                                        {"turned", 0.651, {}, 1},
                                        {"far from the origin", 0.651, {1e5, -1e5, 1e5}, 1},
                                        {"a thousand times smaller", 0.651, {}, 1e-3},
                                        {"a thousand times larger", 0.651, {}, 1e3}};
    constexpr double least_scale = 1e-3;  // smaller parts are refused: the kernel knows no less than 1e-7 mm
    for (const HardShape& hard : hard_shapes())
        for (const Variant& variant : variants)
            for (const double size : {10.0, 4.0, 2.0})
                if (hard.scale * variant.scale >= least_scale) check_meshed(varied(hard, variant), size, true);
}
