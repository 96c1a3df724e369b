#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Uses FOLDER/report.html like a user, for report_page_test.cpp: prints problems and the number of checks."""
import csv
import json
import sys
import time

import browser

folder = sys.argv[1]
checks, wrong = 0, []


def expect(what, found, wanted=True):
    global checks
    checks += 1
    if found != wanted:
        wrong.append(f"{what}: {found!r} instead of {wanted!r}")


with open(folder + "/table.csv", newline="") as stream:
    rows = list(csv.DictReader(stream))


def front(x, y, region, shot, higher=()):
    """Numbers of the undominated points, computed from the table."""
    costs = []
    for row in rows:
        if row["region"] == region and row["shot"] == shot and row[x] and row[y]:
            costs.append((int(row["point"]), *(float(row[name]) * (-1 if name in higher else 1) for name in (x, y))))
    return sorted(one[0] for one in costs if not any(
        o[1] <= one[1] and o[2] <= one[2] and o[1:] != one[1:] for o in costs))


def numbers(page, selector):
    return page.run(f"[...document.querySelectorAll({json.dumps(selector)})].map(one => Number(one.dataset.point))")


def text(page, selector):
    return page.run(f"(document.querySelector({json.dumps(selector)}) || {{}}).textContent")


def eventually(page, what, script, wanted=True):
    """Checks that wait for pictures and files."""
    until = time.monotonic() + 20
    while page.run(script) != wanted and time.monotonic() < until:
        time.sleep(0.05)
    expect(what, page.run(script), wanted)


def tab(page, name):
    page.click("#tab-" + name)
    expect("tab " + name, page.run(f"document.getElementById('view-{name}').hidden"), False)


def fronts(page):
    for x, y, region, shot in (("ms", "rmse", "inner", "near"), ("ms", "psnr", "whole", "far"), ("flip", "rmse", "whole", "near")):
        page.go(f"file://{folder}/report.html#x={x}&y={y}&region={region}&shot={shot}")
        expect(f"front of {y} against {x}", sorted(numbers(page, "#front-points tr[data-point]")),
               front(x, y, region, shot, higher=("psnr",)))
    page.go(f"file://{folder}/report.html#x=axis.samples")
    expect("against an axis", len(numbers(page, "#view-front .mark")), 22)
    expect("an axis has no front", numbers(page, "#front-points tr[data-point]"), [])
    page.go(f"file://{folder}/report.html")


def points(page):
    """Points are chosen in the chart, pinned and stepped through; the page shows the parameters that differ from the last point."""
    expect("marks", len(numbers(page, "#view-front .mark")), 22)
    page.click('#view-front .mark[data-point="9"] .shape')
    expect("chosen", text(page, "#point h3"), "Point 9: third")
    page.click("#pin")
    page.key("ArrowRight")
    expect("stepped through what is shown", text(page, "#point h3"), "Point 10: first")
    expect("difference", text(page, "#difference"), "Against point 9: arm third → first, tile 10 → 20")
    page.run("explorer.select(14)")
    page.key("p")
    expect("address", page.run("location.hash"), "#point=14&last=10&pins=9.14")
    page.key("ArrowRight")
    expect("stepped to the first pinned", text(page, "#point h3"), "Point 9: third")
    page.key("ArrowLeft")
    expect("and back", text(page, "#point h3"), "Point 14: second <b>")
    expect("difference of the pinned", text(page, "#difference"), "Against point 9: arm third → second <b>, samples 4 → 8")
    expect("pins", page.run("document.querySelectorAll('.pinned-one').length"), 2)
    page.run("document.querySelector('#tab-front').focus()")
    page.key("ArrowRight")
    expect("keys of the tabs are theirs", page.run("explorer.state.tab"), "table")
    page.key("ArrowLeft")


