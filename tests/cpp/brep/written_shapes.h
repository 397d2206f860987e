// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as FreeCAD writes them.
#pragma once

#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <TopoDS_Compound.hxx>
#include <cstddef>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace featuremesh::test {

/// The other way round than read_shapes.
inline std::vector<std::byte> write_shapes(std::span<const TopoDS_Shape> shapes) {
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

}  // namespace featuremesh::test
