// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_PYTHON_BINDINGS_HPP
#define GCPW_PYTHON_BINDINGS_HPP

#include <pybind11/pybind11.h>

/// The classes and functions of each header of the module, added to the package's extension.
void bindParams(pybind11::module_& module);
void bindAlignment(pybind11::module_& module);
void bindPair(pybind11::module_& module);
void bindRig(pybind11::module_& module);
void bindWarper(pybind11::module_& module);
void bindStitch(pybind11::module_& module);

#endif
