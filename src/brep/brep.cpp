// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/brep.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "brep/occt_geometry.h"
#include "brep/vertex_places.h"
#include "brep/volumes/flux.h"
#include "core/errors.h"
#include "core/messages.h"
#include "core/sort_once.h"

namespace featuremesh {

struct Brep::Data {
    TopoDS_Shape shape;
    TopTools_IndexedMapOfShape solids, faces, edges, vertices;  // orientation ignored, numbers as FreeCAD's
    std::vector<TopoDS_Solid> solid;
    std::vector<TopoDS_Face> face;
    std::vector<TopoDS_Edge> edge;
    std::vector<TopoDS_Vertex> vertex;
    std::vector<std::vector<EdgeId>> edges_of_face, edges_of_vertex;
    std::vector<std::vector<FaceEdge>> uses_in_face;
    std::vector<std::vector<VertexId>> vertices_inside;
    std::multimap<VertexId, FaceId> face_around;  ///< of each vertex inside one
    std::vector<std::vector<FaceId>> faces_of_edge;
    std::vector<std::array<VertexId, 2>> ends;
    std::vector<std::array<SolidId, 2>> solids_beside;
    std::vector<BodyId> sheets;  ///< by face, of those that are free
    std::size_t body_count = 0;
    std::vector<char> is_free_face, is_free_edge;
    Dimension dimension = Dimension::solids;
    std::vector<double> volumes;
    std::vector<Box> box_of_face, box_of_edge;
    std::vector<Vec3> points;
    std::vector<char> is_degenerated;
    Box box;

