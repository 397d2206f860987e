// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/kept_entities.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <algorithm>

#include "catch.h"
#include "part_documents.h"
#include "part_meshes.h"
#include "update/part_mesh.h"

using namespace featuremesh;

namespace {

/// An edit, and all old nodes under one motion of its difference.
class Edit {
  public:
    Edit(const RawDocument& before, const RawDocument& after)
        : old_(mesh_part(before, options(), context_).part_mesh),
          now_(read_part_to_mesh(after, context_, &old_->part)),
          difference_(compare(old_->part, now_, Resolution(0.5), context_)),
          input_{old_->mesh, old_->part.brep, now_.brep, difference_, old_->sizing, old_->sizing, old_->made_for, 1.0} {
    }

    const Mesh& mesh() const { return old_->mesh; }
    const Brep& shape() const { return now_.brep; }
    const FeatureDifference& difference() const { return difference_; }
    CarriedNodes all_under(std::int32_t motion) {
        motions_.assign(mesh().node_count(), motion);
        return {input_, motions_};
    }

  private:
    static MeshOptions options() {
        MeshOptions options;
        options.sizing.size = 3;
        return options;
    }

    RunContext context_;
    std::shared_ptr<const PartMesh> old_;
    PartState now_;
    FeatureDifference difference_;
    KeepInput input_;
    std::vector<std::int32_t> motions_;
};

/// On the cylinder of the hole about x, its ends included.
bool is_at_hole(const Vec3& p, double x) { return std::abs(std::hypot(p.x - x, p.y - 15) - 4) < 1e-6; }

bool is_in_hole(const Vec3& p, double x) { return std::hypot(p.x - x, p.y - 15) < 4 - 1e-6; }

}  // namespace

TEST_CASE("nodes keep their place where the new shape has it, and lose it where a hole went") {
    Edit edit(plate_with_hole(20), plate_with_hole(23));
    const CarriedNodes nodes = edit.all_under(0);
    KeptEntities kept(nodes);
    std::size_t placed = 0;
    for (std::size_t n = 0; n < edit.mesh().node_count(); ++n) {
        const Entity was = edit.mesh().entities[n];
        if (was.dim == 3) continue;
        const Vec3& p = edit.mesh().points[n];
        const bool is_gone = is_at_hole(p, 20) || is_in_hole(p, 23);
        INFO(p.x << " " << p.y << " " << p.z);
        REQUIRE(kept.place(n) == !is_gone);
        if (is_gone) continue;
        ++placed;
        const Entity entity = kept.entities()[n];
        REQUIRE(entity.dim == was.dim);
        if (entity.dim == 0) CHECK(edit.shape().point_of(VertexId(entity.index)) == p);
    }
    CHECK(placed > 100);
}

TEST_CASE("triangles and segments of placed nodes find their face and edge, neither turned round") {
    Edit edit(plate_with_hole(20), plate_with_hole(23));
    const Mesh& mesh = edit.mesh();
    KeptEntities kept(edit.all_under(0));
    std::vector<char> is_placed(mesh.node_count(), 0);
    for (std::size_t n = 0; n < mesh.node_count(); ++n) is_placed[n] = mesh.entities[n].dim < 3 && kept.place(n);
    const auto all_placed = [&](const auto& corners) {
        return std::all_of(corners.begin(), corners.end(), [&](NodeId n) { return is_placed[n.index()] != 0; });
    };
    std::size_t triangles = 0, segments = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!all_placed(mesh.triangles[t])) continue;
        const FaceId face = kept.face_of(t);
        REQUIRE(face.is_valid());
        REQUIRE(edit.difference().regions[0].new_face_of[mesh.triangle_faces[t].index()] == face);
        REQUIRE(kept.cosine_to(face, t) > 0);
        ++triangles;
    }
    for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
        if (!all_placed(mesh.segments[s])) continue;
        const EdgeId edge = kept.edge_of(s);
        REQUIRE(edge.is_valid());
        REQUIRE_FALSE(kept.runs_backwards(s, edge));
        ++segments;
    }
    CHECK(triangles > 100);
    CHECK(segments > 40);
}

