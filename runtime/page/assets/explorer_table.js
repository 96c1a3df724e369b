// Common elements of the views, filters, the table of points, and the worst crops.
(function () {
  "use strict";
  const { data, state, measures, value } = explorer;

  function element(name, text, attributes = {}) {
    const made = document.createElement(name);
    if (text !== undefined) made.textContent = text;
    for (const [key, given] of Object.entries(attributes)) made.setAttribute(key, given);
    return made;
  }
  function append(host, name, text, attributes) {
    const made = element(name, text, attributes);
    host.append(made);
    return made;
  }

  // An empty table with a header row, in a scrolling box.
  function table(host, columns, numeric) {
    const box = append(host, "div", undefined, { class: "scroll", tabindex: "0", role: "region", "aria-label": "table" });
    const made = append(box, "table");
    const row = made.createTHead().insertRow();
    columns.forEach((column, index) =>
      append(row, "th", column, { scope: "col", ...(numeric[index] ? { class: "number" } : {}) }));
    made.createTBody();
    return made;
  }

  function pointButton(host, point, text) {
    const button = append(host, "button", text, { type: "button", class: "link",
                                                  "aria-label": `show point ${point.n}: ${explorer.describe(point)}` });
    button.onclick = () => explorer.select(point.n);
    return button;
  }

  // Row of a point. A click in the row chooses the point, except on buttons and inputs, or while text is selected.
  function pointRow(made, point) {
    const row = made.tBodies[0].insertRow();
    row.dataset.point = point.n;
    if (point.n === state.selected) row.setAttribute("aria-current", "true");
    row.onclick = event => {
      if (!event.target.closest("button, input") && getSelection().isCollapsed) explorer.select(point.n);
    };
    return row;
  }

  // Cell with a number of a point: a button that shows the commands which make the number again.
  function numberCell(row, point, name, region = state.region) {
    const cell = row.insertCell(), number = value(point, name, region);
    cell.className = "number";
    if (Number.isNaN(number)) return void (cell.textContent = "–");
    const tied = explorer.isTied(point, name, region);
    const text = explorer.shown(name, number) + (tied ? "?" : "");
    const button = append(cell, "button", text, { type: "button", class: "link", "data-value": number,
      title: (tied ? "? truth cannot tell it from others of its group\n" : "") + (point.sweep || point.command) });
    button.onclick = () => { explorer.quote(point, name, region); };
  }

  // ---- filters

  const levels_used = new Map();
  const usedLevels = name => {
    if (!levels_used.has(name)) levels_used.set(name, findLevels(name));
    return levels_used.get(name);
  };
  const findLevels = name => name === "arm" ? data.arms.filter(arm => arm.role !== "truth").map(arm => arm.name)
    : explorer.axisNamed(name).values.filter(one => explorer.points.some(point => point.at[name] === one))
      .map(one => explorer.label(name, one));

  function levelFilter(host, name, levels) {
    const box = append(host, "fieldset");
    append(box, "legend", name);
    for (const level of levels) {
      const label = append(box, "label");
      const input = append(label, "input", undefined, { type: "checkbox", "data-filter": name, "data-level": level });
      label.append(" " + level);
      const filter = state.filters[name];
      input.checked = !filter || !filter.levels || filter.levels.includes(level);
      input.onchange = () => {
        const checked = [...box.querySelectorAll("input")].filter(one => one.checked).map(one => one.dataset.level);
        if (checked.length === levels.length) delete state.filters[name]; else state.filters[name] = { levels: checked };
        explorer.changed();
      };
    }
  }

  function rangeFilter(host, name, title) {
    const box = append(host, "fieldset");
    append(box, "legend", title);
    const filter = state.filters[name] || {};
    const input = end => {
      const label = append(box, "label", end + " ");
      const made = append(label, "input", undefined, { type: "number", step: "any", "data-filter": name, "data-end": end });
      made.value = filter[end] ?? "";
      made.onchange = () => {
        const next = { ...(state.filters[name] || {}) };
        delete next.levels;
        next[end] = made.value === "" ? undefined : Number(made.value);
        if (next.from === undefined && next.to === undefined) delete state.filters[name]; else state.filters[name] = next;
        explorer.changed();
      };
    };
    input("from"), input("to");
  }

  function drawFilters(host) {
    host.textContent = "";
    const names = ["arm"].concat(data.axes.map(axis => axis.name));
    for (const name of names) {
      const levels = usedLevels(name);
      if (levels.length < 2) continue;
      const numeric = name !== "arm" && explorer.axisNamed(name).values.every(one => typeof one === "number");
      if (levels.length <= 12 || !numeric) levelFilter(host, name, levels); else rangeFilter(host, name, name);
    }
    for (const one of data.measures)
      if (one.better !== "neither") rangeFilter(host, one.name, explorer.measureTitle(one.name, state.region));
  }

  // ---- the table

  let most_rows = 500;

  function sortButton(head, name, title) {
    const down = state.sort === "-" + name, up = state.sort === name;
    head.setAttribute("aria-sort", down ? "descending" : up ? "ascending" : "none");
    const text = title + (down ? " ▼" : up ? " ▲" : "");
    const button = append(head, "button", text, { type: "button", class: "link", "data-sort": name });
    button.onclick = () => {
      state.sort = up ? "-" + name : name;
      explorer.changed();
    };
  }

  function columnsOf() {
    const columns = [{ name: "n", title: "point" }, { name: "arm", title: "arm" }];
    if (data.shots.length > 1) columns.push({ name: "shot", title: "shot" });
    for (const { name } of data.axes) if (usedLevels(name).length > 1) columns.push({ name, title: name });
    for (const one of data.measures)
      if (explorer.points.some(point => Number.isFinite(value(point, one.name, state.region))))
        columns.push({ name: one.name, title: explorer.measureTitle(one.name, state.region), measure: true });
    return columns;
  }

  function fillRow(row, point, columns) {
    const pin = append(row.insertCell(), "input", undefined, { type: "checkbox", "aria-label": `pin point ${point.n}` });
    pin.checked = state.pins.includes(point.n);
    pin.onchange = () => explorer.pin(point.n);
    for (const column of columns) {
      if (column.measure) { numberCell(row, point, column.name); continue; }
      const cell = row.insertCell();
      if (column.name === "n") pointButton(cell, point, String(point.n));
      else if (column.name === "arm") cell.textContent = point.arm;
      else if (column.name === "shot") cell.textContent = explorer.shotTitle(point.shot);
      else cell.textContent = column.name in point.at ? explorer.label(column.name, point.at[column.name]) : "";
    }
    const remarks = [point.failed && "failed: " + point.failed, point.undrawn && "not drawn yet",
                     point.limits && "limit: " + point.limits.join("; "), explorer.note(point) && "noted"];
    append(row, "td", remarks.filter(Boolean).join("; "), { class: "remark" });
  }

  function drawTable(host) {
    host.textContent = "";
    const list = explorer.sorted(explorer.visible()), columns = columnsOf();
    append(host, "h3", "Points" + explorer.ofShot());
    append(host, "p", "A number shows the commands that make it again; ? marks errors that truth is too coarse to rank.",
           { class: "soft" });
    const made = table(host, ["pin", ...columns.map(() => ""), "limits and failures"], [false, ...columns.map(column => column.measure), false]);
    made.id = "points";
    columns.forEach((column, index) => sortButton(made.tHead.rows[0].cells[index + 1], column.name, column.title));
    for (const point of list.slice(0, most_rows)) fillRow(pointRow(made, point), point, columns);
    if (list.length <= most_rows) return;
    const more = append(host, "button", `show all ${list.length}`, { type: "button" });
    more.onclick = () => { most_rows = Infinity; explorer.changed(); };
  }

  // ---- the worst crops

  function worstPoints() {
    const sign = measures.get(state.y).better === "higher" ? -1 : 1;
    const cost = point => sign * value(point, state.y, state.region);
    return explorer.visible().filter(point => point.worst && Number.isFinite(cost(point))).sort((a, b) => cost(b) - cost(a))
      .slice(0, Number(state.worst));
  }

  // Loads the pictures of the worst crops, so that a printed page has them.
  const prepareWorst = () => worstPoints().forEach(explorer.prepare);

  function drawWorst(host) {
    host.textContent = "";
    const list = worstPoints();
    append(host, "h3", "Worst crops by " + explorer.measureTitle(state.y, state.region) + explorer.ofShot());
    append(host, "p", "Where the FLIP map of a point, of the pictures as they are shown, is largest: the point, truth, FLIP.",
           { class: "soft" });
    const label = append(host, "label", "points ");
    const select = append(label, "select", undefined, { id: "choose-worst" });
    for (const count of ["6", "12", "24", "48"]) select.add(new Option(count));
    select.value = state.worst;
    select.onchange = () => { state.worst = select.value; explorer.changed(); };
    if (!list.length) append(host, "p", "No point that is shown has a picture and the value.");
    const grid = append(host, "div", undefined, { class: "worst" });
    for (const point of list) {
      const figure = append(grid, "figure", undefined, { "data-point": point.n });
      const row = append(figure, "div", undefined, { class: "triple" });
      explorer.crops(row, point, point.worst);
      const caption = append(figure, "figcaption");
      caption.append(explorer.shown(state.y, value(point, state.y, state.region)) + " ");
      pointButton(caption, point, `${point.n}: ${explorer.describe(point)}`);
    }
  }

  Object.assign(explorer, { element, append, table, pointRow, pointButton, numberCell, drawFilters, drawTable, drawWorst, prepareWorst });
})();
