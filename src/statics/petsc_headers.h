// SPDX-License-Identifier: GPL-3.0-or-later
// PETSc's headers. They refuse an Open MPI of a later major version than the one that PETSc was built with, even where
// its library is the same by name, as in Debian while packages are built anew. CMakeLists.txt sets
// FEATUREMESH_MPI_IS_LATER where they refuse it but a program runs.
#pragma once

#include <mpi.h>
#ifdef FEATUREMESH_MPI_IS_LATER
#undef OMPI_MAJOR_VERSION
#undef OMPI_MINOR_VERSION
#undef OMPI_RELEASE_VERSION
#define OMPI_MAJOR_VERSION PETSC_PKG_OPENMPI_VERSION_MAJOR
#define OMPI_MINOR_VERSION PETSC_PKG_OPENMPI_VERSION_MINOR
#define OMPI_RELEASE_VERSION PETSC_PKG_OPENMPI_VERSION_SUBMINOR
#endif
#include <petscksp.h>