def wipe(page):
    edge = "document.querySelector('#point .edge').style.left"
    clip = "document.querySelector('#point .other').style.clipPath"
    page.point("#point .stage", 0.25, 0.5)
    expect("wiped", page.run(f"Math.round(parseFloat({edge}))"), 25)
    expect("clipped", page.run(f"Math.round(parseFloat({clip}.split(' ')[1]))"), 75)
    page.click('#point [data-view="flip"]')
    eventually(page, "the FLIP map has the colours of heat",
               "(() => { const c = document.querySelector('#point .stage canvas'); const d = c.getContext('2d').getImageData(0, 0,"
               " c.width, c.height).data; let n = 0; for (let i = 0; i < d.length; i += 4) n += d[i] > d[i + 1] + 20;"
               " return c.width === 64 && n > 100; })()")
    page.click('#point [data-view="wipe"]')
    expect("crops", page.run("document.querySelectorAll('#point .triple canvas').length"), 6)
    expect("every picture has a text", page.run(
        "[...document.querySelectorAll('.explorer img:not([alt]), .explorer canvas:not([aria-label])')].length"), 0)
    eventually(page, "pictures are shown",
               "[...document.querySelectorAll('#point img')].every(one => one.complete && one.naturalWidth === 64)")


def table(page):
    tab(page, "table")
    expect("rows", len(numbers(page, "#points tbody tr")), 24)
    page.click('#points [data-sort="rmse"]')
    wanted = [int(row["point"]) for row in sorted((r for r in rows if r["shot"] == "near" and r["region"] == "inner" and r["rmse"]),
                                                  key=lambda row: float(row["rmse"]))]
    expect("sorted", numbers(page, "#points tbody tr")[:22], wanted)
    page.click('#points [data-sort="rmse"]')
    expect("the other way", numbers(page, "#points tbody tr")[:22], wanted[::-1])
    expect("what has no value comes last", numbers(page, "#points tbody tr")[22:], [4, 5])
    page.click("#filters > summary")
    page.click('#filters [data-filter="arm"][data-level="first"]')
    page.click('#filters [data-filter="samples"][data-level="2"]')
    expect("filtered", len(numbers(page, "#points tbody tr")), 12)
    page.run("const box = document.querySelector('#filters [data-filter=ms][data-end=to]'); box.value = 4; box.onchange();")
    expect("a range", all(float(row["ms"]) <= 4 for row in rows if int(row["point"]) in numbers(page, "#points tbody tr")))
    expect("address of filters", "only.ms=..4" in page.run("location.hash"))
    page.run("document.querySelector('#choose-find').value = 'second 16'; document.querySelector('#choose-find').oninput("
             "{ target: document.querySelector('#choose-find') })")
    expect("found", all("second" in one for one in page.run("[...document.querySelectorAll('#points tbody tr')].map(one => one.textContent)")))
    page.click("#reset")
    expect("all again", len(numbers(page, "#points tbody tr") or numbers(page, "#view-front .mark")), 22)
    tab(page, "table")
    page.run('document.querySelector("#points tr[data-point=\'8\'] td .link").focus()')
    page.key("Enter")
    expect("the focus stays", page.run("document.activeElement.closest('tr').dataset.point"), "8")
    page.click('#points tr[data-point="9"] td.number button')
    expect("its command", text(page, "#command-numbers"),
           "strobe sweep made.lua --only 'arm=third,shot=near,samples=4,tile=10' -o out/again")
    expect("its picture's command", text(page, "#command-picture"), "strobe render third --set samples=4")


def rows_choose(page):
    page.go("about:blank")
    page.go(f"file://{folder}/report.html#tab=table")
    page.click('#points tr[data-point="9"] td:nth-of-type(3)')
    expect("a click in a row chooses its point", page.run("explorer.state.selected"), 9)
    page.click('#points tr[data-point="14"] input')
    expect("a box in it keeps its use", page.run("[explorer.state.selected, explorer.state.pins.join()].join()"), "9,14")
    page.click('#tab-front')
    page.click('#front-points tr[data-point] td:nth-of-type(2)')
    expect("also in the table of the front", page.run("explorer.state.selected"),
           page.run("Number(document.querySelector('#front-points tr[data-point]').dataset.point)"))


