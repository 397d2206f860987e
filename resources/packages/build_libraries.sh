#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds what the engine's wheels need, for .github/workflows/release.yml: OCCT's modelling toolkits and oneTBB from source, the headers of
# CGAL and Boost, and the licences of all of them in $prefix/licences. Written, not yet run (see release.yml).
set -eu
occt=V7_8_1        # as in FreeCAD 1.0 and 1.1
tbb=v2021.13.0
cgal=6.1
boost=1.86.0
case "$(uname -s)" in
    Linux) prefix=/opt/featuremesh; gmp_and_mpfr=/usr/share/licenses; dnf install -y gmp-devel mpfr-devel ;;
    Darwin) prefix=/tmp/featuremesh; brew install gmp mpfr; gmp_and_mpfr=$(brew --prefix)/opt ;;
    *) prefix=C:/featuremesh; vcpkg install gmp:x64-windows mpfr:x64-windows; mkdir -p "$prefix"
       vcpkg_made=$VCPKG_INSTALLATION_ROOT/installed/x64-windows; gmp_and_mpfr=$vcpkg_made/share
       cp -r "$vcpkg_made"/{include,lib,bin} "$prefix"/ ;;
esac
mkdir -p "$prefix/licences"
work=$(mktemp -d)
cd "$work"

fetch() { curl -sSfL "$1" -o archive.tar && tar xf archive.tar && rm archive.tar; }
# keep_licence NAME FILES...
keep_licence() { name=$1; shift; for file in "$@"; do cp "$file" "$prefix/licences/$name-$(basename "$file")"; done; }
# The system's own generator, which on Windows is the one that finds the compiler.
build() { cmake --build "$1" --config Release --parallel "$(getconf _NPROCESSORS_ONLN || echo 4)" --target install; }

fetch "https://github.com/Open-Cascade-SAS/OCCT/archive/refs/tags/$occt.tar.gz"
cmake -S OCCT-* -B occt -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" -DINSTALL_DIR_LAYOUT=Unix \
    -DBUILD_MODULE_ApplicationFramework=OFF -DBUILD_MODULE_DataExchange=OFF -DBUILD_MODULE_Draw=OFF -DBUILD_MODULE_Visualization=OFF \
    -DBUILD_MODULE_DETools=OFF -DUSE_FREETYPE=OFF -DUSE_TK=OFF -DUSE_OPENGL=OFF -DUSE_XLIB=OFF -DBUILD_DOC_Overview=OFF
build occt
keep_licence occt OCCT-*/LICENSE_LGPL_21.txt OCCT-*/OCCT_LGPL_EXCEPTION.txt

fetch "https://github.com/uxlfoundation/oneTBB/archive/refs/tags/$tbb.tar.gz"
cmake -S oneTBB-* -B tbb -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" -DTBB_TEST=OFF
build tbb
keep_licence onetbb oneTBB-*/LICENSE.txt

fetch "https://github.com/CGAL/cgal/releases/download/v$cgal/CGAL-$cgal-library.tar.xz"
cp -r "CGAL-$cgal/include/." "$prefix/include/"
keep_licence cgal "CGAL-$cgal"/LICENSE*
fetch "https://archives.boost.io/release/$boost/source/boost_${boost//./_}.tar.gz"
cp -r "boost_${boost//./_}/boost" "$prefix/include/"
keep_licence boost boost_*/LICENSE_1_0.txt
for library in gmp mpfr; do
    find -L "$gmp_and_mpfr/$library" -maxdepth 1 \( -name 'COPYING*' -o -name copyright \) | while read -r file; do keep_licence "$library" "$file"; done
done
