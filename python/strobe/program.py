# SPDX-License-Identifier: MIT
"""The program `strobe`: its place, its options, and one process that keeps the device from call to call."""
from __future__ import annotations

import atexit
import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import warnings
from pathlib import Path
from typing import Any, Iterator


class StrobeError(RuntimeError):
    """Failure of the program, with its message.

    exit_code: 1 for a failure, 2 for a wrong argument, as on the command line. None: the program ended early.
    """

    def __init__(self, message: str, exit_code: int | None = None) -> None:
        super().__init__(message)
        self.exit_code = exit_code


class StrobeWarning(UserWarning):
    """Warning of the program, such as a limit that a picture met."""


def program() -> str:
    """Path of the program: STROBE_PROGRAM, else `strobe` on the PATH, else build/strobe of the repository."""
    built = Path(__file__).resolve().parents[2] / "build" / "strobe"
    found = os.environ.get("STROBE_PROGRAM") or shutil.which("strobe") or (str(built) if built.exists() else None)
    if not found:
        raise StrobeError("the program 'strobe' is not on the PATH; STROBE_PROGRAM names it")
    return found


def _text(value: Any) -> str:
    """Value as on a command line: (320, 180) is "320,180"; True is "true"."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (tuple, list)):
        return ",".join(_text(one) for one in value)
    return str(value)


def words_of(options: dict[str, Any]) -> Iterator[str]:
    """Options of a command line: size=(320, 180), exposure=0.5, move={"vase": (0.1, 0, 0)}, tap=["a.b", "c.d"].

    True sets a flag. None and False leave the option out. A list or a dict gives an option several times.
    """
    for name, value in options.items():
        word = "--" + name.replace("_", "-")
        if value is None or isinstance(value, bool):
            yield from [word] if value else []
            continue
        if name == "size" and isinstance(value, tuple):
            value = "x".join(map(str, value))
        if isinstance(value, dict):
            value = [f"{key}={_text(one)}" for key, one in value.items()]
        for one in value if isinstance(value, list) else [value]:
            yield f"{word}={_text(one)}"


def _message(text: str) -> str:
    """Message of a failure: the text after the last "strobe: " at the beginning of a line."""
    return ("\n" + text).rpartition("\nstrobe: ")[2].strip()


class _Server:
    """A running `strobe serve`, with the process, folder and variables that it was started with."""

    def __init__(self) -> None:
        self.context = _context()
        self._errors = tempfile.TemporaryFile()
        self._read = 0
        self._process = subprocess.Popen([program(), "serve"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                         stderr=self._errors, start_new_session=True)

    def ask(self, words: list[str]) -> Any:
        """Result of a command. Raises StrobeError with the message of a failure."""
        line = b""
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.write(json.dumps({"command": words}).encode() + b"\n")
            self._process.stdin.flush()
            line = self._process.stdout.readline()
        text = self._new_errors()
        if not line:
            status = self._process.wait()
            raise StrobeError(_message(text) or f"the program ended early (exit status {status})")
        for one in text.splitlines():
            if one.startswith("warning: "):
                warnings.warn(one.removeprefix("warning: "), StrobeWarning, stacklevel=4)
        answer = json.loads(line)
        if answer["exit"]:
            raise StrobeError(answer["error"], answer["exit"])
        return answer["result"]

    def is_usable(self) -> bool:
        """True if the program runs, and would read the same files if it were started now."""
        return self.context == _context() and self._process.poll() is None

    def end(self, wait_s: float) -> None:
        """Ends the program; kills it after `wait_s` seconds. Does nothing in a fork of this process."""
        if self.context[0] != os.getpid():
            return
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.close()
        try:
            self._process.wait(wait_s)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._process.stdout.close()
        self._errors.close()

    def _new_errors(self) -> str:
        """Text on standard error since the last call."""
        data = os.pread(self._errors.fileno(), 1 << 20, self._read)
        self._read += len(data)
        return data.decode(errors="replace")


def _context() -> tuple[Any, ...]:
    return os.getpid(), os.getcwd(), {name: text for name, text in os.environ.items() if name.startswith("STROBE_")}


_server: _Server | None = None
_lock = threading.Lock()


def call(*words: str) -> Any:
    """Result of a command, JSON or text. Starts the program at the first call, and again after its end."""
    global _server
    with _lock:
        if _server and not _server.is_usable():
            end()
        _server = _server or _Server()
        try:
            return _server.ask(list(words))
        except StrobeError:
            raise
        except BaseException:  # an interruption: the next command would get the answer of this one
            end(wait_s=0)
            raise


@atexit.register
def end(wait_s: float = 5) -> None:
    """Ends the program and frees its device. The next call starts it again."""
    global _server
    if _server:
        _server.end(wait_s)
    _server = None


def run(*words: str) -> None:
    """Runs a command in a process of its own and shows its progress on standard error."""
    with subprocess.Popen([program(), *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          errors="replace") as process:
        lines = []
        try:
            for line in process.stderr:
                lines.append(line)
                if not line.startswith("strobe: "):
                    print(line, end="", file=sys.stderr, flush=True)
        except BaseException:  # the command keeps its finished work
            process.send_signal(signal.SIGINT)
            raise
    if process.returncode:
        raise StrobeError(_message("".join(lines)), process.returncode)
