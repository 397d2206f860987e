// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/raw_document.h"

#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Compound.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Iterator.hxx>
#include <array>
#include <map>
#include <sstream>
#include <streambuf>

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

// FreeCAD writes a ShapeSet followed by shape index, location index and orientation, which is not what BinTools::Write writes.
TopoDS_Shape read_compound(std::istream& in) {
    BinTools_ShapeSet set;
    set.Read(in);
    if (set.NbShapes() == 0) throw StateError("The shapes are not in FreeCAD's binary form.");
    int shape = 0, location = 0, orientation = 0;
    BinTools::GetInteger(in, shape);
    BinTools::GetInteger(in, location);
    BinTools::GetInteger(in, orientation);
    if (!in || shape <= 0 || shape > set.NbShapes()) throw StateError("The shapes are cut short or damaged.");
    TopoDS_Shape compound = set.Shape(shape);
    compound.Location(set.Locations().Location(location));
    compound.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return compound;
}

/// FreeCAD writes a place of its own for every shape, be it the same as another's or none at all. Shapes in the same
/// place must say so, or their common faces count as different; and each place is one product more for all that is asked
/// of a face or an edge.
class Places {
  public:
    TopoDS_Shape put(const TopoDS_Shape& shape) {
        if (shape.Location().IsIdentity()) return shape;
        const gp_Trsf motion = shape.Location().Transformation();
        std::array<double, 12> key;
        for (int i = 0; i < 12; ++i) key[i] = motion.Value(i / 4 + 1, i % 4 + 1);
        return shape.Located(known_.try_emplace(key, motion).first->second);
    }

  private:
    std::map<std::array<double, 12>, TopLoc_Location> known_{
        {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, TopLoc_Location()}};
};

}  // namespace

std::vector<TopoDS_Shape> read_shapes(std::span<const std::byte> bytes) {
    if (bytes.empty()) throw StateError("The document's shapes are missing.");
    ByteBuffer buffer(bytes);
    std::istream in(&buffer);
    std::vector<TopoDS_Shape> shapes;
    try {
        const TopoDS_Shape compound = read_compound(in);
        Places places;
        for (TopoDS_Iterator child(compound); child.More(); child.Next()) shapes.push_back(places.put(child.Value()));
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
