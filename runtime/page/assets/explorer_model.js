// Model of the page: the points, the current choices, and values derived from both. No drawing.
const explorer = { data: JSON.parse(document.getElementById("explorer-data").textContent) };

(function () {
  "use strict";
  const data = explorer.data;
  const measures = new Map(data.measures.map(one => [one.name, one]));
  const points = data.points;
  const byNumber = new Map(points.map(point => [point.n, point]));
  for (const point of points) {
    point.group = data.groups[point.g];
    point.arm = data.arms[point.a].name;
    point.shot = point.group.shot;
    point.at = point.group.at;
  }
  // Numeric axes are drawn like measures, with names like "axis.samples".
  const numeric = data.axes.filter(axis => axis.values.length > 1 && axis.values.every(one => typeof one === "number"));
  for (const { name, title } of numeric) {
    const about = { title, unit: "", better: "neither", is_axis: true, doc: "what varies" };
    measures.set("axis." + name, { name: "axis." + name, ...about });
    for (const point of points) if (name in point.at) point.v["axis." + name] = point.at[name];
  }
  const shotTitle = name => (data.shots.find(one => one.name === name) || { title: name }).title;
  const axisNamed = name => data.axes.find(one => one.name === name);

  // ---- values

  // Value of a measure at a point; NaN if not measured.
  function value(point, name, region) {
    const measured = point.v[name];
    if (measured === undefined || measured === null) return NaN;
    const one = measures.get(name).per_region ? measured[data.regions.indexOf(region)] : measured;
    return one === null || one === undefined ? NaN : one;
  }

  // Text of a value, in the format of the tables of the page.
  function shown(name, number) {
    if (Number.isNaN(number)) return "–";
    const { unit, is_axis } = measures.get(name);
    if (is_axis) return String(number);
    if (unit === "ms") return (number < 10 ? number.toFixed(2) : number.toFixed(0)) + " ms";
    if (unit === "MiB") return number.toFixed(2) + " MiB";
    const size = Math.abs(number);
    if (unit === "B" || unit === "px") return number.toFixed(size < 999.5 && !Number.isInteger(number) ? 1 : 0) + " " + unit;
    if (Number.isInteger(number)) return String(number);
    return size < 1e-6 ? number.toExponential(1) : number.toFixed(Math.max(5, 1 - Math.floor(Math.log10(size))));
  }

  // Title like "RMSE, inner"; without a region if none is given.
  function measureTitle(name, region) {
    const one = measures.get(name);
    return one.title + (one.unit ? ", " + one.unit : "") + (one.per_region && region ? ", " + region : "");
  }

  const label = (axis, given) => {
    const known = axisNamed(axis);
    const at = known ? known.values.findIndex(one => one === given) : -1;
    return at < 0 ? String(given) : known.labels[at];
  };
  const describe = point => [point.arm].concat(
    data.shots.length > 1 ? [shotTitle(point.shot)] : [],
    Object.entries(point.at).map(([axis, given]) => axis + " " + label(axis, given))).join(", ");

  // Arm, shot and axis values of a point, by name.
  function parameters(point) {
    const all = { arm: point.arm };
    if (data.shots.length > 1) all.shot = shotTitle(point.shot);
    for (const [axis, given] of Object.entries(point.at)) all[axis] = label(axis, given);
    return all;
  }

  // Parameters with different values at `point` and `last`: [name, now, before]; "" for a missing value.
  function differences(point, last) {
    const now = parameters(point), before = last ? parameters(last) : {};
    const names = Object.keys(now).concat(Object.keys(before).filter(name => !(name in now)));
    return names.filter(name => now[name] !== before[name]).map(name => [name, now[name] || "", before[name] || ""]);
  }

  // ---- ties within the error of truth

  // Numbers of the points of a group with an error less than two standard errors of truth above the smallest error.
  // The noise of truth may decide the order of these points (triangle inequality).
  const ties = new Map();
  function tiedIn(g, region) {
    const key = g + " " + region;
    if (ties.has(key)) return ties.get(key);
    const sigma = (data.groups[g].sigma || [])[data.regions.indexOf(region)] || 0;
    const error = point => value(point, "rmse", region);
    const list = points.filter(one => one.g === g && data.arms[one.a].role === "method" && !Number.isNaN(error(one)));
    const least = Math.min(...list.map(error));
    const near = list.filter(one => error(one) < least + 2 * sigma);
    const ranked = near.every(one => error(one) === least);
    ties.set(key, new Set(ranked ? [] : near.map(one => one.n)));
    return ties.get(key);
  }
  const isTied = (point, name, region) => name === "rmse" && tiedIn(point.g, region).has(point.n);

  // ---- the front

  // Pareto front of the costs x and y, sorted by x; the first of equal points. Empty if a measure has no better
  // direction.
  const hasFront = (x, y) => [x, y].every(name => measures.get(name).better !== "neither");
  function front(list, x, y, region) {
    if (!hasFront(x, y)) return [];
    const cost = (name, number) => measures.get(name).better === "higher" ? -number : number;
    const costs = list.filter(point => data.arms[point.a].role === "method")
      .map((point, order) => ({ point, order, x: cost(x, value(point, x, region)), y: cost(y, value(point, y, region)) }))
      .filter(one => Number.isFinite(one.x) && Number.isFinite(one.y))
      .sort((a, b) => a.x - b.x || a.y - b.y || a.order - b.order);
    const kept = [];
    let least = Infinity;
    for (const one of costs) if (one.y < least) kept.push(one.point), least = one.y;
    return kept;
  }

  // ---- choices, and their form in the address

  const regional = data.measures.filter(one => one.per_region && one.better !== "neither");
  const first = (wanted, otherwise) => measures.has(wanted) ? wanted : otherwise;
  const defaults = {
    tab: "front", shot: data.shots.length === 1 ? data.shots[0].name : data.front.shot,
    region: data.front.region, x: data.front.x, y: data.front.y, logx: "auto", logy: "auto",
    sort: "n", find: "", selected: 0, last: 0, pins: [], filters: {}, view: "wipe", at: 0.5, against: 0, pair: "", worst: "12",
  };
  const any = data.measures[0] || { name: "" };
  defaults.y = first(defaults.y, (regional[0] || any).name);
  const other = data.measures.find(one => one.is_time) || data.measures.find(one => one.name !== defaults.y) ||
    [...measures.values()].find(one => one.is_axis) || any;
  defaults.x = first(defaults.x, other.name);
  if (!data.regions.includes(defaults.region)) defaults.region = data.regions[0] || "whole";
  const state = JSON.parse(JSON.stringify(defaults));
  const ofShot = () => state.shot ? "; " + shotTitle(state.shot) : "; all shots";
  const texts = ["tab", "shot", "region", "x", "y", "logx", "logy", "sort", "find", "view", "pair", "worst"];

  // A filter is a list of levels ("4|8"), or a range ("0.1..2"; each end may be missing).
  const filterText = one => one.levels ? one.levels.map(encodeURIComponent).join("|") : `${one.from ?? ""}..${one.to ?? ""}`;
  function filterOf(text) {
    const range = /^(-?[\d.e+-]*?)\.\.(-?[\d.e+-]*)$/.exec(text);
    if (!range) return { levels: text.split("|").map(decoded) };
    const end = given => given === "" || Number.isNaN(Number(given)) ? undefined : Number(given);
    return { from: end(range[1]), to: end(range[2]) };
  }

  function fragment() {
    const parts = [];
    for (const name of texts)
      if (state[name] !== defaults[name]) parts.push(name + "=" + encodeURIComponent(state[name]));
    if (state.selected) parts.push("point=" + state.selected);
    if (state.last) parts.push("last=" + state.last);
    if (state.pins.length) parts.push("pins=" + state.pins.join("."));
    if (state.against) parts.push("against=" + state.against);
    if (state.at !== 0.5) parts.push("wipe=" + Math.round(100 * state.at));
    for (const [name, one] of Object.entries(state.filters))
      parts.push("only." + encodeURIComponent(name) + "=" + encodeURIComponent(filterText(one)));
    return parts.join("&");
  }

  // Decoded text of an address; unchanged if it is not valid.
  function decoded(text) {
    try { return decodeURIComponent(text); } catch { return text; }
  }
  const canFilter = name => name === "arm" || !!axisNamed(name) || data.measures.some(one => one.name === name);

  function takePart(name, given) {
    const filtered = name.startsWith("only.") ? decoded(name.slice(5)) : "";
    if (texts.includes(name)) state[name] = given;
    else if (name === "point" && byNumber.has(Number(given))) state.selected = Number(given);
    else if (name === "last" && byNumber.has(Number(given))) state.last = Number(given);
    else if (name === "against" && byNumber.has(Number(given))) state.against = Number(given);
    else if (name === "pins") state.pins = given.split(".").map(Number).filter(one => byNumber.has(one));
    else if (name === "wipe") state.at = Math.min(1, Math.max(0, Number(given) / 100 || 0));
    else if (canFilter(filtered)) state.filters[filtered] = filterOf(given);
  }

  // Sets the state from an address; missing and unknown values get defaults. False if the address has no values, for
  // example a link to a section.
  function takeFragment(text) {
    const said = text.replace(/^#/, "");
    if (said && !said.includes("=")) return false;
    Object.assign(state, JSON.parse(JSON.stringify(defaults)));
    for (const part of said.split("&").filter(Boolean)) {
      const cut = part.indexOf("=");
      takePart(part.slice(0, cut), decoded(part.slice(cut + 1)));
    }
    const known = (name, all) => { if (!all.includes(state[name])) state[name] = defaults[name]; };
    known("x", [...measures.keys()]), known("y", data.measures.map(one => one.name)), known("region", data.regions);
    known("shot", [""].concat(data.shots.map(one => one.name)));
    known("tab", ["front", "table", "parallel", "effects", "worst"]), known("view", ["wipe", "picture", "truth", "flip"]);
    return true;
  }

  // ---- filtered and sorted points

  const levelOf = (point, name) => name === "arm" ? point.arm : name in point.at ? label(name, point.at[name]) : undefined;
  function passes(point, name, filter) {
    if (filter.levels) return filter.levels.includes(levelOf(point, name));
    const number = measures.has(name) ? value(point, name, state.region) : Number(point.at[name]);
    return number >= (filter.from ?? -Infinity) && number <= (filter.to ?? Infinity);
  }
  function visible(shot = state.shot) {
    const words = state.find.toLowerCase().split(/\s+/).filter(Boolean);
    return points.filter(point => (!shot || point.shot === shot) &&
      Object.entries(state.filters).every(([name, filter]) => passes(point, name, filter)) &&
      words.every(word => (point.n + " " + describe(point)).toLowerCase().includes(word)));
  }

  // Sorts by `state.sort`: "n", "arm", "shot", an axis or a measure; "-": largest first. Missing values come last.
  function sorted(list) {
    const down = state.sort.startsWith("-"), name = down ? state.sort.slice(1) : state.sort;
    const key = point => {
      if (name === "n") return point.n;
      if (name === "arm") return point.a;
      if (name === "shot") return data.shots.findIndex(one => one.name === point.shot);
      if (measures.has(name)) return value(point, name, state.region);
      const axis = axisNamed(name);
      return axis && name in point.at ? axis.values.indexOf(point.at[name]) : NaN;
    };
    const order = (a, b) => {
      const left = key(a), right = key(b);
      if (Number.isNaN(left) || Number.isNaN(right)) return Number.isNaN(left) - Number.isNaN(right) || a.n - b.n;
      return (down ? right - left : left - right) || a.n - b.n;
    };
    return list.slice().sort(order);
  }

  // ---- notes, kept by the browser

  const place = "strobe notes of " + data.title;
  let notes = {};
  try { notes = JSON.parse(localStorage.getItem(place)) || {}; } catch { notes = {}; }
  const noteName = point => describe(point) + (data.shots.length > 1 ? "" : ", " + point.shot);
  const note = point => notes[noteName(point)] || "";
  function setNote(point, text) {
    if (text) notes[noteName(point)] = text; else delete notes[noteName(point)];
    try { localStorage.setItem(place, JSON.stringify(notes)); } catch { /* kept until the page closes */ }
  }
  const noted = () => points.filter(note);
  const notesJson = () => {
    const notes = noted().map(point => ({ point: point.n, arm: point.arm, shot: point.shot, at: point.at, note: note(point),
                                          command: point.command }));
    return JSON.stringify({ title: data.title, notes }, null, 1) + "\n";
  };
  const notesMarkdown = () => `# Notes on ${data.title}\n` + noted().map(point =>
    `\n## Point ${point.n}: ${describe(point)}\n\n${note(point)}\n\n    ${point.command}\n`).join("");

  Object.assign(explorer, {
    measures, points, byNumber, shotTitle, axisNamed, value, shown, measureTitle, label, describe, parameters, differences,
    isTied, hasFront, front, state, ofShot, fragment, takeFragment, levelOf, visible, sorted, note, setNote, noted, notesJson,
    notesMarkdown,
  });
})();
