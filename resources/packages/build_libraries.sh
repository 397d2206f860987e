#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds what the engine's wheels need, for .github/workflows/release.yml: OCCT's modelling toolkits and oneTBB from source, the headers of
# CGAL, Boost from the system's packages where they are new enough. Written, not yet run (see release.yml).
set -eu
occt=V7_8_1        # as in FreeCAD 1.0 and 1.1
tbb=v2021.13.0
cgal=6.1
boost=1.86.0
case "$(uname -s)" in
    Linux) prefix=/opt/featuremesh; yum install -y gmp-devel mpfr-devel ninja-build || dnf install -y gmp-devel mpfr-devel ninja-build ;;
    Darwin) prefix=/tmp/featuremesh; brew install gmp mpfr ninja ;;
    *) prefix=C:/featuremesh; vcpkg install gmp:x64-windows mpfr:x64-windows; mkdir -p "$prefix"
       cp -r "$VCPKG_INSTALLATION_ROOT"/installed/x64-windows/{include,lib,bin} "$prefix"/ ;;
esac
work=$(mktemp -d)
cd "$work"

fetch() { curl -sSfL "$1" -o archive.tar && tar xf archive.tar && rm archive.tar; }

fetch "https://github.com/Open-Cascade-SAS/OCCT/archive/refs/tags/$occt.tar.gz"
cmake -S OCCT-* -B occt -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" -DINSTALL_DIR_LAYOUT=Unix \
    -DBUILD_MODULE_ApplicationFramework=OFF -DBUILD_MODULE_DataExchange=OFF -DBUILD_MODULE_Draw=OFF -DBUILD_MODULE_Visualization=OFF \
    -DBUILD_MODULE_DETools=OFF -DUSE_FREETYPE=OFF -DUSE_TK=OFF -DUSE_OPENGL=OFF -DUSE_XLIB=OFF -DBUILD_DOC_Overview=OFF
cmake --build occt --target install

fetch "https://github.com/uxlfoundation/oneTBB/archive/refs/tags/$tbb.tar.gz"
cmake -S oneTBB-* -B tbb -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" -DTBB_TEST=OFF
cmake --build tbb --target install

fetch "https://github.com/CGAL/cgal/releases/download/v$cgal/CGAL-$cgal-library.tar.xz"
cp -r "CGAL-$cgal/include/." "$prefix/include/"
fetch "https://archives.boost.io/release/$boost/source/boost_${boost//./_}.tar.gz"
cp -r "boost_${boost//./_}/boost" "$prefix/include/"
