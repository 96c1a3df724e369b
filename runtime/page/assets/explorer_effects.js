// Main effects and pairwise interactions for the measure y, computed by the program.
(function () {
  "use strict";
  const { data, state } = explorer, { canvas, text, path, plot, written } = explorer.chart;
  const signed = number => number === null ? "–" : (number > 0 ? "+" : "") + d3.format(".3~g")(number);
  const isClear = ([, low, high]) => low !== null && (low > 0 || high < 0);
  const interval = ([, low, high]) => low === null ? "–" : `${signed(low)} to ${signed(high)}`;

  const howToRead = data.how_to_read_effects + " All points of the shot count, also those that filters hide.";
  const plural = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;
  const leftOut = count => count ? `, ${count} incomplete left out` : "";

  function found() {
    const region = explorer.measures.get(state.y).per_region ? state.region : "";
    return data.effects.find(one => one.shot === state.shot && one.measure === state.y && one.region === region);
  }

  // Text about the points behind the effects of a factor.
  function basis(one) {
    if (one.comparison === "unpaired") return "unpaired: its levels never stand under the same conditions";
    if (one.comparison === "slope") return "a straight line through all points";
    return plural(one.blocks, "block") + leftOut(one.incomplete);
  }

  // Data of the table rows: one row per level, or one row for a slope.
  function rowsOf(effects) {
    const rows = [];
    for (const one of effects.main) {
      const factor = effects.factors[one.factor];
      const list = one.comparison === "slope" ? [[one.doubling ? "per doubling" : "per unit", one.slope]]
        : one.levels.map((level, index) => [factor.labels[index], level]);
      list.forEach(([label, estimate], index) => rows.push({ named: factor.name, label, estimate, first: index === 0,
                                                             basis: basis(one) }));
    }
    return rows;
  }

  function mainEffects(host, effects) {
    explorer.append(host, "h4", "Main effects");
    const rows = rowsOf(effects).filter(one => one.estimate[0] !== null);
    const most = d3.max(rows, ({ estimate }) => d3.max(estimate, end => Math.abs(end || 0))) || 1;
    const table = explorer.table(host, ["factor", "level", "effect", "95 % interval", ""], [false, false, true, true, false]);
    table.id = "main-effects";
    const width = 240, x = d3.scaleLinear().domain([-most, most]).range([8, width - 8]);
    for (const row of rows) {
      const line = table.tBodies[0].insertRow();
      line.dataset.factor = row.named, line.dataset.level = row.label;
      const head = document.createElement("th");
      head.scope = "row", head.textContent = row.first ? row.named : "", line.append(head);
      if (row.first) head.append(explorer.element("small", row.basis));
      line.insertCell().textContent = row.label;
      for (const text of [signed(row.estimate[0]), interval(row.estimate)]) {
        const cell = line.insertCell();
        cell.textContent = text;
        cell.className = "number" + (isClear(row.estimate) ? " best" : "");
        cell.title = "made by " + data.command;
      }
      whisker(line.insertCell(), row, x, width);
    }
  }

  function whisker(cell, row, x, width) {
    const [at, low, high] = row.estimate;
    const svg = d3.create("svg").attr("class", "chart whisker").attr("viewBox", `0 0 ${width} 22`).attr("role", "img")
      .attr("aria-label", `${row.named} ${row.label}: ${signed(at)}, ${interval(row.estimate)}`);
    path(svg, "tickmark", `M${x(0)} 0V22`);
    const group = svg.append("g").attr("class", isClear(row.estimate) ? "s2" : "s0");
    if (low !== null) path(group, "error", `M${x(low)} 11H${x(high)}M${x(low)} 6v10M${x(high)} 6v10`);
    group.append("circle").attr("cx", x(at)).attr("cy", 11).attr("r", 4.2);
    cell.append(svg.node());
  }

  // ---- pairs

  const strength = pair => d3.max(pair.cells.flat(), cell => Math.abs(cell[0]));
  const nameOf = (effects, pair) => effects.factors[pair.first].name + " × " + effects.factors[pair.second].name;

  function interactions(host, effects) {
    explorer.append(host, "h4", "Interactions");
    if (!effects.pairs.length)
      return void explorer.append(host, "p", "No two factors are crossed completely under the same conditions.");
    const pairs = effects.pairs.slice().sort((a, b) => strength(b) - strength(a));
    const label = explorer.append(host, "label", "pair, the strongest first ");
    const select = explorer.append(label, "select");
    select.id = "choose-pair";
    for (const pair of pairs) {
      const name = nameOf(effects, pair);
      select.add(new Option(`${name} (up to ${d3.format(".3~g")(strength(pair))})`, name));
    }
    const pair = pairs.find(one => nameOf(effects, one) === state.pair) || pairs[0];
    select.value = nameOf(effects, pair);
    select.onchange = () => { state.pair = select.value; explorer.changed(); };
    cellTable(host, effects, pair);
    means(host, effects, pair);
  }

  function cellTable(host, effects, pair) {
    const rows = effects.factors[pair.first], columns = effects.factors[pair.second];
    const heads = [`${rows.name} \\ ${columns.name}`].concat(columns.labels);
    const table = explorer.table(host, heads, heads.map((_, index) => index > 0));
    table.id = "interaction";
    const most = strength(pair) || 1;
    pair.cells.forEach((cells, row) => {
      const line = table.tBodies[0].insertRow();
      const head = document.createElement("th");
      head.scope = "row", head.textContent = rows.labels[row], line.append(head);
      for (const estimate of cells) {
        const cell = line.insertCell();
        cell.className = "number";
        cell.append(explorer.element(isClear(estimate) ? "strong" : "span", signed(estimate[0])));
        cell.append(explorer.element("small", estimate[1] === null ? "" : interval(estimate)));
        cell.style.setProperty("--strength", Math.round(26 * Math.abs(estimate[0]) / most) + "%");
        cell.classList.add(estimate[0] > 0 ? "more" : "less");
      }
    });
    explorer.append(host, "p", plural(pair.blocks, "block") + leftOut(pair.incomplete) +
      (pair.blocks === 1 ? ": one block has no interval" : "") + ". Bold: 0 is outside of the interval.", { class: "soft" });
  }

  // Means of the points by two factors: one list per level of the first factor.
  function meansBy(first, second) {
    const level = (point, factor) => factor.name === "shot" ? point.shot : explorer.levelOf(point, factor.name);
    const number = point => explorer.value(point, state.y, state.region);
    const list = explorer.points.filter(point => (!state.shot || point.shot === state.shot) &&
      data.arms[point.a].role === "method" && Number.isFinite(number(point)));
    const at = (a, b) => list.filter(point => level(point, first) === a && level(point, second) === b);
    return first.labels.map(a => second.labels.map(b => d3.mean(at(a, b), number)));
  }

  // Chart of the means; lines that are not parallel show an interaction.
  function means(host, effects, pair) {
    const [first, second] = [effects.factors[pair.first], effects.factors[pair.second]], lines = meansBy(first, second);
    const left = 70, right = 520, top = 12, bottom = 240;
    const about = `Means of ${explorer.measureTitle(state.y, state.region)} by ${nameOf(effects, pair)}`;
    const svg = canvas(host, 700, 290, about).attr("role", "img");
    const x = d3.scalePoint().domain(second.labels).range([left, right]).padding(0.4);
    const y = d3.scaleLinear().domain(d3.extent(lines.flat())).nice().range([bottom, top]);
    plot(svg, left, right, top, bottom);
    for (const tick of y.ticks(5)) {
      path(svg, "grid", `M${left} ${y(tick)}H${right}`);
      text(svg, "tick", left - 7, y(tick) + 4, "end", written(tick));
    }
    for (const name of second.labels) text(svg, "tick", x(name), bottom + 17, "middle", name);
    text(svg, "title", (left + right) / 2, bottom + 40, "middle", second.name);
    lines.forEach((line, index) => {
      const group = svg.append("g").attr("class", "s" + index % 8);
      const places = line.map((mean, i) => [x(second.labels[i]), mean]).filter(([, mean]) => mean !== undefined)
        .map(([px, mean]) => [px, y(mean)]);
      path(group, "", d3.line()(places));
      for (const [px, py] of places) group.append("circle").attr("cx", px).attr("cy", py).attr("r", 4);
      path(group, "", `M${right + 16} ${top + 10 + 18 * index}h22`);
      group.append("text").attr("x", right + 44).attr("y", top + 14 + 18 * index).text(first.labels[index]);
    });
  }

  function drawEffects(host) {
    host.textContent = "";
    const effects = found();
    explorer.append(host, "h3", `What ${explorer.measureTitle(state.y, state.region)} depends on` + explorer.ofShot());
    if (!effects) return void explorer.append(host, "p", "Nothing varies among these points, or none has the value.");
    explorer.append(host, "p", howToRead, { class: "soft" });
    explorer.append(host, "p", `${effects.points} points. Made by ${data.command}`, { class: "soft" });
    mainEffects(host, effects);
    interactions(host, effects);
  }

  Object.assign(explorer, { drawEffects });
})();
