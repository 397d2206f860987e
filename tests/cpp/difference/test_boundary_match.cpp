// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/boundary_match.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <map>
#include <vector>

#include "brep/brep.h"
#include "catch.h"
#include "difference/edge_difference.h"
#include "difference/partners.h"
#include "difference/place_partners.h"
#include "difference/trim_difference.h"
#include "difference/volume_faces.h"

using namespace featuremesh;

namespace {

TopoDS_Shape block() { return BRepPrimAPI_MakeBox(20, 10, 5).Shape(); }

TopoDS_Shape drilled(double radius) {
    return BRepAlgoAPI_Cut(block(), BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(6, 5, -1), gp::DZ()), radius, 7).Shape())
        .Shape();
}

TopoDS_Face sheet() {
    BRepBuilderAPI_MakePolygon border(gp_Pnt(0, 0, 0), gp_Pnt(20, 0, 0), gp_Pnt(20, 10, 0), gp_Pnt(0, 10, 0), true);
    return BRepBuilderAPI_MakeFace(border.Wire()).Face();
}

ChangedBoundary changed_between(const BoundaryModel& from, const BoundaryModel& to) {
    const BoundaryPair pair{from, to, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}};
    const BoundaryMatch match = match_boundaries(pair);
    std::vector<SpaceTriangle> triangles;
    for (const SurfaceGroup& group : match.groups) append_trim_difference(pair, match, group, 0.3, triangles);
    return ChangedBoundary(std::move(triangles));
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

TEST_CASE("nothing changed where a part lies off by less than the tolerance") {
    gp_Trsf little;
    little.SetTranslation(gp_Vec(6e-8, -5e-8, 5e-8));
    const BoundaryMatch match = matched(drilled(2), BRepBuilderAPI_Transform(drilled(2), little, true).Shape());
    CHECK(match.groups.size() == 7);
    CHECK(count_unchanged(match) == 7);
    for (const VertexId v : match.new_vertex_of) CHECK(v.is_valid());
}

TEST_CASE("a circle that begins a little before another one is no other border") {
    const auto cylinder = [](double x, double turn) {
        const gp_Ax2 place(gp_Pnt(x, 5, 0), gp::DZ(), gp_Dir(std::cos(turn), std::sin(turn), 0));
        return BRepPrimAPI_MakeCylinder(place, 2, 8).Shape();
    };
    const auto with_two = [&](double x, double turn) {
        return BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(block(), cylinder(4, turn)).Shape(), cylinder(x, 0)).Shape();
    };
    for (const double turn : {-1e-8, 1e-8}) {
        const Brep was(with_two(14, 0)), is(with_two(16, turn));
        std::size_t kept = 0;
        for (const FaceChange& change : faces_in_place(was, is, {})) {
            if (!change.old_face.is_valid() || was.box_of(change.old_face).low.z < 7) continue;
            kept += change.verdict == BoundaryVerdict::kept;
        }
        CHECK(kept == 1);
    }
}

TEST_CASE("where a border goes on as a line between two faces, the border alone is one of what changed") {
    const TopoDS_Shape beside = BRepPrimAPI_MakeBox(gp_Pnt(0, 10, 0), 8, 10, 5).Shape();
    const BoundaryMatch match =
        matched(BRepAlgoAPI_Fuse(block(), beside).Shape(), BRepPrimAPI_MakeBox(20, 20, 5).Shape());
    std::array<double, 2> lengths{};  // on the line y = 10, z = 5: of lines inside, of borders
    for (const SurfaceGroup& group : match.groups)
        for (const ChangedPiece& piece : group.pieces) {
            const UnderlyingCurve& curve = match.curves[std::size_t(piece.curve)];
            const Vec3 p = point_at(curve, piece.first), q = point_at(curve, piece.last);
            const bool is_on_top = group.new_faces.size() == 1 && group.old_faces.size() == 2;
            if (is_on_top && p.y == Approx(10) && q.y == Approx(10) && p.z == Approx(5) && q.z == Approx(5))
                lengths[piece.is_border] += distance(p, q);
        }
    CHECK(lengths[0] == Approx(8));
    CHECK(lengths[1] == Approx(12));
}