def pins_wiped(page):
    """Pinned points are compared with each other, with the crops of the largest errors."""
    page.go("about:blank")
    page.go(f"file://{folder}/report.html#point=9&pins=9.14&against=14")
    tags = "[...document.querySelectorAll('#point .tag')].map(one => one.textContent).join(' | ')"
    under = "explorer.data.pictures.indexOf(document.querySelector('#point .under').getAttribute('src'))"
    expect("against a pinned point", page.run(tags), "9: third | 14: second <b>")
    expect("its picture", page.run(f"{under} === explorer.byNumber.get(14).picture"))
    page.run("(() => { const c = document.querySelector('#choose-against'); c.value = 0; c.onchange(); })()")
    expect("against truth", page.run(tags), "third | truth")
    expect("truth's picture", page.run(f"{under} === explorer.byNumber.get(9).group.picture"))
    expect("address", "against" in page.run("location.hash"), False)
    page.go(f"file://{folder}/report.html#point=9&pins=9&against=14")
    expect("what is not pinned is not wiped against", page.run(tags), "third | truth")
    page.go(f"file://{folder}/report.html#point=9&pins=9.14")
    eventually(page, "thumbnails are crops", "[...document.querySelectorAll('.pinned-one canvas')].map(one => one.width).join()",
               page.run("[9, 9].map(n => explorer.byNumber.get(n).worst[2]).join()"))


def printed_at_load(page):
    """Worst crops of a page that is printed as soon as it has loaded."""
    page.go("about:blank")
    page.go(f"file://{folder}/report.html#at=load")
    dark = ("(() => { dispatchEvent(new Event('beforeprint')); return [...document.querySelectorAll('#view-worst .triple"
            " canvas:first-child')].filter(c => c.getContext('2d').getImageData(0, 0, 1, 1).data[3] === 0).length; })()")
    expect("no crop is empty", page.run(dark), 0)
    expect("crops", page.run("document.querySelectorAll('#view-worst .triple').length"), 12)


def others(page):
    tab(page, "parallel")
    expect("lines", page.run("document.querySelectorAll('#view-parallel .line').length"), 22)
    axis = "#view-parallel .dimension:nth-of-type(5) .overlay"  # arm is the first axis after the lines
    expect("its axis", page.run("[...document.querySelectorAll('#view-parallel .dimension .title')].map(one => one.textContent)[3]"),
           "RMSE, inner")
    page.drag(axis, (0.5, 0.4), (0.5, 1))
    filtered = page.run("explorer.state.filters.rmse")
    expect("dragging filters", page.run("explorer.visible().length"),
           sum(row["shot"] == "near" and row["region"] == "inner" and row["rmse"] != ""
               and filtered["from"] <= float(row["rmse"]) <= filtered["to"] for row in rows))
    expect("some are out", page.run("document.querySelectorAll('#view-parallel .line.out').length > 0"))
    page.click(axis)
    expect("a click shows all again", page.run("explorer.fragment().includes('only')"), False)
    tab(page, "effects")
    expect("effects", page.run("[...new Set([...document.querySelectorAll('#main-effects tr[data-factor]')].map("
                               "one => one.dataset.factor))].join()"), "arm,samples,tile")
    expect("pairs", page.run("document.querySelectorAll('#choose-pair option').length"), 3)
    said = page.run("document.querySelector('#effects ~ p').textContent")
    expect("how to read effects, as on the page without scripts", text(page, "#view-effects p.soft"),
           said + " All points of the shot count, also those that filters hide.")
    tab(page, "worst")
    worst = numbers(page, "#view-worst figure")
    expect("worst crops", len(worst), 12)
    expect("the worst first", worst[0], int(max((r for r in rows if r["shot"] == "near" and r["region"] == "inner" and r["rmse"]),
                                                key=lambda row: float(row["rmse"]))["point"]))


