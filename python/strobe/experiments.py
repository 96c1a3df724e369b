# SPDX-License-Identifier: MIT
"""Experiments and their results, passes and parameters, as pandas frames."""
from __future__ import annotations

import functools
import json
import math
import os
from pathlib import Path
from typing import Any, Iterator

import pandas as pd

from .pictures import File
from .program import call, run, words_of


def sweep(file: File, out: File, **options: Any) -> pd.DataFrame:
    """Runs an experiment (docs/writing-experiments.md), or continues it, and returns `results(out)`.

    file: the experiment, .lua. out: folder of the results. options: long options of `strobe sweep`, such as
    size=(160, 90), only="arm=hybrid", jobs=2. Raises StrobeError if a point failed or an expectation is contradicted.
    """
    run("sweep", *words_of({**options, "out": os.fspath(out)}), os.fspath(file))
    return results(out)


def results(folder: File) -> pd.DataFrame:
    """Results of an experiment or of `strobe demo`: a row per point and region.

    Columns: point (number from 1), arm, role, shot, region, each axis, each measure, truth_error (standard error of the
    RMSE of ground truth), pipeline, preset, failed (reason, or ""). Missing values are NaN.
    attrs: "units" of axes and measures by column, "title", "question" and "device" of the experiment.
    """
    content = _content(Path(folder))
    frame = pd.DataFrame(list(_rows(content)))
    units = {axis["name"]: axis.get("unit", "") for axis in content["axes"]}
    units |= {name: _measure_units()[name] for name in content["measures"]}
    frame.attrs = {"units": units, **{name: content.get(name, "") for name in ("title", "question", "device")}}
    return frame


def _content(folder: Path) -> dict[str, Any]:
    """Content of the results' file. Without one, `report` finds unfinished results or has the message."""
    for name in ("result.json", "demo.json"):
        if (folder / name).exists():
            return json.loads((folder / name).read_text(encoding="utf-8"))
    return call("report", str(folder), "--json")


def _rows(content: dict[str, Any]) -> Iterator[dict[str, Any]]:
    pipelines = {arm["name"]: arm["pipeline"] for arm in content["arms"]}
    number = 0
    for group in content["groups"]:
        truth, *points = group["points"]
        for point in points:
            number += 1
            for region in content["regions"]:
                axes = {axis["name"]: group["at"].get(axis["name"]) for axis in content["axes"]}
                measures = {measure: _value(point, measure, region) for measure in content["measures"]}
                error, square = _value(truth, "rmse", region), _value(truth, "mse", region)
                error = math.sqrt(square) if math.isnan(error) else error
                yield {"point": number, "arm": point["arm"], "role": point["role"], "shot": group["shot"],
                       "region": region, **axes, **measures, "truth_error": error,
                       "pipeline": pipelines[point["arm"]], "preset": point.get("preset", ""),
                       "failed": point.get("failed", "")}


def _value(point: dict[str, Any], measure: str, region: str) -> float:
    by_region = point.get("values", {}).get(measure, {})
    value = by_region.get(region, by_region.get("all"))
    return math.nan if value is None else value


@functools.cache
def _measure_units() -> dict[str, str]:
    return {measure["name"]: measure["unit"] for measure in call("help", "--json")["measures"]}


def passes() -> pd.DataFrame:
    """Every pass, by name: kind (raster, compute or trace), doc, fails (cases in which the result is wrong)."""
    return pd.DataFrame(call("help", "--json")["passes"]).set_index("name")[["kind", "doc", "fails"]]


def parameters(pipeline: str) -> pd.DataFrame:
    """Parameters of a pipeline or a pass, by name: type, default, min, max, choices, unit, doc."""
    columns = ["name", "type", "default", "min", "max", "choices", "unit", "doc"]
    return pd.DataFrame(call("help", pipeline, "--json")["params"], columns=columns).set_index("name")
