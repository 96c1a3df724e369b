// Connects the parts of the page: controls, tabs, keys, address, print.
(function () {
  "use strict";
  const { data, state } = explorer;
  const part = id => document.getElementById(id);
  const tabs = { front: explorer.drawFront, table: explorer.drawTable, parallel: explorer.drawParallel,
                 effects: explorer.drawEffects, worst: explorer.drawWorst };

  // ---- controls

  const choices = ["shot", "region", "x", "y", "logx", "logy"];
  function fill() {
    if (data.shots.length > 1) part("choose-shot").add(new Option("all shots", ""));
    for (const one of data.shots) part("choose-shot").add(new Option(one.title, one.name));
    for (const one of data.regions) part("choose-region").add(new Option(one));
    for (const one of explorer.measures.values())
      for (const id of one.is_axis ? ["choose-x"] : ["choose-x", "choose-y"])
        part(id).add(new Option(explorer.measureTitle(one.name), one.name));
    for (const id of ["choose-x", "choose-y"])
      for (const option of part(id).options) option.title = explorer.measures.get(option.value).doc;
    for (const name of choices)
      part("choose-" + name).onchange = event => { state[name] = event.target.value; explorer.changed(); };
    part("choose-find").oninput = event => { state.find = event.target.value; explorer.changed(); };
    part("reset").onclick = () => { explorer.takeFragment(""); explorer.changed(); };
    for (const tab of Object.keys(tabs)) part("tab-" + tab).onclick = () => { state.tab = tab; explorer.changed(); };
    document.querySelector(".explorer .tabs").onkeydown = event => {
      const names = Object.keys(tabs), by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!by) return;
      event.preventDefault(), event.stopPropagation();
      state.tab = names[(names.indexOf(state.tab) + by + names.length) % names.length];
      explorer.changed();
      part("tab-" + state.tab).focus();
    };
  }

  function showControls() {
    for (const name of choices) part("choose-" + name).value = state[name];
    if (document.activeElement !== part("choose-find")) part("choose-find").value = state.find;
    for (const tab of Object.keys(tabs)) {
      part("tab-" + tab).setAttribute("aria-selected", tab === state.tab);
      part("tab-" + tab).tabIndex = tab === state.tab ? 0 : -1;
      part("view-" + tab).hidden = tab !== state.tab;
    }
    explorer.drawFilters(part("filter-list"));
    const count = Object.keys(state.filters).length;
    document.querySelector("#filters > summary").textContent = count ? `Filters (${count})` : "Filters";
    const shown = explorer.visible().length, all = explorer.points.length;
    part("explorer-status").textContent = [`${shown} of ${all} points are shown`].concat(data.notices).join("; ") + ".";
  }

  // ---- drawing

  // `placeOf` returns a function that finds the focused element again after redrawing. For a mark or line: the mark or
  // line of the chosen point, otherwise the Tab stop of the chart. For other elements: the element with the same id, or
  // with the same index among the focusable elements of the nearest ancestor with an id.
  const reachable = host => [...host.querySelectorAll("a, button, input, select, textarea, summary, [tabindex]")];
  function placeOf(element) {
    if (!element || !element.closest(".explorer")) return () => null;
    const kind = [".mark", ".line"].find(one => element.closest(one));
    if (kind) return () => document.querySelector(`${kind}[data-point="${state.selected}"]`) ||
      document.querySelector(kind + "[tabindex='0']");
    if (element.id) return () => part(element.id);
    const host = element.parentElement.closest("[id]"), at = reachable(host).indexOf(element);
    return () => part(host.id) && reachable(part(host.id))[at];
  }

  function keepingFocus(work) {
    const again = placeOf(document.activeElement);
    work();
    const same = again();
    if (same && same !== document.activeElement) same.focus({ preventScroll: true });
  }

  explorer.remember = () => {
    const text = explorer.fragment();
    if (text !== location.hash.replace(/^#/, "")) history.replaceState(null, "", text ? "#" + text : location.pathname);
  };

  let preparing = 0;
  explorer.changed = () => keepingFocus(() => {
    showControls();
    tabs[state.tab](part("view-" + state.tab));
    explorer.drawPoint(part("point"));
    explorer.drawPins();
    explorer.remember();
    const point = explorer.byNumber.get(state.selected);
    clearTimeout(preparing);
    preparing = setTimeout(explorer.prepareWorst, 300);
    part("explorer-said").textContent = point ? `Point ${point.n}: ${explorer.describe(point)}` : "";
  });

  explorer.select = n => {
    if (n !== state.selected) state.last = state.selected;
    state.selected = n;
    explorer.changed();
  };

  explorer.quote = (point, name, region) => {
    state.quoted = { n: point.n, name, region };
    explorer.select(point.n);
    (part("command-numbers") || part("command-picture"))?.scrollIntoView({ block: "nearest" });
  };

  explorer.pin = n => {
    state.pins = state.pins.includes(n) ? state.pins.filter(one => one !== n) : state.pins.concat(n);
    explorer.changed();
  };

  // Steps through the pinned points (through all shown points if fewer than two are pinned), cyclically.
  explorer.step = by => {
    const list = state.pins.length > 1 ? state.pins : explorer.sorted(explorer.visible()).map(point => point.n);
    if (!list.length) return;
    const at = list.indexOf(state.selected);
    explorer.select(list[at < 0 ? (by > 0 ? 0 : list.length - 1) : (at + by + list.length) % list.length]);
  };

  // ---- keys, address, print

  document.addEventListener("keydown", event => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const own = "input:not([type=checkbox]), select, textarea, .comparison";  // elements with their own use of keys
    if (event.target.closest(own) || event.target.matches("pre, .scroll")) return;
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const inside = event.target.closest(".explorer") || event.target === document.body;
    if (by && inside && (event.key === "ArrowRight" || event.key === "ArrowLeft" || event.target.closest(".mark, .line"))) {
      event.preventDefault();
      explorer.step(by);
    } else if (event.key === "p" && inside && state.selected) explorer.pin(state.selected);
  });
  addEventListener("hashchange", () => { if (explorer.takeFragment(location.hash)) explorer.changed(); });
  addEventListener("beforeprint", () => { for (const [tab, draw] of Object.entries(tabs)) draw(part("view-" + tab)); });

  fill();
  explorer.takeFragment(location.hash) || explorer.takeFragment("");
  explorer.changed();
  explorer.prepareWorst();  // now, so that the event `load` waits for the pictures to print
  document.documentElement.classList.add("explores");
})();