TEST_CASE("a node inside a face knows the solid behind it, that nothing is before it, and not what is beside it") {
    Edit edit(plate_with_hole(20), plate_with_hole(23));
    const Mesh& mesh = edit.mesh();
    KeptEntities kept(edit.all_under(0));
    std::vector<char> is_placed(mesh.node_count(), 0);
    for (std::size_t n = 0; n < mesh.node_count(); ++n) is_placed[n] = mesh.entities[n].dim == 2 && kept.place(n);
    std::size_t told = 0;
    for (const auto& tet : mesh.tets)
        for (const NodeId n : tet) {
            if (mesh.entities[n.index()].dim == 3) CHECK_FALSE(kept.solid_beside(n.index(), Vec3{30, 15, 3}));
            if (!is_placed[n.index()]) continue;
            const Vec3 p = mesh.point(n),
                       middle = (mesh.point(tet[0]) + mesh.point(tet[1]) + mesh.point(tet[2]) + mesh.point(tet[3])) / 4;
            const auto behind = kept.solid_beside(n.index(), middle),
                       before = kept.solid_beside(n.index(), 2 * p - middle);
            REQUIRE(behind.has_value() == before.has_value());
            if (!behind) continue;
            ++told;
            CHECK(*behind == SolidId(0));
            CHECK_FALSE(before->is_valid());
        }
    CHECK(told > 1000);
    const auto on_top = std::find_if(mesh.points.begin(), mesh.points.end(), [&](const Vec3& p) {
        const std::size_t n = std::size_t(&p - mesh.points.data());
        return is_placed[n] && p.z > 6 - 1e-9;
    });
    REQUIRE(on_top != mesh.points.end());
    CHECK_FALSE(kept.solid_beside(std::size_t(on_top - mesh.points.begin()), *on_top + Vec3{1, 1, -0.1}));
}

TEST_CASE("under the motion of a hole its nodes are placed on the moved hole") {
    Edit edit(plate_with_hole(20), plate_with_hole(23));
    const auto& regions = edit.difference().regions;
    REQUIRE(regions.size() == 2);
    const CarriedNodes nodes = edit.all_under(1);
    KeptEntities kept(nodes);
    std::size_t placed = 0;
    for (std::size_t n = 0; n < edit.mesh().node_count(); ++n) {
        if (edit.mesh().entities[n].dim == 3 || !is_at_hole(edit.mesh().points[n], 20)) continue;
        REQUIRE(kept.place(n));
        CHECK(is_at_hole(nodes.at(n), 23));
        ++placed;
    }
    CHECK(placed > 20);
}

TEST_CASE("a vertex that comes to touch an edge gets its node, and the rest stays") {
    const auto block = [](double touching_at) {
        PartDocument document;
        document.box("Block", {0, 0, 0}, {40, 30, 10});
        if (touching_at == 0) return document.finish();
        BRepBuilderAPI_MakePolygon corners;  // on the block's side, one of them on the upright edge
        for (const auto& [y, z] : {std::pair{4.6e-7, touching_at}, {3.0, 7.0}, {3.0, 8.0}}) corners.Add({0, y, z});
        corners.Close();
        const TopoDS_Shape wedge =
            BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(corners.Wire()).Face(), gp_Vec(3, 0, 0)).Shape();
        return document.add("Wedge", "Part::Feature", wedge).fuse("Part", "Block", "Wedge").finish();
    };
    const auto old = meshed(block(0), options_of(0.8)).part_mesh;
    for (const double at : {9.998, 9.4, 5.0}) {
        CAPTURE(at);
        const auto [now, report] = updated(*old, block(at), options_of(0.8));
        CHECK(now->part.brep.face_count() == 7);
        CHECK(report.fallbacks.empty());
        CHECK(report.kept_nodes_share > 0.8);
    }
}
