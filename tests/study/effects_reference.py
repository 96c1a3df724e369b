#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Front and effects of a table.csv by NumPy and SciPy, for effects_test.cpp, printed as JSON.

TABLE MEASURE X REGION   axes are the columns between `region` and the first measure, which is `rmse`
"""
import csv
import itertools
import json
import sys

import numpy
from scipy import stats


def interval(values):
    values = numpy.asarray(values, float)
    if len(values) < 2:
        return [values.mean() if len(values) else None, None, None]
    low, high = stats.t.interval(0.95, len(values) - 1, loc=values.mean(), scale=stats.sem(values))
    return [values.mean(), low, high]


def rest(row, names, factors):
    return tuple(row[name] for name in factors if name not in names)


def main_effect(rows, factor, factors):
    rows = [row for row in rows if row[factor] != ""]
    levels = list(dict.fromkeys(row[factor] for row in rows))
    blocks = {key: {row[factor]: row["y"] for row in rows if rest(row, [factor], factors) == key}
              for key in {rest(row, [factor], factors) for row in rows}}
    complete = [block for block in blocks.values() if len(block) == len(levels)]
    return {"blocks": len(complete), "incomplete": len(blocks) - len(complete),
            "levels": {level: interval([block[level] - numpy.mean(list(block.values())) for block in complete])
                       for level in levels}}


def interaction(rows, pair, factors):
    rows = [row for row in rows if all(row[name] != "" for name in pair)]
    levels = [list(dict.fromkeys(row[name] for row in rows)) for name in pair]
    tables = []
    keys = {rest(row, pair, factors) for row in rows}
    for key in keys:
        table = numpy.full([len(one) for one in levels], numpy.nan)
        for row in rows:
            if rest(row, pair, factors) == key:
                table[levels[0].index(row[pair[0]]), levels[1].index(row[pair[1]])] = row["y"]
        if not numpy.isnan(table).any():
            tables.append(table - table.mean(1, keepdims=True) - table.mean(0, keepdims=True) + table.mean())
    cells = {f"{a},{b}": interval([table[i, j] for table in tables])
             for (i, a), (j, b) in itertools.product(enumerate(levels[0]), enumerate(levels[1]))}
    return {"blocks": len(tables), "incomplete": len(keys) - len(tables), "cells": cells}


def slope(rows, axis):
    """A dummy column for each arm, and log2 of values that span a factor of five."""
    x = numpy.array([float(row[axis]) for row in rows])
    doubling = bool(x.min() > 0 and x.max() >= 5 * x.min())
    x = numpy.log2(x) if doubling else x
    arms = sorted({row["arm"] for row in rows})
    design = numpy.column_stack([x] + [[float(row["arm"] == arm) for row in rows] for arm in arms])
    y = numpy.array([row["y"] for row in rows])
    found, squares, rank, _ = numpy.linalg.lstsq(design, y, rcond=None)
    degrees = len(y) - rank
    variance = squares[0] / degrees * numpy.linalg.inv(design.T @ design)[0, 0]
    half = stats.t.ppf(0.975, degrees) * numpy.sqrt(variance)
    return {"doubling": doubling, "slope": [found[0], found[0] - half, found[0] + half]}


def front(rows):
    """Numbers of the undominated points; smaller costs are better."""
    worse = lambda a, b: b["x"] <= a["x"] and b["y"] <= a["y"] and (b["x"] < a["x"] or b["y"] < a["y"])
    return [int(row["point"]) for row in rows if not any(worse(row, other) for other in rows)]


def main():
    table, measure, x, region = sys.argv[1:5]
    with open(table, newline="") as stream:
        rows = list(csv.DictReader(stream))
    names = list(rows[0])
    axes = names[names.index("region") + 1:names.index("rmse")]
    rows = [row for row in rows if row["region"] == region and row[measure] != "" and row[x] != ""]
    for row in rows:
        row["y"], row["x"] = float(row[measure]), float(row[x])
    varied = [name for name in ["arm", "shot"] + axes if len({row[name] for row in rows} - {""}) > 1]
    answer = {"front": front(rows), "main": {}, "pairs": {}, "slopes": {}}
    for factor in varied:
        answer["main"][factor] = main_effect(rows, factor, varied)
        if answer["main"][factor]["blocks"] == 0 and factor in axes:
            answer["slopes"][factor] = slope(rows, factor)
    for pair in itertools.combinations(varied, 2):
        answer["pairs"]["/".join(pair)] = interaction(rows, pair, varied)
    print(json.dumps(answer))


main()
