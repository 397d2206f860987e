// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/opposite_walls.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>

#include "catch.h"
#include "volume/filled_parts.h"

using namespace featuremesh;
using namespace featuremesh::testing;

namespace {

TopoDS_Shape hexagonal_prism() {
    BRepBuilderAPI_MakePolygon outline;
    for (int i = 0; i < 6; ++i) outline.Add(gp_Pnt(10 * std::cos(i * M_PI / 3), 10 * std::sin(i * M_PI / 3), 0));
    outline.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 15)).Shape();
}

/// Nodes of a part where a test puts them, each on what the shape has there.
class Nodes {
  public:
    explicit Nodes(const TopoDS_Shape& shape) : brep_(shape), projector_(brep_) {}

    NodeId at(const Vec3& p) { return mesh_.add_node(p, entity_at(p)); }
    bool are_spanned(const std::array<NodeId, 4>& nodes) const {
        return OppositeWalls(brep_, mesh_).are_spanned_by(nodes);
    }

  private:
    Entity entity_at(const Vec3& p) const {
        constexpr double on = 1e-7;
        for (std::size_t e = 0; e < brep_.edge_count(); ++e)
            if (projector_.nearest(EdgeId(e), p).distance < on) return entity_of(EdgeId(e));
        for (std::size_t f = 0; f < brep_.face_count(); ++f) {
            const OnFace nearest = projector_.nearest(FaceId(f), p);
            if (nearest.distance < on && projector_.is_inside_trim(FaceId(f), nearest.uv)) return entity_of(FaceId(f));
        }
        return {3, 0};
    }

    Brep brep_;
    Projector projector_;
    Mesh mesh_;
};

}  // namespace

TEST_CASE("a tet between the two sides of a plate is spanned by opposite walls, whichever corners are on which") {
    Nodes plate(box_part({0, 0, 0}, {10, 8, 1}));
    const NodeId low = plate.at({4, 4, 0}), beside = plate.at({6, 4, 0}), third = plate.at({5, 6, 0}),
                 fourth = plate.at({5, 5, 0}), high = plate.at({5, 3, 1}), above = plate.at({5, 5, 1}),
                 border = plate.at({5, 0, 0}), end = plate.at({0, 4, 0.5}), inside = plate.at({5, 4, 0.5});
    CHECK(plate.are_spanned({low, beside, high, above}));
    CHECK(plate.are_spanned({high, low, above, beside}));
    CHECK(plate.are_spanned({low, beside, third, high}));
    CHECK(plate.are_spanned({high, low, beside, third}));
    CHECK(plate.are_spanned({border, beside, third, high}));  // what is on an edge is on both of its faces
    CHECK_FALSE(plate.are_spanned({low, beside, third, fourth}));
    CHECK_FALSE(plate.are_spanned({low, beside, third, inside}));
    CHECK_FALSE(plate.are_spanned({low, beside, third, end}));  // the end has an edge in common with the side
    CHECK_FALSE(plate.are_spanned({low, beside, high, end}));
    CHECK_FALSE(plate.are_spanned({low, beside, high, NodeId()}));
}

TEST_CASE("walls are opposite if they look away from one another") {
    Nodes prism(hexagonal_prism());
    const double apothem = 10 * std::cos(M_PI / 6);
    const auto on_side = [&](int side, double z) {
        const double angle = M_PI / 6 + side * M_PI / 3;
        return prism.at({apothem * std::cos(angle), apothem * std::sin(angle), z});
    };
    const NodeId first = on_side(0, 5), second = on_side(0, 9);
    CHECK(prism.are_spanned({first, second, on_side(3, 6), on_side(3, 8)}));
    CHECK_FALSE(prism.are_spanned({first, second, on_side(2, 6), on_side(2, 8)}));  // 120 degrees from one another
    CHECK_FALSE(prism.are_spanned({first, second, on_side(1, 6), on_side(1, 8)}));
}

TEST_CASE("two faces that meet in an edge are no opposite walls, however sharp it is") {
    Nodes wedge(wedge_part(20));
    const double slope = std::tan(20 * M_PI / 180);
    CHECK_FALSE(wedge.are_spanned({wedge.at({10, 10, 0}), wedge.at({20, 10, 0}), wedge.at({10, 20, 10 * slope}),
                                   wedge.at({20, 20, 20 * slope})}));
}
