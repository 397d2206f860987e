// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/raw_document.h"

#include <BRep_Builder.hxx>
#include <BRep_CurveOn2Surfaces.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_ListIteratorOfListOfPointRepresentation.hxx>
#include <BRep_PointRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TFace.hxx>
#include <BRep_TVertex.hxx>
#include <BinTools.hxx>
#include <BinTools_LocationSet.hxx>
#include <BinTools_ShapeSet.hxx>
#include <Standard_Failure.hxx>
#include <TopLoc_Datum3D.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <array>
#include <map>
#include <sstream>
#include <streambuf>
#include <vector>

#include "core/errors.h"

namespace featuremesh {

namespace {

/// Reads from bytes without a copy.
struct ByteBuffer : std::streambuf {
    explicit ByteBuffer(std::span<const std::byte> bytes) {
        char* begin = const_cast<char*>(reinterpret_cast<const char*>(bytes.data()));
        setg(begin, begin, begin + bytes.size());
    }
    pos_type seekoff(off_type offset, std::ios_base::seekdir dir, std::ios_base::openmode) override {
        char* base = dir == std::ios_base::beg ? eback() : dir == std::ios_base::cur ? gptr() : egptr();
        setg(eback(), base + offset, egptr());
        return gptr() - eback();
    }
    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }
};

/// FreeCAD hands shapes on with the placement of every step and its inverse, each an object of its own, so that most
/// have a chain of them that comes to nothing, and who asks the kernel for a place multiplies it out. Here equal
/// placements are one and those without effect none, so that chains cancel by themselves. What was one shape at one
/// place stays so.
class PlainLocations {
  public:
    void set(const BinTools_LocationSet& locations) {
        locations_ = &locations;
        plain_.assign(1, TopLoc_Location());
        for (int i = 1; i <= locations.NbLocations(); ++i) plain_.push_back(plain(locations.Location(i)));
    }
    /// Of one that the set has.
    const TopLoc_Location& of(const TopLoc_Location& location) const {
        if (location.IsIdentity()) return plain_[0];
        const int number = locations_->Index(location);
        if (number == 0) throw StateError("The shapes are damaged: they have a place that is not in their list.");
        return plain_[static_cast<std::size_t>(number)];
    }

  private:
    TopLoc_Location plain(const TopLoc_Location& chain) {
        if (chain.IsIdentity()) return chain;
        return plain(chain.NextLocation()) * of_placement(chain.FirstDatum()).Powered(chain.FirstPower());
    }
    const TopLoc_Location& of_placement(const Handle(TopLoc_Datum3D) & placement) {
        const auto [known, is_new] = by_object_.try_emplace(placement.get());
        if (is_new) known->second = of_matrix(placement);
        return known->second;
    }
    TopLoc_Location of_matrix(const Handle(TopLoc_Datum3D) & placement) {
        static constexpr std::array<double, 12> none{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        std::array<double, 12> matrix;
        for (int i = 0; i < 12; ++i)
            matrix[static_cast<std::size_t>(i)] = placement->Transformation().Value(i / 4 + 1, i % 4 + 1);
        if (matrix == none) return {};
        return by_matrix_.try_emplace(matrix, TopLoc_Location(placement)).first->second;
    }

    const BinTools_LocationSet* locations_ = nullptr;
    std::vector<TopLoc_Location> plain_;  // by number in the set
    std::map<const TopLoc_Datum3D*, TopLoc_Location> by_object_;
    std::map<std::array<double, 12>, TopLoc_Location> by_matrix_;
};

/// Reads shapes with plain locations.
class PlainShapes : public BinTools_ShapeSet {
  public:
    const TopLoc_Location& location(int number) const { return plain_.of(Locations().Location(number)); }

