// Charts of measures: one against another with its front, and parallel coordinates. Marks and dashes are those of the
// page's other charts (chart.css), by arm.
(function () {
  "use strict";
  const { data, measures, state, value } = explorer;
  const symbols = [d3.symbolCircle, d3.symbolSquare, d3.symbolTriangle, d3.symbolDiamond, d3.symbolCross, d3.symbolStar,
                   d3.symbolWye, d3.symbolCircle];
  const methods = data.arms.map((arm, index) => index).filter(index => data.arms[index].role !== "truth");
  const styleOf = arm => "s" + methods.indexOf(arm) % 8;
  const symbolOf = arm => d3.symbol().type(symbols[methods.indexOf(arm) % symbols.length]).size(64)();
  const chosen = point => (point.n === state.selected ? " selected" : "") + (state.pins.includes(point.n) ? " pinned" : "");

  // An empty chart with room inside its margins.
  function canvas(host, width, height, margin, about) {
    const svg = d3.create("svg").attr("class", "chart live-chart").attr("viewBox", `0 0 ${width} ${height}`)
      .attr("role", "group").attr("aria-label", about);
    host.append(svg.node());
    return svg;
  }

  // Logarithmic where asked for, or where values of a cost span more than a factor of five.
  function isLog(name, how, extent) {
    if (how !== "auto") return how === "log" && extent[0] > 0;
    return extent[0] > 0 && extent[1] > 5 * extent[0] && measures.get(name).better === "lower";
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
    svg.append("rect").attr("class", "plot").attr("x", left).attr("y", top).attr("width", right - left).attr("height", bottom - top);
    for (const one of ticksOf(x, 8)) {
      svg.append("path").attr("class", "grid").attr("d", `M${x(one)} ${top}V${bottom}`);
      svg.append("text").attr("class", "tick").attr("x", x(one)).attr("y", bottom + 17).attr("text-anchor", "middle").text(written(one));
    }
    for (const one of ticksOf(y, 6)) {
      svg.append("path").attr("class", "grid").attr("d", `M${left} ${y(one)}H${right}`);
      svg.append("text").attr("class", "tick").attr("x", left - 7).attr("y", y(one) + 4).attr("text-anchor", "end").text(written(one));
    }
  }

  // Marks that are buttons: the pointer, Tab and Enter reach them.
  function mark(parent, point, place, said) {
    const arm = point.a;
    const group = parent.append("g").attr("class", "mark " + styleOf(arm) + chosen(point)).attr("transform", `translate(${place})`)
      .attr("role", "button").attr("tabindex", point.n === state.selected ? 0 : -1).attr("data-point", point.n)
      .attr("aria-label", said).attr("aria-pressed", point.n === state.selected);
    group.append("circle").attr("class", "ring").attr("r", 9);
    group.append("path").attr("class", "shape" + (point.limits ? " hollow" : "")).attr("d", symbolOf(arm));
    group.append("title").text(said);
    group.on("click", () => explorer.select(point.n));
    group.on("keydown", () => {
      const event = d3.event || window.event;
      if (event.key === "Enter" || event.key === " ") { event.preventDefault(); explorer.select(point.n); }
    });
    return group;
  }

  function legend(svg, list, left, top, withFront) {
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
      row.append("path").attr("class", "shape").attr("transform", `translate(${left + 11} ${y})`).attr("d", symbolOf(arm));
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
    const title = `${explorer.measureTitle(yName, region)} against ${explorer.measureTitle(xName, region)}` +
      (state.shot ? "; " + explorer.shotTitle(state.shot) : "; all shots");
    explorer.append(host, "h3", title);
    if (!list.length) return void explorer.append(host, "p", "No point that is shown has both values.");
    const front = explorer.front(list, xName, yName, region);
    explorer.append(host, "p", `${front.length} of ${list.length} points are on the front: no other that is shown is as good in both.`)
      .className = "finding";
    const width = 940, height = 470, left = 74, right = 740, top = 14, bottom = 414;
    const svg = canvas(host, width, height, 0, title);
    const x = scaleOf(xName, state.logx, list.map(point => of(point, xName)), [left + 4, right - 4]);
    const y = scaleOf(yName, state.logy, list.map(point => of(point, yName)), [bottom - 4, top + 4]);
    axes(svg, x, y, left, right, top, bottom);
    svg.append("text").attr("class", "title").attr("x", (left + right) / 2).attr("y", bottom + 42).attr("text-anchor", "middle")
      .text(explorer.measureTitle(xName, region));
    svg.append("text").attr("class", "title").attr("transform", `translate(16 ${(top + bottom) / 2}) rotate(-90)`)
      .attr("text-anchor", "middle").text(explorer.measureTitle(yName, region));
    const place = point => [x(of(point, xName)), y(of(point, yName))];
    const steps = front.map(place);
    svg.append("g").attr("class", "front").append("path")
      .attr("d", steps.map(([px, py], i) => i ? `H${px}V${py}` : `M${px} ${py}`).join(""));
    const order = list.slice().sort((a, b) => (a.n === state.selected) - (b.n === state.selected));
    const marks = svg.append("g").attr("class", "marks");
    for (const point of order)
      mark(marks, point, place(point), `${point.n}: ${explorer.describe(point)}; ` +
        `${explorer.shown(xName, of(point, xName))}, ${explorer.shown(yName, of(point, yName))}` +
        (front.includes(point) ? "; on the front" : "")).classed("on-front", front.includes(point));
    if (!order.some(point => point.n === state.selected)) marks.select(".mark").attr("tabindex", 0);
    legend(svg, list, right + 22, top + 8, true);
    explorer.append(host, "p", "Hollow marks: a limit was met." +
      (data.software ? " A software device: its milliseconds are not a GPU's." : "")).className = "soft";
    frontTable(host, front);
  }

  function frontTable(host, front) {
    const columns = ["point", "method and values", explorer.measureTitle(state.x, state.region), explorer.measureTitle(state.y, state.region)];
    const table = explorer.table(host, columns, [false, false, true, true]);
    table.id = "front-points";
    for (const point of front) {
      const row = table.tBodies[0].insertRow();
      row.dataset.point = point.n;
      explorer.pointButton(row.insertCell(), point, String(point.n));
      row.insertCell().textContent = explorer.describe(point);
      for (const name of [state.x, state.y]) explorer.numberCell(row, point, name);
    }
  }

  // ---- parallel coordinates

  // Arm, axes, measures: a scale each, with `at(point)`; what a point does not have is at the lower end.
  function dimensions(list, top, bottom) {
    const all = [], range = [bottom, top];
    const discrete = (name, title, levels, of) => {
      if (levels.length < 2) return;
      const scale = d3.scalePoint().domain(levels).range(range).padding(0.3);
      all.push({ name, title, scale, levels, at: point => scale(of(point)) ?? bottom + 14 });
    };
    discrete("arm", "arm", methods.map(arm => data.arms[arm].name).filter(name => list.some(point => point.arm === name)),
             point => point.arm);
    for (const axis of data.axes) {
      const used = axis.values.filter(one => list.some(point => point.at[axis.name] === one));
      if (used.length < 2) continue;
      const numeric = used.every(one => typeof one === "number");
      if (!numeric || used.length <= 12)
        discrete(axis.name, axis.title, used.map(one => explorer.label(axis.name, one)),
                 point => explorer.label(axis.name, point.at[axis.name]));
      else {
        const [least, most] = d3.extent(used), wide = least > 0 && most > 20 * least;
        const scale = (wide ? d3.scaleLog() : d3.scaleLinear()).domain([least, most]).range(range);
        scale.log = wide;
        all.push({ name: axis.name, title: axis.title, scale, at: point => axis.name in point.at ? scale(point.at[axis.name]) : bottom + 14 });
      }
    }
    for (const one of data.measures) {
      const numbers = list.map(point => value(point, one.name, state.region)).filter(Number.isFinite);
      if (numbers.length < 2 || one.better === "neither") continue;
      const scale = scaleOf(one.name, "auto", numbers, range);
      all.push({ name: one.name, title: explorer.measureTitle(one.name, state.region), scale,
                 at: point => { const number = value(point, one.name, state.region); return Number.isFinite(number) ? scale(number) : bottom + 14; } });
    }
    return all;
  }

  // Drawn along an axis: a filter of the levels or the range inside.
  function brushed(one, span) {
    if (!span) delete state.filters[one.name];
    else if (one.levels) state.filters[one.name] = { levels: one.levels.filter(level => span[0] <= one.scale(level) && one.scale(level) <= span[1]) };
    else {
      const round = number => Number(number.toPrecision(4));
      state.filters[one.name] = { from: round(one.scale.invert(span[1])), to: round(one.scale.invert(span[0])) };
    }
    explorer.changed();
  }

  function drawParallel(host) {
    host.textContent = "";
    const all = explorer.points.filter(point => !state.shot || point.shot === state.shot).filter(point => Object.keys(point.v).length);
    const shown = new Set(explorer.visible());
    explorer.append(host, "h3", "Every point as a line" + (state.shot ? "; " + explorer.shotTitle(state.shot) : "; all shots"));
    explorer.append(host, "p", "Drag along an axis to show only what passes there; click it to show all again. The filters above do " +
      "the same from the keyboard. Lines end lower where a point has no value.").className = "soft";
    if (!all.length) return;
    const width = 1100, top = 56, bottom = 400, left = 130, right = width - 40;
    const list = dimensions(all, top, bottom);
    const svg = canvas(host, width, 440, 0, "Parallel coordinates of arm, axes and measures");
    const x = d3.scalePoint().domain(list.map(one => one.name)).range([left, right]);
    const lines = svg.append("g").attr("class", "lines");
    const order = all.slice().sort((a, b) => shown.has(a) - shown.has(b) || state.pins.includes(a.n) - state.pins.includes(b.n) ||
      (a.n === state.selected) - (b.n === state.selected));
    for (const point of order) {
      const out = !shown.has(point);
      const line = lines.append("g").attr("class", "line " + styleOf(point.a) + chosen(point) + (out ? " out" : ""));
      line.append("path").attr("d", d3.line()(list.map(one => [x(one.name), one.at(point)])));
      line.append("title").text(`${point.n}: ${explorer.describe(point)}`);
      if (!out) line.on("click", () => explorer.select(point.n));
    }
    list.forEach((one, index) => {
      const column = svg.append("g").attr("class", "dimension").attr("transform", `translate(${x(one.name)} 0)`);
      column.append("path").attr("class", "tickmark").attr("d", `M0 ${top}V${bottom}`);
      column.append("text").attr("class", "title").attr("y", index % 2 ? 34 : 16).attr("text-anchor", "middle").text(one.title);
      const ticks = one.levels || ticksOf(one.scale, 5);
      for (const tick of ticks)
        column.append("text").attr("class", "tick").attr("x", -6).attr("y", one.scale(tick) + 4).attr("text-anchor", "end")
          .text(one.levels ? tick : written(tick));
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
      // What a person drags, not what was placed above; a click, which changes nothing, takes the filter away.
      let before = "";
      brush.on("start", function () { before = JSON.stringify((d3.event || arguments[0]).selection); });
      brush.on("end", function () {
        const event = d3.event || arguments[0];
        if (event.sourceEvent) brushed(one, JSON.stringify(event.selection) === before ? null : event.selection);
      });
    });
  }

  Object.assign(explorer, { drawFront, drawParallel, styleOf, symbolOf, chartCanvas: canvas, writtenTick: written });
})();
