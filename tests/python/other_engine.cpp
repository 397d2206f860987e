// SPDX-License-Identifier: GPL-3.0-or-later
// An engine that speaks another protocol, for test_engine.py: it can say so, and nothing else.
#include <Python.h>

namespace {

PyObject* about(PyObject*, PyObject*) {
    return Py_BuildValue("{s:s, s:i}", "version", OTHER_VERSION, "protocol", OTHER_PROTOCOL);
}

PyMethodDef functions[] = {{"about", about, METH_NOARGS, nullptr}, {}};
PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "featuremesh_engine", nullptr, -1, functions, nullptr, nullptr, nullptr, nullptr};

}  // namespace

PyMODINIT_FUNC PyInit_featuremesh_engine() {
    PyObject* module = PyModule_Create(&definition);
    Py_INCREF(Py_None);
    PyModule_AddObject(module, "PartMesh", Py_None);
    return module;
}