    void ReadGeometry(Standard_IStream& in, const Message_ProgressRange& range) override {
        plain_.set(Locations());  // they come first
        BinTools_ShapeSet::ReadGeometry(in, range);
    }
    void ReadSubs(TopoDS_Shape& shape, Standard_IStream& in, const Standard_Integer count) override {
        BinTools_ShapeSet::ReadSubs(shape, in, count);
        if (!shape.IsNull()) shape.Location(plain_.of(shape.Location()));
    }
    void ReadShape(const TopAbs_ShapeEnum kind, Standard_IStream& in, TopoDS_Shape& shape) override {
        BinTools_ShapeSet::ReadShape(kind, in, shape);
        if (kind == TopAbs_VERTEX) place_points(*static_cast<BRep_TVertex*>(shape.TShape().get()));
        if (kind == TopAbs_EDGE) place_curves(*static_cast<BRep_TEdge*>(shape.TShape().get()));
        if (kind == TopAbs_FACE) place_surface(*static_cast<BRep_TFace*>(shape.TShape().get()));
    }

  private:
    void place_points(BRep_TVertex& vertex) const {
        for (BRep_ListIteratorOfListOfPointRepresentation it(vertex.ChangePoints()); it.More(); it.Next())
            it.Value()->Location(plain_.of(it.Value()->Location()));
    }
    void place_curves(BRep_TEdge& edge) const {
        for (BRep_ListIteratorOfListOfCurveRepresentation it(edge.ChangeCurves()); it.More(); it.Next()) {
            const TopLoc_Location& place = plain_.of(it.Value()->Location());
            if (const auto smooth = Handle(BRep_CurveOn2Surfaces)::DownCast(it.Value()); !smooth.IsNull())
                it.ChangeValue() = new BRep_CurveOn2Surfaces(smooth->Surface(), smooth->Surface2(), place,
                                                             plain_.of(smooth->Location2()), smooth->Continuity());
            else
                it.Value()->Location(place);
        }
    }
    void place_surface(BRep_TFace& face) const { face.Location(plain_.of(face.Location())); }

    PlainLocations plain_;
};

// FreeCAD writes a ShapeSet followed by shape index, location index and orientation, which is not what BinTools::Write
// writes.
TopoDS_Shape read_compound(std::istream& in) {
    PlainShapes set;
    set.Read(in);
    if (set.NbShapes() == 0) throw StateError("The shapes are not in FreeCAD's binary form.");
    int shape = 0, location = 0, orientation = 0;
    BinTools::GetInteger(in, shape);
    BinTools::GetInteger(in, location);
    BinTools::GetInteger(in, orientation);
    if (!in || shape <= 0 || shape > set.NbShapes()) throw StateError("The shapes are cut short or damaged.");
    TopoDS_Shape compound = set.Shape(shape);
    compound.Location(set.location(location));
    compound.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return compound;
}

}  // namespace

std::vector<TopoDS_Shape> read_shapes(std::span<const std::byte> bytes) {
    if (bytes.empty()) throw StateError("The document's shapes are missing.");
    ByteBuffer buffer(bytes);
    std::istream in(&buffer);
    std::vector<TopoDS_Shape> shapes;
    try {
        const TopoDS_Shape compound = read_compound(in);
        for (TopoDS_Iterator child(compound); child.More(); child.Next()) shapes.push_back(child.Value());
    } catch (const Standard_Failure& failure) {
        throw StateError(std::string("The shapes cannot be read: ") + failure.GetMessageString());
    } catch (const std::bad_alloc&) {
        throw StateError("The shapes are damaged: their sizes make no sense.");
    }
    return shapes;
}

std::vector<std::byte> write_shapes(std::span<const TopoDS_Shape> shapes) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes) {
        TopoDS_Compound empty;
        builder.MakeCompound(empty);
        builder.Add(compound, shape.IsNull() ? empty : shape);
    }
    BinTools_ShapeSet set;
    set.SetWithTriangles(false);
    const int index = set.Add(compound);
    std::ostringstream out;
    set.Write(out);
    BinTools::PutInteger(out, index);
    BinTools::PutInteger(out, set.Locations().Index(compound.Location()));
    BinTools::PutInteger(out, static_cast<int>(compound.Orientation()));
    const std::string text = std::move(out).str();
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

}  // namespace featuremesh
