// Charts of measures: one measure against another with the front, and parallel coordinates. Each arm has the same marks
// and dashes as in the other charts of the page (chart.css).
(function () {
  "use strict";
  const { data, measures, state, value } = explorer;
  const symbols = [d3.symbolCircle, d3.symbolSquare, d3.symbolTriangle, d3.symbolDiamond, d3.symbolCross, d3.symbolStar,
                   d3.symbolWye].map(type => d3.symbol().type(type).size(64)()).concat("M-5.5 -4H5.5L0 5.5Z");
  const methods = data.arms.map((arm, index) => index).filter(index => data.arms[index].role !== "truth");
  const styleOf = arm => "s" + methods.indexOf(arm) % 8;
  const symbolOf = arm => symbols[methods.indexOf(arm) % symbols.length];
  const chosen = point => (point.n === state.selected ? " selected" : "") + (state.pins.includes(point.n) ? " pinned" : "");

  function canvas(host, width, height, about) {
    const svg = d3.create("svg").attr("class", "chart live-chart").attr("viewBox", `0 0 ${width} ${height}`)
      .attr("role", "group").attr("aria-label", about);
    host.append(svg.node());
    return svg;
  }

  const text = (svg, classes, x, y, anchor, words) =>
    svg.append("text").attr("class", classes).attr("x", x).attr("y", y).attr("text-anchor", anchor).text(words);
  const path = (svg, classes, d) => svg.append("path").attr("class", classes).attr("d", d);
  const plot = (svg, left, right, top, bottom) => svg.append("rect").attr("class", "plot").attr("x", left).attr("y", top)
    .attr("width", right - left).attr("height", bottom - top);

  // True if the scale is logarithmic: by choice, or because values of a cost or axis span more than a factor of five.
  function isLog(name, how, extent) {
    if (how !== "auto") return how === "log" && extent[0] > 0;
    const { better, is_axis } = measures.get(name);
    return extent[0] > 0 && extent[1] > 5 * extent[0] && (better === "lower" || is_axis);
  }

  function scaleOf(name, how, numbers, range) {
    const extent = d3.extent(numbers), log = isLog(name, how, extent);
    const scale = (log ? d3.scaleLog() : d3.scaleLinear()).range(range);
    const wide = extent[0] === extent[1];
    if (log) scale.domain([extent[0] / (wide ? 1.5 : 1.05), extent[1] * (wide ? 1.5 : 1.05)]);
    else {
      const room = wide ? Math.abs(extent[0]) * 0.1 || 1 : (extent[1] - extent[0]) * 0.05;
      scale.domain([extent[0] - room, extent[1] + room]);
    }
    scale.log = log;
    return scale;
  }

  const written = number => number === 0 ? "0" : Math.abs(number) >= 1e4 || Math.abs(number) < 1e-3
    ? d3.format(".2~e")(number) : d3.format(".4~g")(number);
  function ticksOf(scale, count) {
    if (!scale.log) return scale.ticks(count);
    const all = scale.ticks(), [low, high] = scale.domain();
    if (high / low < 4) return d3.scaleLinear().domain([low, high]).ticks(count);
    const round = all.filter(one => [1, 2, 5].includes(Math.round(one / 10 ** Math.floor(Math.log10(one) + 1e-9))));
    return round.length <= count + 3 ? round : all.filter(one => Math.abs(Math.log10(one) % 1) < 1e-9);
  }

  function axes(svg, x, y, left, right, top, bottom) {
    plot(svg, left, right, top, bottom);
    for (const one of ticksOf(x, 8)) {
      path(svg, "grid", `M${x(one)} ${top}V${bottom}`);
      text(svg, "tick", x(one), bottom + 17, "middle", written(one));
    }
    for (const one of ticksOf(y, 6)) {
      path(svg, "grid", `M${left} ${y(one)}H${right}`);
      text(svg, "tick", left - 7, y(one) + 4, "end", written(one));
    }
  }

  // Marks and lines are buttons: the pointer, Tab and the keys reach them. Tab stops at the chosen point of a chart,
  // otherwise at the first. `enter`: action of the key Enter.
  function asButton(group, point, said, enter = explorer.select) {
    group.attr("role", "button").attr("data-point", point.n).attr("aria-label", said)
      .attr("tabindex", point.n === state.selected ? 0 : -1).attr("aria-pressed", point.n === state.selected);
    group.append("title").text(said);
    group.on("click", () => explorer.select(point.n));
    group.on("keydown", () => {
      const event = d3.event || window.event;
      const act = { Enter: enter, " ": explorer.select }[event.key];
      if (act) { event.preventDefault(); act(point.n); }
    });
    return group;
  }
  function stopAtOne(svg, buttons) {
    if (svg.select(buttons + "[tabindex='0']").empty()) svg.select(buttons + "[role=button]").attr("tabindex", 0);
  }

  function mark(parent, point, place, said) {
    const arm = point.a;
    const group = parent.append("g").attr("class", "mark " + styleOf(arm) + chosen(point))
      .attr("transform", `translate(${place})`);
    group.append("circle").attr("class", "ring").attr("r", 9);
    group.append("path").attr("class", "shape" + (point.limits ? " hollow" : "")).attr("d", symbolOf(arm));
    return asButton(group, point, said);
  }

  // Width of the longest word; a digit or letter is at most 8 px wide.
  const widthOf = words => 8 * Math.max(0, ...words.map(word => String(word).length));
  const legendWidth = 40 + widthOf(methods.map(arm => data.arms[arm].name));

  // `asLines`: show lines instead of marks.
  function legend(svg, list, left, top, withFront, asLines) {
    const arms = methods.filter(arm => list.some(point => point.a === arm));
    let y = top + 8;
    if (withFront) {
      const row = svg.append("g").attr("class", "front");
      row.append("path").attr("d", `M${left} ${y}h22`);
      row.append("text").attr("x", left + 30).attr("y", y + 4).text("front");
      y += 18;
    }
    for (const arm of arms) {
      const row = svg.append("g").attr("class", styleOf(arm));
      if (asLines) row.append("path").attr("d", `M${left} ${y}h22`);
      else row.append("path").attr("class", "shape").attr("transform", `translate(${left + 11} ${y})`).attr("d", symbolOf(arm));
      row.append("text").attr("x", left + 30).attr("y", y + 4).text(data.arms[arm].name);
      y += 18;
    }
  }

  // ---- the front

  function drawFront(host) {
    host.textContent = "";
    const { x: xName, y: yName, region } = state;
    const of = (point, name) => value(point, name, region);
    const list = explorer.visible().filter(point => Number.isFinite(of(point, xName)) && Number.isFinite(of(point, yName)));
    const [xTitle, yTitle] = [xName, yName].map(name => explorer.measureTitle(name, region));
    const title = yTitle + " against " + xTitle + explorer.ofShot();
    explorer.append(host, "h3", title);
    if (!list.length) return void explorer.append(host, "p", "No point that is shown has both values.");
    const front = explorer.front(list, xName, yName, region);
    const has_front = explorer.hasFront(xName, yName);
    explorer.append(host, "p", has_front ? `${front.length} of ${list.length} points are on the front: no other that is ` +
      "shown is as good in both." : "No front: a value of " + (measures.get(xName).better === "neither" ? xTitle : yTitle) +
      " is neither better nor worse than another.", { class: "finding" });
    const height = 470, left = 74, right = 740, top = 14, bottom = 414, width = right + 30 + legendWidth;
    const svg = canvas(host, width, height, title);
    const x = scaleOf(xName, state.logx, list.map(point => of(point, xName)), [left + 4, right - 4]);
    const y = scaleOf(yName, state.logy, list.map(point => of(point, yName)), [bottom - 4, top + 4]);
    axes(svg, x, y, left, right, top, bottom);
    text(svg, "title", (left + right) / 2, bottom + 42, "middle", xTitle);
    svg.append("text").attr("class", "title").attr("transform", `translate(16 ${(top + bottom) / 2}) rotate(-90)`)
      .attr("text-anchor", "middle").text(yTitle);
    const place = point => [x(of(point, xName)), y(of(point, yName))];
    const steps = front.map(place);
    if (has_front) svg.append("g").attr("class", "front").append("path")
      .attr("d", steps.map(([px, py], i) => i ? `H${px}V${py}` : `M${px} ${py}`).join(""));
    quartiles(svg, list, place, [[xName, x, true], [yName, y, false]]);
    const order = list.slice().sort((a, b) => (a.n === state.selected) - (b.n === state.selected));
    const marks = svg.append("g").attr("class", "marks");
    for (const point of order)
      mark(marks, point, place(point), `${point.n}: ${explorer.describe(point)}; ` +
        `${explorer.shown(xName, of(point, xName))}, ${explorer.shown(yName, of(point, yName))}` +
        (front.includes(point) ? "; on the front" : "")).classed("on-front", front.includes(point));
    stopAtOne(marks, ".mark");
    legend(svg, list, right + 22, top + 8, has_front);
    const remarks = ["Hollow marks: a limit was met."];
    if (measures.has("ms_low")) remarks.push("Lines: quartiles of the times.");
    if (data.software) remarks.push("A software device: its milliseconds are not a GPU's.");
    explorer.append(host, "p", remarks.join(" "), { class: "soft" });
    if (has_front) frontTable(host, front);
  }

  // Draws a line between the quartiles of the times of a point, if both were measured.
  function quartiles(svg, list, place, axes) {
    if (!measures.has("ms_low") || !measures.has("ms_high")) return;
    for (const [name, scale, across] of axes) {
      if (name !== "ms") continue;
      const within = number => Math.min(scale.domain()[1], Math.max(scale.domain()[0], number));
      for (const point of list) {
        const ends = ["ms_low", "ms_high"].map(one => value(point, one));
        if (!ends.every(Number.isFinite)) continue;
        const [from, to] = ends.map(one => scale(within(one))), [px, py] = place(point);
        svg.append("g").attr("class", styleOf(point.a)).append("path").attr("class", "error")
          .attr("d", across ? `M${from} ${py}H${to}` : `M${px} ${from}V${to}`);
      }
    }
  }

  function frontTable(host, front) {
    const titles = [state.x, state.y].map(one => explorer.measureTitle(one, state.region));
    const columns = ["point", "method and values", ...titles];
    const table = explorer.table(host, columns, [false, false, true, true]);
    table.id = "front-points";
    for (const point of front) {
      const row = explorer.pointRow(table, point);
      explorer.pointButton(row.insertCell(), point, String(point.n));
      row.insertCell().textContent = explorer.describe(point);
      for (const name of [state.x, state.y]) explorer.numberCell(row, point, name);
    }
  }

  // ---- parallel coordinates

  // Arm, axes and measures, each with a scale and a place `at(point)`; missing values are below the lower end.
  function dimensions(list, top, bottom) {
    const all = [], range = [bottom, top], below = bottom + 14;
    const discrete = (name, title, levels, of) => {
      if (levels.length < 2) return;
      const scale = d3.scalePoint().domain(levels).range(range).padding(0.3);
      all.push({ name, title, scale, levels, at: point => scale(of(point)) ?? below });
    };
    const continuous = (name, title, scale, of) =>
      all.push({ name, title, scale, at: point => Number.isFinite(of(point)) ? scale(of(point)) : below });
    const arms = methods.map(arm => data.arms[arm].name).filter(name => list.some(point => point.arm === name));
    discrete("arm", "arm", arms, point => point.arm);
    for (const { name, title, values } of data.axes) {
      const used = values.filter(one => list.some(point => point.at[name] === one));
      if (used.length < 2) continue;
      if (used.length <= 12 || !used.every(one => typeof one === "number")) {
        discrete(name, title, used.map(one => explorer.label(name, one)), point => explorer.label(name, point.at[name]));
        continue;
      }
      const [least, most] = d3.extent(used), wide = least > 0 && most > 20 * least;
      const scale = (wide ? d3.scaleLog() : d3.scaleLinear()).domain([least, most]).range(range);
      scale.log = wide;
      continuous(name, title, scale, point => point.at[name]);
    }
    for (const { name, better } of data.measures) {
      const of = point => value(point, name, state.region), numbers = list.map(of).filter(Number.isFinite);
      if (numbers.length < 2 || better === "neither") continue;
      continuous(name, explorer.measureTitle(name, state.region), scaleOf(name, "auto", numbers, range), of);
    }
    return all;
  }

  // Filters a dimension by the levels or the range inside `span`; null removes the filter.
  function brushed(one, span) {
    const inside = level => span[0] <= one.scale(level) && one.scale(level) <= span[1];
    if (!span) delete state.filters[one.name];
    else if (one.levels) state.filters[one.name] = { levels: one.levels.filter(inside) };
    else {
      const round = number => Number(number.toPrecision(4));
      state.filters[one.name] = { from: round(one.scale.invert(span[1])), to: round(one.scale.invert(span[0])) };
    }
    explorer.changed();
  }

  // Chooses a point and pins it; the focused line may be another line than the chosen one.
  function pin(n) {
    if (n !== state.selected) explorer.select(n);
    explorer.pin(n);
  }

  function drawParallel(host) {
    host.textContent = "";
    const all = explorer.points.filter(point => (!state.shot || point.shot === state.shot) && !point.undrawn && !point.failed);
    const shown = new Set(explorer.visible());
    explorer.append(host, "h3", "Every point as a line" + explorer.ofShot());
    explorer.append(host, "p", "Drag along an axis to show only what passes there; click it to show all again. The filters " +
      "above do the same from the keyboard. Tab goes to the chosen line, arrow keys from line to line, Enter pins. Lines end " +
      "lower where a point has no value.", { class: "soft" });
    if (!all.length) return;
    const top = 56, bottom = 400, list = dimensions(all, top, bottom);
    const left = Math.max(60, 16 + widthOf((list[0] || {}).levels || [])), right = left + 780, width = right + 40 + legendWidth;
    const svg = canvas(host, width, 440, "Parallel coordinates of arm, axes and measures");
    const x = d3.scalePoint().domain(list.map(one => one.name)).range([left, right]);
    const lines = svg.append("g").attr("class", "lines");
    const rank = point => shown.has(point) + 2 * state.pins.includes(point.n) + 4 * (point.n === state.selected);
    const order = all.slice().sort((a, b) => rank(a) - rank(b));
    for (const point of order) {
      const out = !shown.has(point);
      const line = lines.append("g").attr("class", "line " + styleOf(point.a) + chosen(point) + (out ? " out" : ""));
      line.append("path").attr("d", d3.line()(list.map(one => [x(one.name), one.at(point)])));
      const said = `${point.n}: ${explorer.describe(point)}`;
      if (out) line.append("title").text(said);
      else asButton(line, point, said, pin);
    }
    stopAtOne(lines, ".line");
    list.forEach((one, index) => {
      const column = svg.append("g").attr("class", "dimension").attr("transform", `translate(${x(one.name)} 0)`);
      path(column, "tickmark", `M0 ${top}V${bottom}`);
      text(column, "title", 0, index % 2 ? 34 : 16, "middle", one.title);
      const ticks = one.levels || ticksOf(one.scale, 5);
      for (const tick of ticks)
        text(column, "tick", -6, one.scale(tick) + 4, "end", one.levels ? tick : written(tick));
      const brush = d3.brushY().extent([[-14, top - 2], [14, bottom + 2]]);
      const area = column.append("g").attr("class", "brush").call(brush);
      const filter = state.filters[one.name];
      if (filter && filter.levels && one.levels) {
        const places = one.levels.filter(level => filter.levels.includes(level)).map(one.scale);
        if (places.length) area.call(brush.move, [d3.min(places) - 8, d3.max(places) + 8]);
      } else if (filter && !one.levels) {
        const [low, high] = one.scale.domain(), inside = end => one.scale(Math.min(high, Math.max(low, end)));
        area.call(brush.move, [inside(filter.to ?? high), inside(filter.from ?? low)]);
      }
      // Only drags have a source event; the calls of `brush.move` above do not. A click, which does not change the
      // selection, removes the filter.
      let before = "";
      brush.on("start", function () { before = JSON.stringify((d3.event || arguments[0]).selection); });
      brush.on("end", function () {
        const event = d3.event || arguments[0];
        if (event.sourceEvent) brushed(one, JSON.stringify(event.selection) === before ? null : event.selection);
      });
    });
    legend(svg, all, right + 40, top, false, true);
  }

  Object.assign(explorer, { drawFront, drawParallel, chart: { canvas, text, path, plot, written } });
})();