TEST_CASE("a vertex that came to a line, or into a face, has changed, and nothing else") {
    BRepBuilderAPI_MakePolygon divided(gp_Pnt(0, 0, 0), gp_Pnt(7, 0, 0), gp_Pnt(20, 0, 0), gp_Pnt(20, 10, 0));
    divided.Add(gp_Pnt(0, 10, 0));
    divided.Close();
    TopoDS_Face pointed = sheet();
    BRep_Builder().Add(pointed, BRepBuilderAPI_MakeVertex(gp_Pnt(7, 0, 0)).Vertex().Oriented(TopAbs_INTERNAL));
    const BoundaryModel plain{Brep(sheet(), Dimension::faces)};
    for (const TopoDS_Face& face : {BRepBuilderAPI_MakeFace(divided.Wire()).Face(), pointed}) {
        const BoundaryModel other{Brep(face, Dimension::faces)};
        for (const auto& [from, to] : {std::pair(&plain, &other), std::pair(&other, &plain)}) {
            const BoundaryMatch match = match_boundaries({*from, *to, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}});
            REQUIRE(match.groups.size() == 1);
            CHECK(match.groups[0].pieces.empty());
            REQUIRE(match.groups[0].points.size() == 1);
            CHECK(distance(match.groups[0].points[0], {7, 0, 0}) < 1e-9);
            const ChangedBoundary changed = changed_between(*from, *to);
            CHECK(changed.is_within(0.1, {7, 0, 0}));
            CHECK_FALSE(changed.is_within(0.5, {8, 0, 0}));
        }
    }
}

TEST_CASE("a curve that is made of other poles is the same where its path is, whichever end is the first") {
    const Handle(Geom_BSplineCurve) curve = [] {
        const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 5);
        points->SetValue(1, gp_Pnt(0, 0, 0)), points->SetValue(2, gp_Pnt(4, 5, 1)),
            points->SetValue(3, gp_Pnt(9, 6, 0));
        points->SetValue(4, gp_Pnt(14, 2, 2)), points->SetValue(5, gp_Pnt(20, 1, 0));
        GeomAPI_Interpolate interpolate(points, false, 1e-9);
        interpolate.Perform();
        return interpolate.Curve();
    }();
    const auto curves_of = [&](const Handle(Geom_BSplineCurve) & other) {
        const BoundaryModel old_model{Brep(BRepBuilderAPI_MakeEdge(curve).Edge(), Dimension::edges)},
            new_model{Brep(BRepBuilderAPI_MakeEdge(other).Edge(), Dimension::edges)};
        const BoundaryMatch match = match_boundaries({old_model, new_model, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}});
        return std::array{match.old_edges[0], match.new_edges[0]};
    };
    const Handle(Geom_BSplineCurve) elevated = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
    elevated->IncreaseDegree(5);
    const Handle(Geom_BSplineCurve) reversed = Handle(Geom_BSplineCurve)::DownCast(elevated->Reversed());
    const Handle(Geom_BSplineCurve) bulged = Handle(Geom_BSplineCurve)::DownCast(elevated->Copy());
    bulged->SetPole(4, bulged->Pole(4).Translated(gp_Vec(0, 0, 1e-3)));
    for (const auto& [other, is_along] : {std::pair(elevated, true), std::pair(reversed, false)}) {
        const auto [was, is] = curves_of(other);
        CHECK(was.curve == is.curve);
        CHECK(was.along);
        CHECK(is.along == is_along);
    }
    const auto [was, is] = curves_of(bulged);
    CHECK(was.curve != is.curve);
    // as far as the tolerances of both edges say
    gp_Trsf little;
    little.SetTranslation(gp_Vec(4e-6, 2e-6, 2e-6));
    const auto are_one = [&](double tolerance) {
        TopoDS_Edge one = BRepBuilderAPI_MakeEdge(curve).Edge(),
                    other = BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)::DownCast(elevated->Transformed(little))).Edge();
        for (const TopoDS_Edge& edge : {one, other}) BRep_Builder().UpdateEdge(edge, tolerance);
        const BoundaryModel one_model{Brep(one, Dimension::edges)}, other_model{Brep(other, Dimension::edges)};
        const BoundaryMatch found =
            match_boundaries({one_model, other_model, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}});
        return found.old_edges[0].curve == found.new_edges[0].curve;
    };
    CHECK(are_one(1e-5));
    CHECK_FALSE(are_one(1e-6));
    // two edges of one state in the same place, as of solids that touch
    TopoDS_Compound both;
    BRep_Builder().MakeCompound(both);
    for (const auto& one : {curve, elevated}) BRep_Builder().Add(both, BRepBuilderAPI_MakeEdge(one).Edge());
    const BoundaryModel old_model{Brep(both, Dimension::edges)},
        new_model{Brep(BRepBuilderAPI_MakeEdge(reversed).Edge(), Dimension::edges)};
    const BoundaryMatch match = match_boundaries({old_model, new_model, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}});
    CHECK(match.old_edges[0].curve == match.new_edges[0].curve);
    CHECK(match.old_edges[1].curve == match.new_edges[0].curve);
    // edges one after the other on it
    const auto halves_of = [&](const Handle(Geom_Curve) & whole) {
        const double first = curve->FirstParameter(), last = curve->LastParameter(), middle = 0.4 * first + 0.6 * last;
        TopoDS_Compound halves;
        BRep_Builder().MakeCompound(halves);
        for (const auto& [from, to] : {std::pair(first, middle), std::pair(middle, last)})
            BRep_Builder().Add(halves, BRepBuilderAPI_MakeEdge(whole, from, to).Edge());
        return BoundaryModel{Brep(halves, Dimension::edges)};
    };
    const BoundaryModel old_halves = halves_of(curve), new_halves = halves_of(elevated);
    const BoundaryMatch of_halves =
        match_boundaries({old_halves, new_halves, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}});
    for (const std::size_t half : {0, 1}) {
        const Stretch &was_half = of_halves.old_edges[half], &is_half = of_halves.new_edges[half];
        CHECK(was_half.curve == is_half.curve);
        CHECK(was_half.first == is_half.first);
        CHECK(was_half.last == is_half.last);
    }
}

