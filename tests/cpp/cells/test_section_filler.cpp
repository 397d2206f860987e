// SPDX-License-Identifier: GPL-3.0-or-later
// Our intersection and builder against the kernel's plain ones.
#include <BOPAlgo_Builder.hxx>
#include <BOPDS_DS.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <vector>

#include "catch.h"
#include "cells/parts.h"
#include "cells/section_filler.h"
#include "cells/solid_splitter.h"

using namespace featuremesh;
using namespace featuremesh::test;

namespace {

TopTools_ListOfShape list_of(const std::vector<TopoDS_Shape>& shapes) {
    TopTools_ListOfShape list;
    for (const TopoDS_Shape& shape : shapes) list.Append(shape);
    return list;
}

/// Sections that are left for the kernel to make edges of.
int sections_left(const std::vector<TopoDS_Shape>& shapes) {
    SectionFiller filler;
    filler.SetArguments(list_of(shapes));
    filler.Perform();
    int count = 0;
    for (int i = 0; i < filler.PDS()->InterfFF().Length(); ++i) count += filler.PDS()->InterfFF()(i).Curves().Length();
    return count;
}

/// Volume of every solid and area of every face, in order.
std::vector<double> measures(const TopoDS_Shape& shape) {
    std::vector<double> list;
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) {
        GProp_GProps volume;
        BRepGProp::VolumeProperties(it.Current(), volume);
        list.push_back(volume.Mass());
        for (TopExp_Explorer face(it.Current(), TopAbs_FACE); face.More(); face.Next()) {
            GProp_GProps area;
            BRepGProp::SurfaceProperties(face.Current(), area);
            list.push_back(area.Mass());
        }
    }
    return list;
}

void check_against_kernel(const std::vector<TopoDS_Shape>& shapes) {
    BOPAlgo_Builder plain;
    plain.SetArguments(list_of(shapes));
    plain.SetNonDestructive(true);
    plain.Perform();
    SectionFiller filler;
    filler.SetArguments(list_of(shapes));
    filler.SetNonDestructive(true);
    filler.Perform();
    RunContext context;
    SolidSplitter ours(context);
    ours.SetArguments(list_of(shapes));
    ours.PerformWithFiller(filler);
    REQUIRE_FALSE(ours.HasErrors());
    CHECK(measures(ours.Shape()) == measures(plain.Shape()));
}

TopoDS_Shape plate() { return box(0, 0, 0, 60, 40, 5); }

}  // namespace

TEST_CASE("features that end in a face of the plate leave no section to make") {
    CHECK(sections_left({plate(), cylinder({20, 20, 0}, {0, 0, 1}, 4, 5)}) == 0);
    CHECK(sections_left({plate(), cylinder({20, 20, 5}, {0, 0, -1}, 4, 5)}) == 0);
    CHECK(sections_left({plate(), box(30, 10, 5, 8, 8, 6)}) == 0);
    CHECK(sections_left({plate(), box(50, 10, 5, 10, 8, 6)}) == 0);
}

TEST_CASE("what one face cuts out of the other is left to the kernel") {
    CHECK(sections_left({plate(), cylinder({20, 20, -1}, {0, 0, 1}, 4, 6)}) == 1);
    CHECK(sections_left({plate(), cylinder({20, 20, -1}, {0, 0, 1}, 4, 7)}) == 2);
    CHECK(sections_left({plate(), box(30, 10, 2, 8, 8, 6)}) == 4);
}

TEST_CASE("cells of features on a plate are those of the plain kernel") {
    // flush, beyond, over a side, in a row with common sides, over one another, round in a notch
    check_against_kernel({plate(), cylinder({20, 20, 0}, {0, 0, 1}, 4, 5), cylinder({32, 20, 5}, {0, 0, -1}, 4, 5)});
    check_against_kernel({plate(), cylinder({20, 20, -1}, {0, 0, 1}, 4, 7), cylinder({40, 20, 0}, {0, 0, 1}, 4, 9)});
    check_against_kernel(
        {plate(), box(50, 10, 5, 15, 8, 6), box(20, 35, 0, 5, 10, 5), cylinder({60, 30, 0}, {0, 0, 1}, 4, 5)});
    check_against_kernel({plate(), box(10, 10, 5, 8, 8, 6), box(18, 10, 5, 8, 8, 6), box(10, 18, 0, 8, 8, 11)});
    check_against_kernel({plate(), cylinder({20, 20, 0}, {0, 0, 1}, 6, 5), cylinder({26, 20, 0}, {0, 0, 1}, 6, 5),
                          box(20, 14, 0, 6, 12, 5)});
    check_against_kernel({plate(), box(50, 15, 0, 10, 10, 5), cylinder({50, 20, 0}, {0, 0, 1}, 5, 5)});
}

TEST_CASE("cells of solids within solids are those of the plain kernel") {
    check_against_kernel({plate(), box(10, 10, 1, 8, 8, 3), sphere({40, 20, 2.5}, 2)});
    check_against_kernel({box(0, 0, 0, 30, 30, 30), box(5, 5, 5, 20, 20, 20), box(10, 10, 10, 10, 10, 10)});
    check_against_kernel({box(0, 0, 0, 30, 30, 30), sphere({30, 15, 15}, 6), cylinder({15, 15, -5}, {0, 0, 1}, 5, 40),
                          box(10, 10, 10, 10, 10, 30)});
}