def lines(page):
    """Lines are reached by keyboard: Tab to the first, arrow keys to the next, Enter pins; the focus stays."""
    page.go("about:blank")
    page.go(f"file://{folder}/report.html#tab=parallel&only.samples=2")
    shown = page.run("explorer.sorted(explorer.visible()).map(one => one.n)")
    focused = "document.activeElement.getAttribute('class').split(' ')[0] + Number(document.activeElement.dataset.point)"
    expect("one line is a stop of Tab", page.run("document.querySelectorAll('#view-parallel .line[tabindex=\"0\"]').length"), 1)
    expect("lines that are out are none", page.run("document.querySelectorAll('#view-parallel .line.out[tabindex]').length"), 0)
    page.run("document.querySelector('#tab-parallel').focus()")
    page.key("Tab")
    first = page.run("Number(document.activeElement.dataset.point)")
    expect("Tab reaches a line", first in shown)
    seen = "(() => { const s = getComputedStyle(document.activeElement.querySelector('path')); return s.strokeWidth; })()"
    expect("the focus is seen", page.run(seen), "5px")
    page.key("Enter")
    expect("Enter chooses and pins", page.run("[explorer.state.selected, explorer.state.pins.join()].join()"), f"{first},{first}")
    expect("the focus stays", page.run(focused), f"line{first}")
    page.key("ArrowDown")
    after = shown[(shown.index(first) + 1) % len(shown)]
    expect("the next line", page.run("explorer.state.selected"), after)
    expect("the focus goes along", page.run(focused), f"line{after}")
    expect("and is seen", page.run(seen), "5px")
    page.key("ArrowUp")
    page.key("Enter")
    expect("Enter again takes the pin away", page.run("[explorer.state.selected, explorer.state.pins.join()].join()"), f"{first},")
    page.key("ArrowRight")
    expect("its point is shown", text(page, "#point h3"), page.run(f"`Point {after}: ${{explorer.byNumber.get({after}).arm}}`"))


def notes(page):
    page.run("explorer.select(9)")
    page.run("const note = document.querySelector('#note'); note.value = 'sharp\\nedges'; note.oninput();")
    expect("kept", page.run("JSON.parse(localStorage.getItem('strobe notes of Made </script> up'))['third, Near, samples 4, tile 10']"),
           "sharp\nedges")
    exported = page.run("explorer.notesMarkdown()")
    expect("exported", "## Point 9: third, Near, samples 4, tile 10\n\nsharp\nedges\n\n    strobe render third" in exported)
    expect("as JSON", json.loads(page.run("explorer.notesJson()"))["notes"][0]["note"], "sharp\nedges")
    page.run("window.saved = ''; URL.createObjectURL = blob => { blob.text().then(text => window.saved = text); return 'data:,'; };")
    page.click("#notes-markdown")
    eventually(page, "downloaded", "window.saved", exported)


def address(page):
    """The address restores all choices."""
    page.go("about:blank")
    page.go(f"file://{folder}/report.html#tab=table&shot=far&region=whole&y=flip&sort=-ms&point=30&last=27&pins=27.30&wipe=80"
            "&only.samples=4%7C8&only.ms=..5")
    expect("tab", page.run("document.querySelector('[aria-selected=true]').id"), "tab-table")
    expect("point", text(page, "#point h3"), "Point 30: third")
    expect("wipe", page.run("document.querySelector('#wipe').value"), "80")
    expect("choices", page.run("['shot', 'region', 'x', 'y'].map(one => document.getElementById('choose-' + one).value).join()"),
           "far,whole,ms,flip")
    wanted = sorted((r for r in rows if r["shot"] == "far" and r["region"] == "whole" and r["samples"] in ("4", "8") and float(r["ms"]) <= 5),
                    key=lambda row: -float(row["ms"]))
    expect("rows", numbers(page, "#points tbody tr"), [int(row["point"]) for row in wanted])
    expect("the note of another point", page.run("explorer.note(explorer.byNumber.get(9))"), "sharp\nedges")
    expect("nothing is lost", page.run("explorer.fragment().split('&').sort().join('&')"),
           "last=27&only.ms=..5&only.samples=4%7C8&pins=27.30&point=30&region=whole&shot=far&sort=-ms&tab=table&wipe=80&y=flip")


def nonsense(page):
    """Valid parts of an address from another page, or a truncated one, are used."""
    page.go("about:blank")
    page.go(f"file://{folder}/report.html#tab=no&x=no&shot=no&point=999&last=x&pins=1.999.x&wipe=x&sort=no&only.no=4&only.arm=%&point")
    expect("known ones", page.run("[explorer.state.tab, explorer.state.x, explorer.state.shot, explorer.state.pins.join()].join()"),
           "front,ms,near,1")
    page.click("#reset")
    expect("all there", len(numbers(page, "#view-front .mark")), 22)


