// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/shape_stream.h"

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
#include <TopLoc_Location.hxx>
#include <TopoDS_Iterator.hxx>
#include <array>
#include <gp_Trsf.hxx>
#include <map>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

#include "brep/bodies_apart.h"
#include "core/errors.h"
#include "core/messages.h"

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

[[noreturn]] void fail_damaged_places() { throw StateError(say<Code::shapes_of_no_place>()); }

/// FreeCAD's shapes carry the placement of every modelling step and its inverse, each as an object of its own. Most of
/// these chains multiply out to nothing, yet the kernel multiplies them whenever it is asked where a shape is. Here
/// equal placements become one object, and placements without effect are left out, so that a placement and its inverse
/// cancel. Shapes that were shared stay shared, and more may be, see keep_bodies_apart.
class PlainLocations {
  public:
    /// Reads the kernel's list of locations: matrices, and chains of powers of those before them.
    void read(std::istream& in) {
        std::string word;
        std::size_t count = 0;
        in >> word >> count;
        in.get();
        if (!in || word != "Locations") fail_damaged_places();
        for (std::size_t i = 0; i < count; ++i) {
            const int kind = in.get();
            if (kind != 1 && kind != 2) fail_damaged_places();
            plain_.push_back(kind == 1 ? read_matrix(in) : read_chain(in));
            if (!in) fail_damaged_places();
        }
    }
    /// How many there are besides that of what is at its own place, which is number 0.
    std::size_t count() const { return plain_.size() - 1; }
    const TopLoc_Location& operator[](std::size_t number) const {
        if (number >= plain_.size()) fail_damaged_places();
        return plain_[number];
    }

  private:
    TopLoc_Location read_matrix(std::istream& in) {
        std::array<double, 12> m;
        for (double& value : m) BinTools::GetReal(in, value);
        gp_Trsf placement;
        placement.SetValues(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]);
        static constexpr std::array<double, 12> none{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        for (int i = 0; i < 12; ++i) m[static_cast<std::size_t>(i)] = placement.Value(i / 4 + 1, i % 4 + 1);
        if (m == none) return {};
        const auto [known, is_new] = by_matrix_.try_emplace(m);
        if (is_new) known->second = TopLoc_Location(placement);
        return known->second;
    }
    TopLoc_Location read_chain(std::istream& in) const {
        std::vector<TopLoc_Location> steps;
        for (int number = 0, power = 0;;) {
            BinTools::GetInteger(in, number);
            if (number == 0 || !in) break;
            BinTools::GetInteger(in, power);
            steps.push_back((*this)[static_cast<std::size_t>(number)].Powered(power));
        }
        TopLoc_Location chain;  // from its end: the kernel copies the right factor of a product, step by step
        for (auto step = steps.rbegin(); step != steps.rend(); ++step) chain = chain * *step;
        return chain;
    }

    std::vector<TopLoc_Location> plain_{TopLoc_Location()};  // by number in the list
    std::map<std::array<double, 12>, TopLoc_Location> by_matrix_;
};

/// A list of as many locations that are but numbers: the n-th is the n-th power of a step.
void write_numbers(std::ostream& out, std::size_t count) {
    out << "Locations " << count << "\n";
    for (std::size_t n = 1; n <= count; ++n) {
        out.put(n == 1 ? 1 : 2);
        if (n == 1) {
            for (const double value : {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0}) BinTools::PutReal(out, value);
        } else {
            for (const int value : {1, static_cast<int>(n), 0}) BinTools::PutInteger(out, value);
        }
    }
}

int number_of(const TopLoc_Location& location) { return location.IsIdentity() ? 0 : location.FirstPower(); }

/// The same shapes with numbers for their places, which the kernel handles much faster than the chains.
std::string with_numbers(std::span<const std::byte> bytes, PlainLocations& places) {
    ByteBuffer buffer(bytes);
    std::istream in(&buffer);
    std::string line;
    do {
        if (!std::getline(in, line)) throw StateError(say<Code::shapes_not_binary>());
    } while (!line.starts_with("Open CASCADE Topology V"));
    const auto begin = static_cast<std::size_t>(in.tellg());
    places.read(in);
    const auto end = static_cast<std::size_t>(in.tellg());
    const char* text = reinterpret_cast<const char*>(bytes.data());
    std::ostringstream out;
    out.write(text, static_cast<std::streamsize>(begin));
    write_numbers(out, places.count());
    out.write(text + end, static_cast<std::streamsize>(bytes.size() - end));
    return std::move(out).str();
}