TEST_CASE("of two pieces of a face or an edge the larger one is its partner, whichever comes first") {
    for (const double x : {4.0, 15.0}) {
        const TopoDS_Shape slot = BRepPrimAPI_MakeBox(gp_Pnt(x, -1, 3), 1, 12, 3).Shape();
        const Brep was(block()), is(BRepAlgoAPI_Cut(block(), slot).Shape());
        const BoundaryModel old_model{was}, new_model{is};
        const BoundaryPair pair{old_model, new_model, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}};
        CarriedRegion region;
        find_partners(pair, match_boundaries(pair), region);
        const auto is_larger = [&](const Box& box) { return box.size().x > 10; };
        std::size_t divided = 0;
        for (std::size_t f = 0; f < was.face_count(); ++f) {
            if (region.new_faces_of[f].size() != 2) continue;
            ++divided;
            CHECK(is_larger(is.box_of(region.new_face_of[f])));
        }
        CHECK(divided == 1);
        for (std::size_t e = 0; e < was.edge_count(); ++e) {
            if (region.new_edges_of[e].size() != 2) continue;
            ++divided;
            CHECK(is_larger(new_model.edges()[region.new_edge_of[e].index()].box));
        }
        CHECK(divided == 3);
    }
}

TEST_CASE("where solids lie on one another, partners are of the same solid, however little of it is left") {
    const auto stack = [](const std::vector<std::array<double, 2>>& heights) {
        TopoDS_Compound solids;
        BRep_Builder().MakeCompound(solids);
        for (const auto& [low, high] : heights)
            BRep_Builder().Add(solids, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, low), 2, 2, high - low).Shape());
        return Brep(solids);
    };
    // the second solid takes what the first one had, or a new one does
    for (const auto& heights : {std::vector<std::array<double, 2>>{{0, 1}, {1, 10}}, {{0, 1}, {5, 10}, {1, 5}}}) {
        const Brep was = stack({{0, 5}, {5, 10}}), is = stack(heights);
        const BoundaryModel old_model{was}, new_model{is};
        const BoundaryPair pair{old_model, new_model, {}, std::nullopt, {1e-7, {1, 1, 5}, 12}};
        CarriedRegion region;
        find_partners(pair, match_boundaries(pair), region);
        const auto solid_of = [](const Brep& brep, FaceId face) { return brep.solids_beside(face)[0]; };
        const auto is_upright = [](const Box& box) { return box.size().z > 0.5; };
        for (std::size_t f = 0; f < was.face_count(); ++f)
            if (is_upright(was.box_of(FaceId(f))))
                CHECK(solid_of(is, region.new_face_of[f]) == solid_of(was, FaceId(f)));
        for (std::size_t e = 0; e < was.edge_count(); ++e) {
            if (!is_upright(old_model.edges()[e].box)) continue;
            const SolidId own = solid_of(was, was.faces_of(EdgeId(e))[0]);
            CHECK(solid_of(is, is.faces_of(region.new_edge_of[e])[0]) == own);
            for (const EdgeId now : region.new_edges_of[e]) {
                const SolidId of_piece = solid_of(is, is.faces_of(now)[0]);
                CHECK((of_piece == own || of_piece == SolidId(2)));
            }
        }
    }
}