# WCAG contrast between the colour and the background of every element with its own text.
CONTRAST = """(() => {
  const channels = text => (text.match(/[\\d.]+/g) || []).map(Number);
  const luminance = rgb => { const [r, g, b] = rgb.map(v => (v /= 255) <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const behind = element => { for (; element; element = element.parentElement) {
    const c = channels(getComputedStyle(element).backgroundColor); if (c.length === 3 || c[3] > 0.5) return c.slice(0, 3); }
    return matchMedia('(prefers-color-scheme: dark)').matches ? [0, 0, 0] : [255, 255, 255]; };
  const bad = [];
  for (const element of document.querySelectorAll('.explorer *')) {
    if (element.closest('svg, .stage, option') || !element.offsetParent) continue;
    if (![...element.childNodes].some(one => one.nodeType === 3 && one.textContent.trim())) continue;
    const a = luminance(channels(getComputedStyle(element).color).slice(0, 3)), b = luminance(behind(element));
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < 4.5) bad.push(element.tagName + '.' + element.className + ' ' + ratio.toFixed(2));
  }
  return bad.slice(0, 5).join('; ');
})()"""


def reachable(page):
    """Tab reaches every kind of control, and the focus is visible."""
    page.go("about:blank")
    page.go(f"file://{folder}/report.html#point=9&pins=9.14")
    page.run("document.activeElement.blur(); scrollTo(0, 0)")
    seen = set()
    while len(seen) < 150 and "notes-json" not in seen:
        page.key("Tab")
        found = page.run("(() => { const e = document.activeElement, s = getComputedStyle(e), r = e.querySelector('.ring');"
                         " return [e.id || e.getAttribute('class') || e.tagName, s.outlineStyle !== 'none' ||"
                         " (!!r && getComputedStyle(r).strokeWidth === '3px')]; })()")
        if found[0] == "BODY":  # focus is back at the start
            break
        seen.add(found[0].split(" ")[0])
        expect("focus of " + found[0], found[1])
    for control in ("choose-shot", "choose-find", "reset", "tab-front", "mark", "link", "pin", "wipe", "note", "notes-json"):
        expect("reached " + control, control in seen)


def contrast(dark):
    with browser.Page(f"file://{folder}/report.html#point=9&pins=9.14", dark=dark) as page:
        for name in ("front", "table", "effects", "worst"):
            tab(page, name)
            expect(f"contrast of {name}, {'dark' if dark else 'light'}", page.run(CONTRAST), "")
        if not dark:
            printed(page)
        wrong.extend(page.problems)


def printed(page):
    """The printed page has every view and no controls."""
    tab(page, "front")
    page.pdf(folder + "/page.pdf")
    page.call("Emulation.setEmulatedMedia", media="print")
    for name in ("front", "table", "effects", "worst"):
        expect("in print " + name, page.run(f"document.querySelector('#view-{name}').offsetHeight > 50"))
    for name in (".controls", ".tabs", ".still"):
        expect("not in print " + name, page.run(f"document.querySelector('.explorer ~ {name}, {name}').offsetHeight"), 0)


def main():
    with browser.Page(f"file://{folder}/report.html") as page:
        expect("what stands still is hidden", page.run("document.querySelector('.still').offsetHeight"), 0)
        for part in (fronts, points, wipe, table, rows_choose, pins_wiped, printed_at_load, others, lines, notes, address, nonsense, reachable):
            part(page)
        wrong.extend(page.problems)
        page.problems.clear()
        page.call("Emulation.setScriptExecutionDisabled", value=True)
        page.go(f"file://{folder}/report.html")
        expect("without scripts what stands still is there", page.run("document.querySelector('.still').offsetHeight > 500"))
        expect("and nothing to click", page.run("document.querySelector('.explorer').offsetHeight"), 0)
        page.call("Emulation.setScriptExecutionDisabled", value=False)
        page.go(f"file://{folder}/still.html")
        expect("a page without a library", page.run("document.querySelectorAll('svg.chart').length"), 2)
        wrong.extend(page.problems)
    for dark in (False, True):
        contrast(dark)
    for one in wrong:
        print("wrong:", one)
    print(f"{checks} checks, " + ("all passed" if not wrong else f"{len(wrong)} wrong"))
    sys.exit(1 if wrong else 0)


main()
