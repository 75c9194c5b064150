# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Params, and the stubs against what they describe."""
import ast
import pathlib

import pytest

import gcpw
from gcpw import _gcpw

STUBS = ast.parse((pathlib.Path(gcpw.__file__).parent / "_gcpw.pyi").read_text(encoding="utf-8"))


def test_members_are_set_by_name():
    params = gcpw.Params(meshCols=48, similarityWeight=0.25, method="mfw")
    assert (params.meshCols, params.similarityWeight, params.method) == (48, 0.25, "mfw")
    assert params.get("meshCols") == 48
    params.set("meshRows", 20)
    assert params.meshRows == 20 and isinstance(params.meshRows, int)
    assert "meshCols=48" in repr(params)


def test_what_is_out_of_range_or_unknown_is_named():
    with pytest.raises(ValueError, match="meshRows is 1"):
        gcpw.Params(meshRows=1)
    with pytest.raises(ValueError, match="simlarityWeight"):
        gcpw.Params(simlarityWeight=1)
    with pytest.raises(ValueError, match="ros.*gcpw"):
        gcpw.Params(method="ros")
    params = gcpw.Params()
    params.meshCols = 1
    with pytest.raises(ValueError, match="meshCols is 1"):
        params.check()


def test_the_papers_constants_are_there():
    assert gcpw.Params.paper().similarityWeight == 0.5
    gcpw.Params.alignment_only().check()


def members(node):
    for item in node.body:
        if isinstance(item, ast.AnnAssign):
            yield item.target.id
        elif isinstance(item, ast.FunctionDef):
            yield item.name


def test_stubs_name_what_is_there_and_nothing_else():
    for node in STUBS.body:
        if isinstance(node, ast.FunctionDef):
            assert callable(getattr(_gcpw, node.name)), node.name
        if isinstance(node, ast.ClassDef):
            made = getattr(_gcpw, node.name)
            stubbed = set(members(node))
            there = {name for name in vars(made) if not name.startswith("_")}
            assert {name for name in stubbed if not name.startswith("_")} == there, node.name
    functions = {node.name for node in STUBS.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    assert {name for name in vars(_gcpw) if not name.startswith("__")} == functions


def test_everything_public_says_what_it_is():
    for name in gcpw.__all__:
        assert name == "__version__" or getattr(gcpw, name).__doc__, name
