// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/shape_print.h"

#include <BRep_Tool.hxx>
#include <BinTools_CurveSet.hxx>
#include <BinTools_OStream.hxx>
#include <BinTools_SurfaceSet.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <bit>
#include <cstring>
#include <ostream>
#include <streambuf>

namespace featuremesh {

namespace {

/// Adds up what is written to it.
class PrintBuffer : public std::streambuf {
  public:
    std::uint64_t print() const { return sum_; }
    void add(std::uint64_t word) {
        sum_ = (sum_ ^ word) * 0xbf58476d1ce4e5b9ull;
        sum_ ^= sum_ >> 29;
    }

  protected:
    int_type overflow(int_type c) override {
        add(static_cast<std::uint64_t>(c));
        ++position_;
        return c;
    }
    std::streamsize xsputn(const char* bytes, std::streamsize count) override {
        std::streamsize i = 0;
        for (; i + 8 <= count; i += 8) {
            std::uint64_t word;
            std::memcpy(&word, bytes + i, 8);
            add(word);
        }
        for (; i < count; ++i) add(static_cast<unsigned char>(bytes[i]));
        position_ += count;
        return count;
    }
    pos_type seekoff(off_type, std::ios_base::seekdir, std::ios_base::openmode) override { return position_; }

  private:
    std::uint64_t sum_ = 0x9e3779b97f4a7c15ull;
    std::streamoff position_ = 0;
};

class Printer {
  public:
    std::uint64_t print() const { return buffer_.print(); }

    void add(const TopoDS_Shape& shape) {
        buffer_.add(static_cast<std::uint64_t>(shape.ShapeType()) * 8 +
                    static_cast<std::uint64_t>(shape.Orientation()));
        if (shape.ShapeType() == TopAbs_FACE)
            add_face(TopoDS::Face(shape));
        else if (shape.ShapeType() == TopAbs_EDGE)
            add_edge(TopoDS::Edge(shape));
        else if (shape.ShapeType() == TopAbs_VERTEX)
            add_point(BRep_Tool::Pnt(TopoDS::Vertex(shape)));
        else
            add(shape.Location());
        for (TopoDS_Iterator child(shape, false, false); child.More(); child.Next()) add(child.Value());
        buffer_.add(0);
    }

  private:
    void add_face(const TopoDS_Face& face) {
        TopLoc_Location place;
        const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
        add(place);
        if (!surface.IsNull()) BinTools_SurfaceSet::WriteSurface(surface, stream_);
    }

    void add_edge(const TopoDS_Edge& edge) {
        TopLoc_Location place;
        double first = 0, last = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, place, first, last);
        add(place);
        add_number(first), add_number(last);
        if (!curve.IsNull()) BinTools_CurveSet::WriteCurve(curve, stream_);
    }

    // The kernel keeps chains of places that come to nothing.
    void add(const TopLoc_Location& place) {
        if (place.IsIdentity()) return;
        const gp_Trsf& motion = place.Transformation();
        bool moves = false;
        for (int row = 1; row <= 3; ++row)
            for (int column = 1; column <= 4; ++column)
                moves |= motion.Value(row, column) != (row == column ? 1.0 : 0.0);
        for (int row = 1; moves && row <= 3; ++row)
            for (int column = 1; column <= 4; ++column) add_number(motion.Value(row, column));
    }

    void add_point(const gp_Pnt& p) { add_number(p.X()), add_number(p.Y()), add_number(p.Z()); }
    void add_number(double x) { buffer_.add(std::bit_cast<std::uint64_t>(x)); }

    PrintBuffer buffer_;
    std::ostream out_{&buffer_};
    BinTools_OStream stream_{out_};
};

}  // namespace

std::uint64_t print_of(const TopoDS_Shape& shape) { return print_of(std::span(&shape, 1)); }

std::uint64_t print_of(std::span<const TopoDS_Shape> shapes) {
    Printer printer;
    for (const TopoDS_Shape& shape : shapes) printer.add(shape);
    return printer.print();
}

}  // namespace featuremesh
