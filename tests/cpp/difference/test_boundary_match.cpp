// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/boundary_match.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "brep/brep.h"
#include "catch.h"
#include "difference/edge_difference.h"
#include "difference/volume_faces.h"

using namespace featuremesh;

namespace {

TopoDS_Shape block() { return BRepPrimAPI_MakeBox(20, 10, 5).Shape(); }

TopoDS_Shape drilled(double radius) {
    return BRepAlgoAPI_Cut(block(), BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(6, 5, -1), gp::DZ()), radius, 7).Shape())
        .Shape();
}

BoundaryMatch matched(const TopoDS_Shape& from, const TopoDS_Shape& to, const RigidMotion& motion = {}) {
    const BoundaryModel old_model{Brep(from)}, new_model{Brep(to)};
    return match_boundaries({old_model, new_model, motion, std::nullopt, {1e-7, {10, 5, 2}, 30}});
}

std::size_t count_unchanged(const BoundaryMatch& match) {
    return std::size_t(std::count_if(match.groups.begin(), match.groups.end(), [](const SurfaceGroup& group) {
        return group.is_unchanged() && !group.old_faces.empty() && !group.new_faces.empty();
    }));
}

}  // namespace

TEST_CASE("the boxes of arcs hold them and reach no further") {
    const gp_Ax2 tilted(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 3), gp_Dir(3, 0, -1));
    for (const gp_Ax2& place : {gp_Ax2(), tilted})
        for (const double turn : {0.3, 1.7, 3.1, 4.4, 6.2}) {
            const BoundaryModel model{Brep(BRepPrimAPI_MakeCylinder(place, 5, 8, turn).Shape())};
            int arcs = 0;
            for (std::size_t e = 0; e < model.edges().size(); ++e) {
                const BoundaryEdge& edge = model.edges()[e];
                if (edge.curve.kind != CurveKind::circle) continue;
                ++arcs;
                Box sampled;
                for (int i = 0; i <= 2000; ++i)
                    sampled.add(
                        point_at(edge.curve, edge.curve.first + (edge.curve.last - edge.curve.first) * i / 2000));
                const Box held = edge.box.grown(1e-12);
                CHECK((held.contains(sampled.low) && held.contains(sampled.high)));
                CHECK(length(edge.box.size() - sampled.size()) < 1e-4);
            }
            CHECK(arcs == 2);
            for (std::size_t f = 0; f < model.faces().size(); ++f)
                for (const SurfacePoint& p : points_in_trim(model.brep().face(FaceId(f))))
                    CHECK(model.faces()[f].box.grown(1e-12).contains(p.point));
        }
}

TEST_CASE("nothing changed between equal boundaries, in place or moved") {
    const BoundaryMatch same = matched(drilled(2), drilled(2));
    CHECK(same.groups.size() == 7);
    CHECK(count_unchanged(same) == 7);

    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(3, -2, 1));
    RigidMotion motion;
    motion.translation = {3, -2, 1};
    CHECK(count_unchanged(matched(block(), BRepBuilderAPI_Transform(block(), shift, true).Shape(), motion)) == 6);
}

TEST_CASE("a hole changes the two faces that it opens and adds its own") {
    const BoundaryMatch match = matched(block(), drilled(2));
    CHECK(match.groups.size() == 7);
    CHECK(count_unchanged(match) == 4);
    int alone = 0;
    for (const SurfaceGroup& group : match.groups) alone += group.old_faces.empty();
    CHECK(alone == 1);
    for (const SurfaceGroup& group : match.groups)
        if (!group.is_unchanged() && !group.old_faces.empty()) {
            REQUIRE_FALSE(group.pieces.empty());
            for (const ChangedPiece& piece : group.pieces) CHECK(piece.is_border);
        }
}

TEST_CASE("a wider hole has both rims and no face in common") {
    const BoundaryMatch match = matched(drilled(2), drilled(2.5));
    CHECK(match.groups.size() == 8);
    CHECK(count_unchanged(match) == 4);
    CHECK(std::count_if(match.groups.begin(), match.groups.end(), [](const SurfaceGroup& group) {
              return group.old_faces.empty() != group.new_faces.empty();
          }) == 2);
}

TEST_CASE("vertices that stay are matched by place") {
    const BoundaryMatch match = matched(block(), drilled(2));
    const Brep before(block()), after(drilled(2));
    REQUIRE(match.new_vertex_of.size() == before.vertex_count());
    for (std::size_t v = 0; v < before.vertex_count(); ++v) {
        REQUIRE(match.new_vertex_of[v].is_valid());
        CHECK(distance(before.point_of(VertexId(v)), after.point_of(match.new_vertex_of[v])) < 1e-9);
    }
}

TEST_CASE("of a ring that is divided elsewhere only the ends have changed") {
    const gp_Circ circle(gp_Ax2(gp_Pnt(10, 5, 2), gp_Dir(1, 2, 3)), 7);
    const auto arc = [&](double from, double to) { return BRepBuilderAPI_MakeEdge(circle, from, to).Edge(); };
    const double turn = 2 * M_PI;
    const Brep was(arc(0, turn), Dimension::edges);
    const Brep is(BRepBuilderAPI_MakeWire(arc(1, 4), arc(4, 1 + turn)).Shape(), Dimension::edges);
    const BoundaryModel old_model{was}, new_model{is};
    for (const auto& [from, to] : {std::pair(&old_model, &new_model), std::pair(&new_model, &old_model)}) {
        const BoundaryPair pair{*from, *to, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}};
        std::vector<SpaceTriangle> changed;
        append_edge_difference(pair, match_boundaries(pair), 0.5, changed);
        CHECK(changed.size() == 3);
        for (const auto& [a, b, c] : changed) CHECK((a == b && b == c));
    }
}