    bool is_seam(EdgeId e, FaceId f) const { return BRepTools::IsReallyClosed(edge[e.index()], face[f.index()]); }
};

namespace {

/// Numbers what is met first on the way through the shape and all within it, each kind by itself: as TopExp does.
template <class MapOf>
void number_all(const TopoDS_Shape& shape, const MapOf& map_of) {
    if (TopTools_IndexedMapOfShape* map = map_of(shape.ShapeType())) {
        const int before = map->Extent();
        map->Add(shape);
        if (map->Extent() == before) return;  // and so is all within it
    }
    for (TopoDS_Iterator child(shape); child.More(); child.Next()) number_all(child.Value(), map_of);
}

template <class Shape, class Cast>
std::vector<Shape> listed(const TopTools_IndexedMapOfShape& map, Cast cast) {
    std::vector<Shape> list;
    for (int i = 1; i <= map.Extent(); ++i) list.push_back(cast(map(i)));
    return list;
}

template <class Kind>
Id<Kind> id_in(const TopTools_IndexedMapOfShape& map, const TopoDS_Shape& shape) {
    return Id<Kind>(static_cast<std::int32_t>(map.FindIndex(shape) - 1));
}

template <class T>
void add_once(std::vector<T>& list, T item) {
    if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

/// A plane or cylinder between lines and conics.
bool is_elementary(const TopoDS_Face& face) {
    if (BRepAdaptor_Surface(face, false).GetType() > GeomAbs_Cylinder) return false;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        if (!BRep_Tool::Degenerated(edge) && BRepAdaptor_Curve(edge).GetType() > GeomAbs_Parabola) return false;
    }
    return true;
}

/// Does what holds its edges hold all of it?
bool is_within_edges(const TopoDS_Face& face) {
    return BRepAdaptor_Surface(face, false).GetType() == GeomAbs_Plane && TopExp_Explorer(face, TopAbs_EDGE).More();
}

/// Tight but for free-form faces and edges, where the kernel would search for the extremes for seconds: there it holds
/// the bounds of the face.
Box tight_box_of(const std::vector<TopoDS_Face>& faces, const std::vector<Bnd_Box>& bounds_of_face) {
    Bnd_Box bounds;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (is_elementary(faces[f]))
            BRepBndLib::AddOptimal(faces[f], bounds, false, false);
        else
            bounds.Add(bounds_of_face[f]);
    }
    return to_box(bounds);
}

Box box_of_all(const std::vector<Box>& boxes) {
    Box all;
    for (const Box& box : boxes) all.add(box);
    return all;
}

/// By free face the sheet that it belongs to: all that are joined by edges, in the order of their first faces, from
/// `next` on, which comes to be the first number without a sheet.
std::vector<BodyId> sheets_of(const std::vector<std::vector<EdgeId>>& edges_of_face,
                              const std::vector<std::vector<FaceId>>& faces_of_edge, const std::vector<char>& is_free,
                              BodyId& next) {
    std::vector<BodyId> sheets(edges_of_face.size());
    for (std::size_t first = 0; first < sheets.size(); ++first) {
        if (!is_free[first] || sheets[first].is_valid()) continue;
        std::vector<FaceId> open{FaceId(first)};
        sheets[first] = next;
        while (!open.empty()) {
            const FaceId face = open.back();
            open.pop_back();
            for (const EdgeId edge : edges_of_face[face.index()])
                for (const FaceId other : faces_of_edge[edge.index()])
                    if (is_free[other.index()] && !std::exchange(sheets[other.index()], next).is_valid())
                        open.push_back(other);
        }
        ++next.value;
    }
    return sheets;
}

/// Faces without a solid and edges without a meshed face, as far as they are meshed. `takes_lower`: those of a lower
/// dimension than the part's, too; but none of a solid, which may have some drawn into it.
void find_free(auto& data, bool takes_lower) {
    const bool has_solids = data.dimension == Dimension::solids, has_edges = data.dimension == Dimension::edges;
    std::vector<char> is_of_solid_face(data.face.size(), 0), is_of_solid_edge(data.edge.size(), 0);
    for (const TopoDS_Solid& solid : data.solid) {
        for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
            is_of_solid_face[id_in<FaceKind>(data.faces, it.Current()).index()] = 1;
        for (TopExp_Explorer it(solid, TopAbs_EDGE); it.More(); it.Next())
            is_of_solid_edge[id_in<EdgeKind>(data.edges, it.Current()).index()] = 1;
    }
    for (std::size_t f = 0; f < data.face.size(); ++f)
        data.is_free_face.push_back(has_solids ? takes_lower && !is_of_solid_face[f] : !has_edges);
    for (std::size_t e = 0; e < data.edge.size(); ++e) {
        const auto& faces = data.faces_of_edge[e];
        const bool is_seam = faces.size() == 1 && data.is_seam(EdgeId(e), faces[0]);
        data.is_free_edge.push_back(has_edges ? !is_seam && !data.is_degenerated[e]
                                              : takes_lower && faces.empty() && !is_of_solid_edge[e]);
    }
    BodyId next(data.solid.size());
    data.sheets = sheets_of(data.edges_of_face, data.faces_of_edge, data.is_free_face, next);
    data.body_count = next.index();
}

/// Faces with their edges, and with their bounds.
void take_faces(auto& data, const std::vector<Bnd_Box>& bounds_of_edge, std::vector<Bnd_Box>& bounds_of_face) {
    for (std::size_t f = 0; f < data.face.size(); ++f) {
        for (TopExp_Explorer it(data.face[f], TopAbs_EDGE); it.More(); it.Next()) {
            const auto edge = id_in<EdgeKind>(data.edges, it.Current());
            const TopAbs_Orientation orientation = it.Current().Orientation();
            data.uses_in_face[f].push_back(
                {edge, orientation == TopAbs_FORWARD, orientation == TopAbs_INTERNAL, orientation == TopAbs_EXTERNAL});
            if (auto& faces = data.faces_of_edge[edge.index()]; faces.empty() || faces.back() != FaceId(f)) {
                faces.emplace_back(f);
                data.edges_of_face[f].push_back(edge);
            }
        }
        if (is_within_edges(data.face[f]))
            for (const EdgeId e : data.edges_of_face[f]) bounds_of_face[f].Add(bounds_of_edge[e.index()]);
        else
            add_bounds(data.face[f], bounds_of_face[f]);
        data.box_of_face.push_back(to_box(bounds_of_face[f]));
    }
}

/// Its sides of the faces, and its volume. Refuses one that is open, or inside out.
void take_solid(auto& data, SolidId solid) {
    std::map<EdgeId, int> uses;
    double volume = 0;
    for (TopExp_Explorer it(data.solid[solid.index()], TopAbs_FACE); it.More(); it.Next()) {
        const TopAbs_Orientation orientation = it.Current().Orientation();
        if (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED) continue;  // drawn in, bounds nothing
        const auto face = id_in<FaceKind>(data.faces, it.Current());
        const bool behind = orientation == data.face[face.index()].Orientation();
        data.solids_beside[face.index()][behind ? 0 : 1] = solid;
        // An edge within a face (where another feature is tangent to it) is no border and needs no second face.
        for (const FaceEdge& use : data.uses_in_face[face.index()]) uses[use.edge] += use.is_internal ? 2 : 1;
        volume += flux(TopoDS::Face(it.Current()), data.box.center(), data.box_of_face[face.index()].diagonal());
    }
    for (const auto& [edge, count] : uses)
        if (count == 1 && !data.is_degenerated[edge.index()]) throw InputError(say<Code::open_shell>(solid, edge));
    data.volumes.push_back(volume);
    if (!(volume > 0)) throw InputError(say<Code::no_positive_volume>(solid));
}

void refuse_empty(Dimension dimension, std::size_t solids, std::size_t faces, std::size_t edges) {
    if (dimension == Dimension::solids && solids == 0) throw InputError(say<Code::no_solid>());
    if (dimension == Dimension::faces && faces == 0) throw InputError(say<Code::no_face>());
    if (dimension == Dimension::edges && edges == 0) throw InputError(say<Code::no_edge>());
}

}  // namespace