TEST_CASE("solids are told by their faces, not by their order, and faces one in the other are partners") {
    const auto both = [](const TopoDS_Shape& one, const TopoDS_Shape& other) {
        TopoDS_Compound solids;
        BRep_Builder().MakeCompound(solids);
        for (const TopoDS_Shape& solid : {one, other}) BRep_Builder().Add(solids, solid);
        return Brep(solids);
    };
    const TopoDS_Shape on_top = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 5), 20, 10, 2).Shape();
    const Brep was = both(block(), on_top), is = both(on_top, block());
    for (const FaceChange& change : faces_in_place(was, is, {})) {
        CHECK(change.verdict == BoundaryVerdict::kept);
        CHECK(is.solids_beside(change.new_face)[0] != was.solids_beside(change.old_face)[0]);
    }
    const Brep small(block()), wide(BRepPrimAPI_MakeBox(gp_Pnt(-3, -4, 0), gp_Pnt(25, 15, 5)).Shape());
    for (const auto& [from, to] : {std::pair(&small, &wide), std::pair(&wide, &small)}) {
        const auto changes = faces_in_place(*from, *to, {});
        CHECK(std::count_if(changes.begin(), changes.end(), [](const FaceChange& change) {
                  return change.verdict == BoundaryVerdict::trimmed_differently;
              }) == 2);
    }
}

TEST_CASE(
    "all of a cone up to its tip has changed where it came, and all of a ball where it touches with little of it") {
    const BoundaryModel plain{Brep(block())};
    for (const bool is_upright : {true, false}) {  // whichever way its parameter runs from the tip
        const gp_Ax2 up(gp_Pnt(6, 5, 5), gp::DZ()), down(gp_Pnt(6, 5, 9), gp::DZ().Reversed());
        const TopoDS_Shape cone =
            is_upright ? BRepPrimAPI_MakeCone(up, 3, 0, 4).Shape() : BRepPrimAPI_MakeCone(down, 0, 3, 4).Shape();
        const BoundaryModel with_cone{Brep(BRepAlgoAPI_Fuse(block(), cone).Shape())};
        for (const auto& [from, to] : {std::pair(&plain, &with_cone), std::pair(&with_cone, &plain)}) {
            const ChangedBoundary changed = changed_between(*from, *to);
            for (const Vec3& p : {Vec3{6, 5, 8.9}, {6 + 1.5, 5, 7}, {6, 5 - 1.5, 7}, {6 - 0.75, 5, 8}})
                CHECK(changed.is_within(0.1, p));
        }
    }
    for (const double turn : {0.0, 2.0, 4.0}) {  // wherever the ball's seam is
        const gp_Ax2 place(gp_Pnt(22, 5, 2), gp::DZ(), gp_Dir(std::cos(turn), std::sin(turn), 0));
        const BoundaryModel with_ball{
            Brep(BRepAlgoAPI_Fuse(block(), BRepPrimAPI_MakeSphere(place, 2.4).Shape()).Shape())};
        for (const auto& [from, to] : {std::pair(&plain, &with_ball), std::pair(&with_ball, &plain)}) {
            const ChangedBoundary changed = changed_between(*from, *to);
            for (const Vec3& way : {Vec3{1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0.6, 0, 0.8}, {0.6, 0.64, -0.48}})
                CHECK(changed.is_within(0.1, Vec3{22, 5, 2} + 2.4 * way));
        }
    }
}

