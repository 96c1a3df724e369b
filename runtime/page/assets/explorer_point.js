// The chosen point: picture, wipe against truth, FLIP map, crops, changed parameters, numbers, commands, notes.
(function () {
  "use strict";
  const { data, state, value } = explorer;
  const append = (...given) => explorer.append(...given);

  // ---- pictures

  // Pictures by number, loaded at the first use.
  const images = new Map();
  function picture(index) {
    if (!images.has(index)) {
      const image = new Image();
      image.src = data.pictures[index];
      images.set(index, image);
    }
    return images.get(index);
  }
  const prepare = point => [point.picture, point.group.picture, point.flip].forEach(picture);

  const heat = d3.range(256).map(i => d3.rgb(d3.interpolateMagma(i / 255))).map(({ r, g, b }) => [r, g, b]);

  // Draws `area` of a picture: [x, y, width, height] in pixels of the experiment, null for all. A FLIP map gets the
  // colours of magma.
  function draw(canvas, image, area, isFlip) {
    const scaleX = image.naturalWidth / data.size[0], scaleY = image.naturalHeight / data.size[1];
    const [x, y, width, height] = area || [0, 0, data.size[0], data.size[1]];
    canvas.width = Math.max(1, Math.round(width * scaleX)), canvas.height = Math.max(1, Math.round(height * scaleY));
    const context = canvas.getContext("2d", { willReadFrequently: isFlip });
    context.drawImage(image, x * scaleX, y * scaleY, width * scaleX, height * scaleY, 0, 0, canvas.width, canvas.height);
    if (!isFlip) return;
    const pixels = context.getImageData(0, 0, canvas.width, canvas.height);
    for (let i = 0; i < pixels.data.length; i += 4) pixels.data.set(heat[pixels.data[i]], i);
    context.putImageData(pixels, 0, 0);
  }

  function drawn(host, index, area, alt, isFlip) {
    const canvas = append(host, "canvas", undefined, { role: "img", "aria-label": alt });
    if (area) canvas.style.aspectRatio = area[2] + " / " + area[3];
    const image = picture(index), now = () => draw(canvas, image, area, isFlip);
    if (image.complete) now(); else image.addEventListener("load", now);
    return canvas;
  }

  // Draws the same crop of the point, of truth and of the FLIP map.
  function crops(host, point, area) {
    const [x, y, width, height] = area, where = `${width}x${height} at ${x},${y}`;
    drawn(host, point.picture, area, `${explorer.describe(point)}, crop ${where}`, false);
    drawn(host, point.group.picture, area, `truth, crop ${where}`, false);
    drawn(host, point.flip, area, `FLIP of ${explorer.describe(point)}, crop ${where}`, true);
  }

  // ---- the stage

  const views = [["wipe", "wipe"], ["picture", "picture"], ["truth", "truth"], ["flip", "FLIP"]];

  function stage(host, point) {
    if (point.picture === undefined) {
      const why = point.failed ? "It failed: " + point.failed : point.undrawn ? "It is not drawn yet." : "Its picture is " +
        "not here.";
      return void append(host, "p", why, { class: "soft" });
    }
    const has_truth = point.group.picture !== undefined, others = wipeable(point);
    const view = has_truth || (others.length && state.view === "wipe") ? state.view : "picture";
    const bar = append(host, "div", undefined, { class: "bar", role: "group", "aria-label": "What the stage shows" });
    for (const [name, title] of views) {
      if (!has_truth && name !== "picture" && (name !== "wipe" || !others.length)) continue;
      if (name === "flip" && point.flip === undefined) continue;
      const button = append(bar, "button", title, { type: "button", "aria-pressed": name === view, "data-view": name });
      button.onclick = () => { state.view = name; explorer.changed(); };
    }
    const box = append(host, "div", undefined, { class: "stage " + view });
    box.style.aspectRatio = data.size[0] + " / " + data.size[1];
    const said = explorer.describe(point);
    const image = (index, alt, classes) => append(box, "img", undefined, { src: data.pictures[index], alt, class: classes });
    if (view === "flip") drawn(box, point.flip, null, `FLIP map of ${said} against truth: bright is different`, true);
    if (view === "truth") image(point.group.picture, "truth of " + said, "under");
    if (view === "picture") image(point.picture, said, "under");
    if (view === "wipe") wipe(host, box, point, image, said);
  }

  // Other pinned points with pictures, for a wipe with `point`.
  const wipeable = point => state.pins.map(n => explorer.byNumber.get(n))
    .filter(one => one !== point && one.picture !== undefined);

  // The pinned point on the other side of the wipe; undefined: truth.
  const against = point => wipeable(point).find(one => one.n === state.against) ||
    (point.group.picture === undefined ? wipeable(point)[0] : undefined);

  function chooseAgainst(host, point) {
    const others = wipeable(point);
    if (!others.length) return;
    const label = append(host, "label", "against ", { class: "soft" });
    const select = append(label, "select", undefined, { id: "choose-against" });
    if (point.group.picture !== undefined) select.add(new Option("truth", 0));
    for (const one of others) select.add(new Option(`${one.n}: ${explorer.describe(one)}`, one.n));
    select.value = (against(point) || { n: 0 }).n;
    select.onchange = () => { state.against = Number(select.value); explorer.changed(); };
  }

  function wipe(host, box, point, image, said) {
    const other = against(point);
    if (other) image(other.picture, explorer.describe(other), "under");
    else image(point.group.picture, "truth of " + said, "under");
    const over = image(point.picture, said, "other");
    const edge = append(box, "div", undefined, { class: "edge" });
    append(box, "span", other ? `${point.n}: ${point.arm}` : point.arm, { class: "tag left" });
    append(box, "span", other ? `${other.n}: ${other.arm}` : "truth", { class: "tag right" });
    chooseAgainst(host, point);
    const label = append(host, "label", "wipe ", { class: "soft" });
    const slider = append(label, "input", undefined, { type: "range", min: 0, max: 100, id: "wipe" });
    const show = () => {
      over.style.clipPath = `inset(0 ${100 - 100 * state.at}% 0 0)`;
      edge.style.left = 100 * state.at + "%";
      slider.value = Math.round(100 * state.at);
    };
    slider.oninput = () => { state.at = slider.value / 100; show(); };
    slider.onchange = explorer.remember;
    box.onpointermove = event => {
      const area = box.getBoundingClientRect();
      state.at = Math.min(1, Math.max(0, (event.clientX - area.left) / area.width));
      show();
    };
    box.onpointerleave = explorer.remember;
    show();
  }

  function allCrops(host, point) {
    if (point.flip === undefined) return;
    const shot = data.shots.find(one => one.name === point.shot);
    const areas = (shot ? shot.crops : []).map(area => ["crop", area]).concat([["largest FLIP", point.worst]]);
    append(host, "h4", "Crops: this point, truth, FLIP");
    for (const [title, area] of areas) {
      const figure = append(host, "figure");
      crops(append(figure, "div", undefined, { class: "triple" }), point, area);
      append(figure, "figcaption", `${title}, ${area[2]}x${area[3]} at ${area[0]},${area[1]}`);
    }
  }

  // ---- words and numbers

  // Parameters of the point, and their changes since the point chosen before.
  function parameters(host, point) {
    const last = explorer.byNumber.get(state.last), differences = last ? explorer.differences(point, last) : [];
    const changed = new Map(differences.map(([name, now, before]) => [name, before]));
    if (last) {
      const words = differences.map(([name, now, before]) => `${name} ${before || "–"} → ${now || "–"}`).join(", ");
      append(host, "p", words ? `Against point ${last.n}: ${words}` : `No parameter differs from point ${last.n}.`,
             { class: "difference", id: "difference" });
    }
    const list = append(host, "dl");
    for (const [name, given] of Object.entries(explorer.parameters(point))) {
      append(list, "dt", name);
      const text = append(list, "dd");
      append(text, changed.has(name) ? "strong" : "span", given);
      if (changed.has(name)) text.append(` (was ${changed.get(name) || "–"})`);
    }
    if (point.limits) append(host, "p", "Limits met: " + point.limits.join("; "), { class: "soft" });
  }

  function deviations(table, point) {
    const row = table.tBodies[0].insertRow();
    row.append(explorer.element("th", "truth ± (RMSE)", { scope: "row",
      title: "standard error of truth; errors closer than two of it are not ranked" }));
    for (const sigma of point.group.sigma) {
      const cell = row.insertCell();
      cell.className = "number faint", cell.textContent = sigma === null ? "–" : "";
      if (sigma === null) continue;
      append(cell, "button", explorer.shown("rmse", sigma), { type: "button", class: "link", title: point.group.truth })
        .onclick = () => document.getElementById("command-truth").scrollIntoView({ block: "nearest" });
    }
  }

  function numbers(host, point) {
    const regional = data.measures.filter(one => one.per_region && one.name in point.v);
    if (regional.length) {
      const table = explorer.table(host, [""].concat(data.regions), [false].concat(data.regions.map(() => true)));
      for (const one of regional) {
        const row = table.tBodies[0].insertRow(), head = explorer.element("th", one.title, { scope: "row", title: one.doc });
        row.append(head);
        for (const region of data.regions) explorer.numberCell(row, point, one.name, region);
      }
      if ((point.group.sigma || []).some(one => one !== null)) deviations(table, point);
    }
    const rest = data.measures.filter(one => !one.per_region && one.name in point.v);
    if (!rest.length) return;
    const table = explorer.table(host, rest.map(one => explorer.measureTitle(one.name, "")), rest.map(() => true));
    const row = table.tBodies[0].insertRow();
    for (const one of rest) explorer.numberCell(row, point, one.name);
  }

  // Times of the passes, ms, with bars relative to the longest pass.
  function passes(host, point) {
    if (!point.passes) return;
    const box = append(host, "details");
    append(box, "summary", "Passes");
    const table = explorer.table(box, ["pass", "ms", "quartiles", ""], [false, true, true, false]);
    const most = Math.max(...point.passes.map(([, ms]) => ms)), text = ms => ms.toPrecision(3);
    for (const [name, ms, low, high] of point.passes) {
      const row = table.tBodies[0].insertRow();
      append(row, "th", name, { scope: "row" });
      append(row, "td", text(ms), { class: "number" });
      append(row, "td", `${text(low)} to ${text(high)}`, { class: "number faint" });
      const bar = append(append(row, "td"), "div", undefined, { class: "share" });
      bar.style.width = 6 * ms / most + "rem";
    }
  }

  function copyable(host, title, text, id) {
    const head = append(host, "div", undefined, { class: "command" });
    append(head, "span", title, { class: "soft" });
    const button = append(head, "button", "copy", { type: "button", "aria-label": "copy: " + title });
    const code = append(host, "pre", undefined, { tabindex: "0", id });
    append(code, "code", text);
    button.onclick = () => {
      const done = () => { button.textContent = "copied"; };
      const byHand = () => {
        getSelection().selectAllChildren(code);
        document.execCommand("copy");
        done();
      };
      if (navigator.clipboard) navigator.clipboard.writeText(text).then(done, byHand); else byHand();
    };
  }

  function commands(host, point) {
    append(host, "h4", "Commands");
    const quoted = state.quoted && state.quoted.n === point.n ? state.quoted : null;
    if (quoted) {
      const number = explorer.shown(quoted.name, value(point, quoted.name, quoted.region));
      append(host, "p", `${explorer.measureTitle(quoted.name, quoted.region)}: ${number}, made again by the first.`,
             { class: "finding", id: "quoted" });
    }
    if (point.sweep) copyable(host, "the numbers of this point", point.sweep, "command-numbers");
    if (point.command) copyable(host, "its picture", point.command, "command-picture");
    if (point.group.truth) copyable(host, "truth", point.group.truth, "command-truth");
  }

  function notes(host, point) {
    const label = append(host, "label", undefined, { class: "notes" });
    append(label, "span", "Notes on this point, kept by this browser");
    const text = append(label, "textarea", undefined, { rows: 3, id: "note", placeholder: "what is seen here" });
    text.value = explorer.note(point);
    text.oninput = () => { explorer.setNote(point, text.value); explorer.drawPins(); };
  }

  function drawPoint(host) {
    host.textContent = "";
    const point = explorer.byNumber.get(state.selected);
    if (!point) return void append(host, "p", "Choose a point in a chart or in the table to see its picture, crops, FLIP map " +
      "and numbers.", { class: "soft" });
    const head = append(host, "div", undefined, { class: "point-head" });
    append(head, "h3", `Point ${point.n}: ${point.arm}`);
    const button = (text, said, work, pressed) => {
      const made = append(head, "button", text, { type: "button", "aria-label": said });
      if (pressed !== undefined) made.setAttribute("aria-pressed", pressed);
      made.onclick = work;
      return made;
    };
    button("◀", "the point before (left arrow)", () => explorer.step(-1));
    button("▶", "the next point (right arrow)", () => explorer.step(1));
    button("pin", "pin this point (p)", () => explorer.pin(point.n), state.pins.includes(point.n)).id = "pin";
    parameters(host, point);
    stage(host, point);
    allCrops(host, point);
    append(host, "h4", "Numbers");
    numbers(host, point);
    passes(host, point);
    commands(host, point);
    notes(host, point);
  }

  // ---- pinned points

  function save(name, text, type) {
    const link = explorer.element("a", undefined, { download: name, href: URL.createObjectURL(new Blob([text], { type })) });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  // The crop with the largest FLIP of the first pinned point of the shot, so that thumbnails show differences.
  function thumbnail(host, point) {
    if (point.picture === undefined) return;
    const first = state.pins.map(n => explorer.byNumber.get(n)).find(one => one.shot === point.shot && one.worst);
    drawn(host, point.picture, first && first.worst, `point ${point.n}` + (first ? `, largest FLIP of point ${first.n}` : ""));
  }

  function drawPins() {
    const host = document.getElementById("pins");
    host.textContent = "";
    append(host, "h3", `Pinned points and notes`);
    const row = append(host, "div", undefined, { class: "row" });
    if (!state.pins.length) append(row, "span", "none is pinned", { class: "soft" });
    for (const n of state.pins) {
      const point = explorer.byNumber.get(n), box = append(row, "span", undefined, { class: "pinned-one" });
      const button = explorer.pointButton(box, point, "");
      thumbnail(button, point);
      append(button, "span", `${n}: ${explorer.describe(point)}`);
      button.setAttribute("aria-current", n === state.selected);
      append(box, "button", "×", { type: "button", "aria-label": `unpin point ${n}` }).onclick = () => explorer.pin(n);
    }
    const bar = append(host, "div", undefined, { class: "bar" });
    const count = explorer.noted().length;
    append(bar, "span", count ? `${count} point${count === 1 ? " has" : "s have"} notes` : "no notes", { class: "soft" });
    append(bar, "button", "export notes as Markdown", { type: "button", id: "notes-markdown" }).onclick =
      () => save("notes.md", explorer.notesMarkdown(), "text/markdown");
    append(bar, "button", "export notes as JSON", { type: "button", id: "notes-json" }).onclick =
      () => save("notes.json", explorer.notesJson(), "application/json");
  }

  Object.assign(explorer, { crops, prepare, drawPoint, drawPins });
})();