/// Reads shapes that have numbers for locations and puts them in their places.
class PlainShapes : public BinTools_ShapeSet {
  public:
    explicit PlainShapes(const PlainLocations& places) : places_(places) {}

    void ReadSubs(TopoDS_Shape& shape, Standard_IStream& in, const Standard_Integer count) override {
        BinTools_ShapeSet::ReadSubs(shape, in, count);
        if (!shape.IsNull()) shape.Location(plain(shape.Location()));
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
            it.Value()->Location(plain(it.Value()->Location()));
    }
    void place_curves(BRep_TEdge& edge) const {
        for (BRep_ListIteratorOfListOfCurveRepresentation it(edge.ChangeCurves()); it.More(); it.Next()) {
            const TopLoc_Location& place = plain(it.Value()->Location());
            if (const auto smooth = Handle(BRep_CurveOn2Surfaces)::DownCast(it.Value()); !smooth.IsNull())
                it.ChangeValue() = new BRep_CurveOn2Surfaces(smooth->Surface(), smooth->Surface2(), place,
                                                             plain(smooth->Location2()), smooth->Continuity());
            else
                it.Value()->Location(place);
        }
    }
    void place_surface(BRep_TFace& face) const { face.Location(plain(face.Location())); }

    const TopLoc_Location& plain(const TopLoc_Location& number) const {
        return places_[static_cast<std::size_t>(number_of(number))];
    }

    const PlainLocations& places_;
};

// FreeCAD writes a ShapeSet followed by shape index, location index and orientation, which is not what BinTools::Write
// writes.
TopoDS_Shape read_compound(std::span<const std::byte> bytes, BinTools_ShapeSet& set, const auto& place_of) {
    ByteBuffer buffer(bytes);
    std::istream in(&buffer);
    set.Read(in);
    if (set.NbShapes() == 0) throw StateError(say<Code::shapes_not_binary>());
    int shape = 0, location = 0, orientation = 0;
    BinTools::GetInteger(in, shape);
    BinTools::GetInteger(in, location);
    BinTools::GetInteger(in, orientation);
    if (!in || shape <= 0 || shape > set.NbShapes()) throw StateError(say<Code::shapes_cut_short>());
    TopoDS_Shape compound = set.Shape(shape);
    compound.Location(place_of(location));
    compound.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return compound;
}

std::vector<TopoDS_Shape> children_of(const TopoDS_Shape& compound) {
    std::vector<TopoDS_Shape> shapes;
    for (TopoDS_Iterator child(compound); child.More(); child.Next()) shapes.push_back(child.Value());
    return shapes;
}

std::vector<TopoDS_Shape> read_plain(std::span<const std::byte> bytes) {
    PlainLocations places;
    const std::string numbered = with_numbers(bytes, places);
    PlainShapes set(places);
    const auto place_of = [&](int location) { return places[static_cast<std::size_t>(location)]; };
    return children_of(read_compound(std::as_bytes(std::span(numbered)), set, place_of));
}

std::vector<TopoDS_Shape> read_by_kernel(std::span<const std::byte> bytes) {
    BinTools_ShapeSet set;
    return children_of(read_compound(bytes, set, [&](int location) { return set.Locations().Location(location); }));
}

// Two parts that are cut from one block, say, have the uncut faces in common where equal places are one object. The
// kernel tells them apart, and so do FreeCAD's numbers of faces.
void keep_bodies_apart(std::vector<TopoDS_Shape>& shapes, std::span<const std::byte> bytes) {
    std::vector<TopoDS_Shape> by_kernel;
    for (std::size_t s = 0; s < shapes.size(); ++s) {
        if (!has_joined_bodies(shapes[s])) continue;
        if (by_kernel.empty()) by_kernel = read_by_kernel(bytes);
        shapes[s] = with_bodies_apart(shapes[s], by_kernel[s]);
    }
}

}  // namespace

std::vector<TopoDS_Shape> read_shapes(std::span<const std::byte> bytes) {
    if (bytes.empty()) throw StateError(say<Code::shapes_missing>());
    std::vector<TopoDS_Shape> shapes;
    try {
        shapes = read_plain(bytes);
        keep_bodies_apart(shapes, bytes);
    } catch (const Standard_Failure& failure) {
        throw StateError(say<Code::shapes_unreadable>(failure.GetMessageString()));
    } catch (const std::bad_alloc&) {
        throw StateError(say<Code::shapes_of_no_size>());
    }
    return shapes;
}

}  // namespace featuremesh
