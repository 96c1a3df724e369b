# SPDX-License-Identifier: MIT
"""Strobe from Python: pictures as NumPy arrays, results of experiments as pandas frames.

Images are arrays of height x width x channels, rows from the top. Colours are linear with Rec. 709 primaries.
docs/python.md is the introduction, docs/commands.md explains every option.
"""
from .experiments import parameters, passes, results, sweep
from .pictures import Picture, compare, read_exr, record, render
from .program import StrobeError, StrobeWarning

__all__ = ["Picture", "StrobeError", "StrobeWarning", "compare", "parameters", "passes", "read_exr", "record", "render",
           "results", "sweep"]
