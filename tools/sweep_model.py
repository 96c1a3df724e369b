#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Model of many programs that draw one sweep in a shared folder, on paper and by a discrete-event simulation.

    tools/sweep_model.py                        # 100,000 points on 1,000 workers
    tools/sweep_model.py --draw 1 --workers 200

Each worker starts, then claims, draws and publishes the points of its share. Operations on files go to one server, which
serves them in the order of their arrival. Operations that change a folder (create, rename, remove) are also served one
after another in that folder. The operations are the system calls of `strobe sweep --share`, counted by strace, without the
calls that a client of NFS answers from its cache (docs/labs.md).
"""
import argparse
import heapq
import random
from collections import Counter

# Operations on the shared folder: (number that read or write, number that change the folder, changed folder).
START = [(1190, 0, ""), (20, 8, "workers")]  # copies of scripts and shaders in folders of its own; own state
CLAIM = [(7, 1, "workers")]  # lookups of the point, single and packed, write and close of the claim; its creation
STATE = [(2, 2, "workers")]  # state of the worker for `strobe status`, at most once per second
PUBLISH = [(6, 4, "points"), (2, 1, "workers")]  # picture and numbers, each written and renamed; release of the claim
PACK = [(6, 2, "points")]  # per point: picture and numbers, each opened, read, closed and removed
PER_PACK = 500  # points of an archive
HEARTBEATS = 2 / 5  # per second: state and claim of a worker
OUTLINE = 480  # bytes per point in unfinished.json, which the first worker writes
FILES = 2  # per point: picture and numbers
READ = 1  # operations per point of a report: a part of an archive


def operations(*steps):
    return sum(plain + changes for step in steps for plain, changes, _ in step)


def alone_s(o, *steps):
    """Time of steps on an idle server."""
    changed = sum(count for step in steps for _, count, name in step if name)
    return operations(*steps) * (o.latency + 1 / o.rate) + changed / o.folder_rate


def changes(folder, *steps):
    return sum(count for step in steps for _, count, name in step if name == folder)


def paper(o):
    """Times without queues, and points per second that each part of the system allows."""
    step = STATE if o.draw >= 1 else []
    point = (CLAIM, PUBLISH, PACK, step)
    own_s = o.draw + alone_s(o, *point)
    limits = {
        "the workers": o.workers / own_s,
        "the server": (o.rate - HEARTBEATS * o.workers) / operations(*point),
        "the folder points": o.folder_rate / changes("points", *point),
        "the folder .workers": o.folder_rate / changes("workers", *point),
    }
    start_s = o.workers * operations(START) / o.rate
    outline_s = o.points * OUTLINE / o.bandwidth
    rate = min(limits.values())
    return {
        "claim_ms": 1e3 * alone_s(o, CLAIM),
        "publish_ms": 1e3 * alone_s(o, PUBLISH),
        "rate": rate,
        "limits": limits,
        "start_s": start_s,
        "outline_s": outline_s,
        "total_s": max(start_s, outline_s) + o.points / rate,
    }


class Server:
    """Queues of the file server: one for all operations, one for the changes of each folder."""

    def __init__(self, o):
        self.latency, self.service, self.change = o.latency, 1 / (o.rate - HEARTBEATS * o.workers), 1 / o.folder_rate
        self.free, self.folder_free = 0.0, Counter()

    def serve(self, now, folder):
        self.free = max(self.free, now + self.latency / 2) + self.service
        end = self.free
        if folder:
            self.folder_free[folder] = end = max(self.folder_free[folder], end) + self.change
        return end + self.latency / 2


def worker(o, draw_times, spent):
    """Yields a time to wait, or the folder of one operation ("" if the operation does not change it)."""
    def perform(step, name):
        begin = yield None
        for plain, changed, folder in step:
            for i in range(plain + changed):
                yield folder * (i < changed)
        end = yield None
        spent[name].append((begin, end - begin))

    waiting = 0  # points that are not in an archive yet
    yield from perform(START, "start")
    for draw_s in draw_times:
        yield from perform(CLAIM, "claim")
        if o.draw >= 1:
            yield from perform(STATE, "state")
        yield draw_s
        yield from perform(PUBLISH, "publish")
        waiting += 1
        if waiting == PER_PACK:
            yield from perform(PACK * waiting, "pack")
            waiting = 0
    yield from perform(PACK * waiting, "pack")


def simulate(o):
    """Times of all steps, and the points per second after the start."""
    chance, server, spent = random.Random(1), Server(o), {name: [] for name in ("start", "claim", "state", "publish", "pack")}
    each = [o.points // o.workers + (i < o.points % o.workers) for i in range(o.workers)]
    events, now = [], 0.0
    for i, count in enumerate(each):
        process = worker(o, (chance.uniform(0.5, 1.5) * o.draw for _ in range(count)), spent)
        # Slurm starts tasks one after another.
        heapq.heappush(events, (i * o.stagger, i, process, next(process)))
    while events:
        now, i, process, wish = heapq.heappop(events)
        try:
            while wish is None:
                wish = process.send(now)
            then = now + wish if isinstance(wish, float) else server.serve(now, wish)
            heapq.heappush(events, (then, i, process, process.send(None)))
        except StopIteration:
            pass
    return spent, now


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add = lambda name, value, text: parser.add_argument(name, type=type(value), default=value, help=f"{text} ({value})")
    add("--points", 100_000, "points")
    add("--workers", 1000, "workers")
    add("--draw", 10.0, "mean time to draw and measure a point, s")
    add("--latency", 0.0002, "round trip of an operation, s")
    add("--rate", 20_000.0, "operations per second of the server")
    add("--folder-rate", 5_000.0, "changes per second of one folder")
    add("--bandwidth", 1e9, "bytes per second of the server")
    add("--stagger", 0.1, "time between the starts of two workers, s")
    o = parser.parse_args()
    on_paper = paper(o)
    spent, end = simulate(o)
    started = max(begin + duration for begin, duration in spent["start"])
    ms = lambda name: sorted(1e3 * duration for begin, duration in spent[name] if begin >= started) or [float("nan")]
    print(f"start of a worker: {sum(duration for _, duration in spent['start']) / o.workers:.1f} s simulated; "
          f"all starts: {on_paper['start_s']:.0f} s of the server; the outline: {on_paper['outline_s']:.2g} s")
    for name in ("claim", "publish"):
        times = ms(name)
        print(f"{name}: {on_paper[name + '_ms']:.1f} ms on paper; after all starts {sum(times) / len(times):.1f} ms "
              f"simulated, 99 % within {times[int(0.99 * len(times))]:.1f} ms")
    for name, rate in sorted(on_paper["limits"].items(), key=lambda one: one[1]):
        print(f"limit of {name}: {rate:.0f} points per second")
    most = o.workers * FILES * min(PER_PACK, -(-o.points // o.workers))
    archives = o.workers * -(-o.points // (o.workers * PER_PACK))
    print(f"single files: {FILES * o.points} without archives, at most {most} with; archives: {archives}")
    print(f"a report reads them in {READ * o.points * (o.latency + 1 / o.rate):.0f} s")
    print(f"whole sweep: {on_paper['total_s']:.0f} s on paper, {end:.0f} s simulated")


if __name__ == "__main__":
    main()
