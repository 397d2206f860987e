// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/bodies_apart.h"

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Trsf.hxx>
#include <vector>

#include "core/joined_sets.h"

namespace featuremesh {

namespace {

void collect_bodies(const TopoDS_Shape& shape, std::vector<TopoDS_Shape>& bodies) {
    if (shape.ShapeType() != TopAbs_COMPOUND) return bodies.push_back(shape);
    for (TopoDS_Iterator child(shape); child.More(); child.Next()) collect_bodies(child.Value(), bodies);
}

/// By body the first one of those that hang together with it.
std::vector<std::int32_t> joined_to(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Shape> bodies;
    collect_bodies(shape, bodies);
    JoinedSets sets(bodies.size());
    TopTools_DataMapOfShapeInteger first_with;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        TopTools_IndexedMapOfShape pieces;
        TopExp::MapShapes(bodies[b], pieces);
        for (int i = 1; i <= pieces.Extent(); ++i)
            if (const int* first = first_with.Seek(pieces(i)))
                sets.join(*first, std::int32_t(b));
            else
                first_with.Bind(pieces(i), int(b));
    }
    std::vector<std::int32_t> joined;
    for (std::size_t b = 0; b < bodies.size(); ++b) joined.push_back(sets.root(std::int32_t(b)));
    return joined;
}

/// Puts the bodies of each set at a place of their own, which has no effect.
class Separation {
  public:
    explicit Separation(std::vector<std::int32_t> sets) : sets_(std::move(sets)), places_(sets_.size()) {
        for (std::size_t b = 1; b < sets_.size(); ++b)
            if (sets_[b] == std::int32_t(b)) places_[b] = TopLoc_Location(gp_Trsf());
    }

    TopoDS_Shape separated(const TopoDS_Shape& shape) {
        if (shape.ShapeType() != TopAbs_COMPOUND) return shape.Moved(places_[std::size_t(sets_[next_++])]);
        TopoDS_Compound apart;
        BRep_Builder builder;
        builder.MakeCompound(apart);
        for (TopoDS_Iterator child(shape, false, false); child.More(); child.Next())
            builder.Add(apart, separated(child.Value()));
        apart.Location(shape.Location());
        apart.Orientation(shape.Orientation());
        return apart;
    }

  private:
    const std::vector<std::int32_t> sets_;
    std::vector<TopLoc_Location> places_;  // by first body of a set
    std::size_t next_ = 0;
};

}  // namespace

bool has_joined_bodies(const TopoDS_Shape& shape) {
    if (shape.IsNull() || shape.ShapeType() != TopAbs_COMPOUND) return false;
    const std::vector<std::int32_t> joined = joined_to(shape);
    for (std::size_t b = 0; b < joined.size(); ++b)
        if (joined[b] != std::int32_t(b)) return true;
    return false;
}

TopoDS_Shape with_bodies_apart(const TopoDS_Shape& shape, const TopoDS_Shape& by_kernel) {
    const std::vector<std::int32_t> sets = joined_to(by_kernel);
    return sets == joined_to(shape) ? shape : Separation(sets).separated(shape);
}

}  // namespace featuremesh
