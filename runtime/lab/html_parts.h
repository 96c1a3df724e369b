// SPDX-License-Identifier: MIT
// Style and behaviour of the page of html.h. Without the script the page still shows every picture and table.
#pragma once

namespace strobe::lab {

inline constexpr const char* kPageStyle = R"css(
:root { color-scheme: light dark; --paper: #fff; --ink: #1b1c20; --soft: #5d6068; --rule: #d9dbe0; --panel: #f4f5f7;
  --accent: #0b63ce; --best: #e3f3e6; }
@media (prefers-color-scheme: dark) { :root { --paper: #15161a; --ink: #e9eaee; --soft: #a3a6b0; --rule: #353841;
  --panel: #1f2127; --accent: #7ab5ff; --best: #1d3626; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1500px; padding: 1.5rem clamp(1rem, 3vw, 2.5rem) 4rem; background: var(--paper);
  color: var(--ink); font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 2rem; line-height: 1.2; margin: .5rem 0; } h2 { font-size: 1.45rem; margin: 2.6rem 0 .2rem; }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; } p { margin: .3rem 0; max-width: 90ch; } .soft { color: var(--soft); }
.viewer { margin: 1rem 0; border: 1px solid var(--rule); border-radius: 10px; overflow: hidden; background: var(--panel); }
.bar { display: flex; flex-wrap: wrap; gap: .4rem; align-items: center; padding: .6rem .8rem; }
.bar .space { flex: 1; }
button { font: inherit; font-size: .92rem; padding: .25rem .8rem; border: 1px solid var(--rule); border-radius: 99px;
  background: var(--paper); color: var(--ink); cursor: pointer; }
button:hover { border-color: var(--accent); } button[aria-pressed=true] { background: var(--accent); border-color: var(--accent); color: var(--paper); }
.stage { position: relative; cursor: ew-resize; touch-action: pan-y; background: #000; line-height: 0; }
.stage img { width: 100%; height: auto; display: block; } .stage .method { position: absolute; inset: 0; height: 100%; }
.stage .edge { position: absolute; top: 0; bottom: 0; width: 2px; margin-left: -1px; background: #fff; mix-blend-mode: difference; pointer-events: none; }
.stage .tag { position: absolute; bottom: .6rem; line-height: 1.3; font-size: .85rem; padding: .15rem .6rem; color: #fff; background: #000a; border-radius: 4px; pointer-events: none; }
.tag.left { left: .6rem; } .tag.right { right: .6rem; }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 24rem), 1fr)); gap: .8rem; margin: .4rem 0 1rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; display: block; border-radius: 4px; } figcaption { font-size: .85rem; color: var(--soft); margin-top: .15rem; }
.crop img { image-rendering: pixelated; }
.reference { display: grid; place-items: center; aspect-ratio: 16/9; background: var(--panel); border-radius: 4px; color: var(--soft); }
.scroll { overflow-x: auto; } table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; margin: .3rem 0 .6rem; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--rule); text-align: right; white-space: nowrap; }
th { font-weight: 600; vertical-align: bottom; } th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: var(--paper); }
tr.aside td { color: var(--soft); } td.best { background: var(--best); font-weight: 600; }
footer { margin-top: 3rem; border-top: 1px solid var(--rule); padding-top: .8rem; font-size: .9rem; color: var(--soft); }
.verdict { border-left: 4px solid var(--accent); padding-left: .8rem; margin: .6rem 0; }
html:not(.live) .viewer { display: none; }
@media print { :root { color-scheme: light; --paper: #fff; --ink: #000; --soft: #444; --rule: #bbb; --panel: #f4f4f4; --best: #e8f3ea; }
  body { max-width: none; padding: 0; font-size: 10pt; } .viewer { display: none; } .grid { grid-template-columns: repeat(3, 1fr); }
  table { font-size: 7.5pt; } th, td { padding: 2pt 4pt; white-space: normal; } figure, table, h2, h3 { break-inside: avoid; } h2, h3 { break-after: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
)css";

inline constexpr const char* kPageScript = R"js(
document.documentElement.classList.add("live");
for (const viewer of document.querySelectorAll(".viewer")) {
  const part = name => viewer.querySelector(name);
  const stage = part(".stage"), method = part(".method"), truth = part(".truth"), edge = part(".edge");
  const source = id => document.getElementById(id).src;
  let at = 0.5, timer = 0;
  const show = () => {
    method.style.clipPath = `inset(0 ${100 - 100 * at}% 0 0)`;
    edge.style.left = 100 * at + "%";
  };
  const choose = button => {
    for (const one of viewer.querySelectorAll("[data-picture]")) one.setAttribute("aria-pressed", one === button);
    method.src = source(button.dataset.picture);
    part(".tag.left").textContent = button.textContent;
  };
  const flicker = on => {
    clearInterval(timer);
    timer = 0;
    edge.hidden = on;
    part(".flicker").setAttribute("aria-pressed", on);
    if (on) timer = setInterval(() => { at = at === 1 ? 0 : 1; show(); }, 500);
    else { at = 0.5; show(); }
  };
  truth.src = source(viewer.dataset.truth);
  for (const button of viewer.querySelectorAll("[data-picture]")) button.onclick = () => choose(button);
  part(".flicker").onclick = () => flicker(!timer);
  stage.onpointermove = event => {
    if (timer) return;
    const box = stage.getBoundingClientRect();
    at = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
    show();
  };
  choose(part("[data-chosen]"));
  show();
}
)js";

}  // namespace strobe::lab