TEST_CASE("round a cylinder all has changed that is cut off it, over its seam, too") {
    const gp_Ax2 up(gp_Pnt(10, 5, 0), gp::DZ()),
        from_sector(gp_Pnt(10, 5, 3), gp::DZ(), gp_Dir(std::cos(1.3), std::sin(1.3), 0));
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(up, 4, 6).Shape(),
                       all_but_sector = BRepPrimAPI_MakeCylinder(from_sector, 7, 5, 5.8).Shape();
    const BoundaryModel whole{Brep(cylinder)}, cut{Brep(BRepAlgoAPI_Cut(cylinder, all_but_sector).Shape())};
    for (const auto& [from, to] : {std::pair(&whole, &cut), std::pair(&cut, &whole)}) {
        const ChangedBoundary changed = changed_between(*from, *to);
        for (double turn = 0.1; turn < 2 * M_PI; turn += 0.2) {
            const bool is_in_sector = turn > 1.3 - (2 * M_PI - 5.8) && turn < 1.3;
            const Vec3 p{10 + 4 * std::cos(turn), 5 + 4 * std::sin(turn), 4.5};
            INFO(turn);
            if (!is_in_sector) CHECK(changed.is_within(0.1, p));
        }
        CHECK_FALSE(changed.is_within(0.3, {10 + 4 * std::cos(1.06), 5 + 4 * std::sin(1.06), 4.5}));
    }
}

TEST_CASE("arcs of one circle are partners where they overlap, also beyond its seam") {
    const gp_Circ circle(gp_Ax2(gp_Pnt(10, 5, 2), gp_Dir(1, 2, 3)), 7);
    const auto arc = [&](double from, double to) {
        return Brep(BRepBuilderAPI_MakeEdge(circle, from, to).Edge(), Dimension::edges);
    };
    const Brep over_seam = arc(6, 6.6), after = arc(0.1, 1), apart = arc(0.4, 1);
    const auto are_partners = [](const Brep& was, const Brep& is) {
        const BoundaryModel old_model{was}, new_model{is};
        const BoundaryPair pair{old_model, new_model, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}};
        CarriedRegion region;
        find_partners(pair, match_boundaries(pair), region);
        return region.new_edge_of[0].is_valid();
    };
    CHECK(are_partners(over_seam, after));
    CHECK(are_partners(after, over_seam));
    CHECK_FALSE(are_partners(over_seam, apart));
    CHECK_FALSE(are_partners(apart, over_seam));
}

TEST_CASE("of solids in one place each face is kept as that of its own solid") {
    TopoDS_Compound both;
    BRep_Builder().MakeCompound(both);
    for (int i = 0; i < 2; ++i) BRep_Builder().Add(both, block());
    const Brep twice(both);
    REQUIRE(twice.face_count() == 12);
    for (const FaceChange& change : faces_in_place(twice, twice, {})) {
        CHECK(change.verdict == BoundaryVerdict::kept);
        CHECK(change.new_face == change.old_face);
        CHECK(change.new_faces == std::vector<FaceId>{change.old_face});
    }
}

TEST_CASE(
    "of a solid that comes to overlap another one, flush with it, all faces appeared, and those of the other stay") {
    const TopoDS_Shape flush = BRepPrimAPI_MakeBox(gp_Pnt(5, 3, -4), gp_Pnt(30, 7, 5)).Shape();
    TopoDS_Compound both;
    BRep_Builder().MakeCompound(both);
    for (const TopoDS_Shape& solid : {block(), flush}) BRep_Builder().Add(both, solid);
    const Brep alone(block()), together(both);
    for (const bool is_coming : {true, false}) {
        std::map<BoundaryVerdict, int> count;
        for (const FaceChange& change :
             is_coming ? faces_in_place(alone, together, {}) : faces_in_place(together, alone, {}))
            ++count[change.verdict];
        CHECK(count[BoundaryVerdict::kept] == 6);
        CHECK(count[is_coming ? BoundaryVerdict::appeared : BoundaryVerdict::vanished] == 6);
    }
}

TEST_CASE("a line drawn into a face has changed, but is no border") {
    TopoDS_Face drawn = sheet();
    const TopoDS_Wire line = BRepBuilderAPI_MakePolygon(gp_Pnt(5, 5, 0), gp_Pnt(15, 5, 0)).Wire();
    BRep_Builder().Add(drawn, line.Oriented(TopAbs_INTERNAL));
    const BoundaryModel old_model{Brep(sheet(), Dimension::faces)}, new_model{Brep(drawn, Dimension::faces)};
    const BoundaryMatch match = match_boundaries({old_model, new_model, {}, std::nullopt, {1e-7, {10, 5, 2}, 30}});
    REQUIRE(match.groups.size() == 1);
    REQUIRE(match.groups[0].pieces.size() == 1);
    CHECK_FALSE(match.groups[0].pieces[0].is_border);
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