Dimension dimension_of(const TopoDS_Shape& shape) {
    const auto has = [&](TopAbs_ShapeEnum kind) { return TopExp_Explorer(shape, kind).More(); };
    return has(TopAbs_SOLID)  ? Dimension::solids
           : has(TopAbs_FACE) ? Dimension::faces
           : has(TopAbs_EDGE) ? Dimension::edges
                              : Dimension::solids;
}

Brep::Brep(const TopoDS_Shape& shape, Dimension dimension) {
    if (shape.IsNull()) throw InputError(say<Code::empty_shape>());
    auto data = std::make_shared<Data>();
    data->dimension = dimension == Dimension::from_shape ? dimension_of(shape) : dimension;
    data->shape = shape;
    number_all(shape, [&](TopAbs_ShapeEnum kind) {
        return kind == TopAbs_SOLID    ? &data->solids
               : kind == TopAbs_FACE   ? &data->faces
               : kind == TopAbs_EDGE   ? &data->edges
               : kind == TopAbs_VERTEX ? &data->vertices
                                       : nullptr;
    });
    data->solid = listed<TopoDS_Solid>(data->solids, [](auto& s) { return TopoDS::Solid(s); });
    data->face = listed<TopoDS_Face>(data->faces, [](auto& s) { return TopoDS::Face(s); });
    data->edge = listed<TopoDS_Edge>(data->edges, [](auto& s) { return TopoDS::Edge(s.Oriented(TopAbs_FORWARD)); });
    data->vertex = listed<TopoDS_Vertex>(data->vertices, [](auto& s) { return TopoDS::Vertex(s); });
    if (data->dimension != Dimension::solids) data->solid.clear();
    refuse_empty(data->dimension, data->solid.size(), data->face.size(), data->edge.size());

    data->edges_of_face.resize(data->face.size());
    data->uses_in_face.resize(data->face.size());
    data->faces_of_edge.resize(data->edge.size());
    data->edges_of_vertex.resize(data->vertex.size());
    data->solids_beside.resize(data->face.size());
    std::vector<Bnd_Box> bounds_of_face(data->face.size()), bounds_of_edge(data->edge.size());
    for (std::size_t e = 0; e < data->edge.size(); ++e) {
        if (!BRep_Tool::IsGeometric(data->edge[e])) throw InputError(say<Code::edge_without_curve>(EdgeId(e)));
        data->is_degenerated.push_back(BRep_Tool::Degenerated(data->edge[e]));
        if (!data->is_degenerated[e]) add_bounds(data->edge[e], bounds_of_edge[e]);
        data->box_of_edge.push_back(to_box(bounds_of_edge[e]));
    }
    take_faces(*data, bounds_of_edge, bounds_of_face);
    for (std::size_t e = 0; e < data->edge.size(); ++e) {
        TopoDS_Vertex first, last;
        TopExp::Vertices(data->edge[e], first, last);
        data->ends.push_back({id_in<VertexKind>(data->vertices, first), id_in<VertexKind>(data->vertices, last)});
        for (const VertexId end : data->ends.back())
            if (end.is_valid()) add_once(data->edges_of_vertex[end.index()], EdgeId(e));
    }
    data->vertices_inside.resize(data->face.size());
    for (std::size_t f = 0; f < data->face.size(); ++f) {
        for (TopoDS_Iterator it(data->face[f]); it.More(); it.Next())
            if (it.Value().ShapeType() == TopAbs_VERTEX)
                add_once(data->vertices_inside[f], id_in<VertexKind>(data->vertices, it.Value()));
        for (const VertexId v : data->vertices_inside[f]) data->face_around.emplace(v, f);
    }
    data->points = vertex_places(data->vertex, data->edge, data->ends, data->face, data->faces_of_edge);
    data->box = data->face.empty() ? box_of_all(data->box_of_edge) : tight_box_of(data->face, bounds_of_face);
    if (dimension == Dimension::from_shape)
        for (std::size_t e = 0; e < data->edge.size(); ++e)
            if (data->faces_of_edge[e].empty()) data->box.add(data->box_of_edge[e]);
    for (std::size_t s = 0; s < data->solid.size(); ++s) take_solid(*data, SolidId(s));
    find_free(*data, dimension == Dimension::from_shape);
    data_ = std::move(data);
    if (data_->dimension == Dimension::edges && !has_free_edges()) throw InputError(say<Code::no_edge>());
}

Dimension Brep::dimension() const { return data_->dimension; }
const TopoDS_Shape& Brep::shape() const { return data_->shape; }
std::size_t Brep::solid_count() const { return data_->solid.size(); }
std::size_t Brep::face_count() const { return data_->face.size(); }
std::size_t Brep::edge_count() const { return data_->edge.size(); }
std::size_t Brep::vertex_count() const { return data_->vertex.size(); }
const TopoDS_Solid& Brep::solid(SolidId id) const { return data_->solid[id.index()]; }
const TopoDS_Face& Brep::face(FaceId id) const { return data_->face[id.index()]; }
const TopoDS_Edge& Brep::edge(EdgeId id) const { return data_->edge[id.index()]; }
const TopoDS_Vertex& Brep::vertex(VertexId id) const { return data_->vertex[id.index()]; }
FaceId Brep::find(const TopoDS_Face& face) const { return id_in<FaceKind>(data_->faces, face); }
EdgeId Brep::find(const TopoDS_Edge& edge) const { return id_in<EdgeKind>(data_->edges, edge); }
VertexId Brep::find(const TopoDS_Vertex& vertex) const { return id_in<VertexKind>(data_->vertices, vertex); }
std::span<const EdgeId> Brep::edges_of(FaceId face) const { return data_->edges_of_face[face.index()]; }
std::span<const FaceEdge> Brep::uses_in(FaceId face) const { return data_->uses_in_face[face.index()]; }
std::span<const FaceId> Brep::faces_of(EdgeId edge) const { return data_->faces_of_edge[edge.index()]; }
std::span<const EdgeId> Brep::edges_of(VertexId vertex) const { return data_->edges_of_vertex[vertex.index()]; }
std::span<const VertexId> Brep::vertices_inside(FaceId face) const { return data_->vertices_inside[face.index()]; }
std::array<VertexId, 2> Brep::ends_of(EdgeId edge) const { return data_->ends[edge.index()]; }
std::array<SolidId, 2> Brep::solids_beside(FaceId face) const { return data_->solids_beside[face.index()]; }
const std::vector<std::array<SolidId, 2>>& Brep::solids_beside_faces() const { return data_->solids_beside; }
std::array<BodyId, 2> Brep::bodies_of(FaceId face) const {
    if (is_free(face)) return {data_->sheets[face.index()], BodyId()};
    const auto [behind, before] = solids_beside(face);
    return {BodyId(behind.value), BodyId(before.value)};
}
std::size_t Brep::body_count() const { return data_->body_count; }
bool Brep::is_free(FaceId face) const { return data_->is_free_face[face.index()] != 0; }
bool Brep::is_free(EdgeId edge) const { return data_->is_free_edge[edge.index()] != 0; }
bool Brep::has_free_faces() const { return std::count(data_->is_free_face.begin(), data_->is_free_face.end(), 1) > 0; }
bool Brep::has_free_edges() const { return std::count(data_->is_free_edge.begin(), data_->is_free_edge.end(), 1) > 0; }
bool Brep::is_meshed(FaceId face) const {
    const auto bodies = bodies_of(face);
    return bodies[0].is_valid() || bodies[1].is_valid();
}
bool Brep::is_meshed(EdgeId edge) const {
    if (is_free(edge)) return true;
    const auto faces = faces_of(edge);
    return std::any_of(faces.begin(), faces.end(), [&](FaceId face) { return is_meshed(face); });
}
std::vector<FaceId> Brep::faces_at(Entity entity) const {
    std::vector<FaceId> faces;
    const auto add_faces_of = [&](EdgeId e) { faces.insert(faces.end(), faces_of(e).begin(), faces_of(e).end()); };
    if (entity.dim == 2) faces.emplace_back(entity.index);
    if (entity.dim == 1) add_faces_of(EdgeId(entity.index));
    if (entity.dim == 0) {
        for (const EdgeId e : edges_of(VertexId(entity.index))) add_faces_of(e);
        const auto [first, last] = data_->face_around.equal_range(VertexId(entity.index));
        for (auto it = first; it != last; ++it) faces.push_back(it->second);
    }
    sort_once(faces);
    return faces;
}
bool Brep::is_degenerated(EdgeId id) const { return data_->is_degenerated[id.index()]; }
bool Brep::is_seam(EdgeId edge, FaceId face) const { return data_->is_seam(edge, face); }

Vec3 Brep::point_of(VertexId id) const { return data_->points[id.index()]; }
double Brep::distance_from(VertexId id, const Vec3& p) const {
    return std::min(distance(point_of(id), p), distance(to_vec3(BRep_Tool::Pnt(vertex(id))), p));
}
const Box& Brep::box_of(FaceId face) const { return data_->box_of_face[face.index()]; }
const Box& Brep::box_of(EdgeId edge) const { return data_->box_of_edge[edge.index()]; }
const Box& Brep::box() const { return data_->box; }
Tolerances Brep::tolerances() const { return {data_->box.diagonal()}; }
double Brep::volume_of(SolidId solid) const { return data_->volumes[solid.index()]; }
double Brep::volume() const { return std::accumulate(data_->volumes.begin(), data_->volumes.end(), 0.0); }

}  // namespace featuremesh
